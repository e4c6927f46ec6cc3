// The rivals compiled for Target::kScalar: flags in library/rivals/CMakeLists.txt.
#define HWY_COMPILE_ONLY_SCALAR
#include "library/kernels/vectors.h"
#include "library/rivals/rival_table.h"
#include "library/rivals/rivals.h"

namespace rasterproof::library::rivals {

const RivalTable kScalarRivals = kernels::HWY_NAMESPACE::kRivalKernels;

}  // namespace rasterproof::library::rivals
