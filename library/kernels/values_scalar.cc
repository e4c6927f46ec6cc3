// The values of rows compiled for Target::kScalar: flags in library/CMakeLists.txt.
#define HWY_COMPILE_ONLY_SCALAR
#include "library/kernels/value_spans.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const ValueTable kScalarValues = HWY_NAMESPACE::kValues;

}  // namespace rasterproof::library::kernels
