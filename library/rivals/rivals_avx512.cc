// The rivals compiled for Target::kAvx512: flags in library/rivals/CMakeLists.txt.
#include "library/kernels/vectors.h"
#include "library/rivals/rival_table.h"
#include "library/rivals/rivals.h"

namespace rasterproof::library::rivals {

const RivalTable kAvx512Rivals = kernels::HWY_NAMESPACE::kRivalKernels;

}  // namespace rasterproof::library::rivals
