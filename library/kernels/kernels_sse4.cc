// The kernels compiled for Target::kSse4: flags in library/CMakeLists.txt.
#include "library/kernels/kernel_table.h"
#include "library/kernels/kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels {

const KernelTable kSse4Kernels = HWY_NAMESPACE::kKernels;

}  // namespace rasterproof::library::kernels
