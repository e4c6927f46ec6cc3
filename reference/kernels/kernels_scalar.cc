// The kernels compiled for Target::kScalar: flags in reference/CMakeLists.txt.
#define HWY_COMPILE_ONLY_SCALAR
#include "reference/kernels/kernel_table.h"
#include "reference/kernels/kernels.h"
#include "reference/kernels/vectors.h"

namespace rasterproof::reference::kernels {

const KernelTable kScalarKernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::reference::kernels
