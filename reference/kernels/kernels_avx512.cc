// The kernels compiled for Target::kAvx512: flags in reference/CMakeLists.txt.
#include "reference/kernels/kernel_table.h"
#include "reference/kernels/kernels.h"
#include "reference/kernels/vectors.h"

namespace rasterproof::reference::kernels {

const KernelTable kAvx512Kernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::reference::kernels
