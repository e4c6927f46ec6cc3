// The kernels compiled for Target::kNeon, which every 64-bit Arm runs.
#include "library/kernels/kernel_table.h"
#include "library/kernels/kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const KernelTable kNeonKernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::library::kernels
