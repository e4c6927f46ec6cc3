// The kernels compiled for Target::kAvx2: flags in library/CMakeLists.txt.
#include "library/kernels/kernel_table.h"
#include "library/kernels/kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const KernelTable kAvx2Kernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::library::kernels
