// The kernels compiled for Target::kScalar: flags in library/CMakeLists.txt.
#define HWY_COMPILE_ONLY_SCALAR
#include "library/kernels/kernel_table.h"
#include "library/kernels/kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const KernelTable kScalarKernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::library::kernels
