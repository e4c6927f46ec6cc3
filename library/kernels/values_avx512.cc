// The values of rows compiled for Target::kAvx512: flags in library/CMakeLists.txt.
#include "library/kernels/value_spans.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const ValueTable kAvx512Values = HWY_NAMESPACE::kValues;

}  // namespace rasterproof::library::kernels
