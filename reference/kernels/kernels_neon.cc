// The kernels compiled for Target::kNeon, which every 64-bit Arm runs.
#include "reference/kernels/kernel_table.h"
#include "reference/kernels/kernels.h"
#include "reference/kernels/vectors.h"

namespace rasterproof::reference::kernels {

const KernelTable kNeonKernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::reference::kernels
