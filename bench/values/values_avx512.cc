// The methods of values compiled for Target::kAvx512: flags in bench/CMakeLists.txt.
#include "bench/values/value_frame.h"
#include "bench/values/value_kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::bench {

namespace simd = library::kernels::HWY_NAMESPACE;

const ValueKernels kAvx512ValueKernels = {"avx512", &simd::StoreOne, simd::kValueKernels,
                                          simd::kValueKernelCount};

}  // namespace rasterproof::bench
