// How far a card's approximate reciprocal is from the rounded one, for every float32 in [1, 2).
// nvcc -o reciprocal reciprocal.cu && ./reciprocal
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr std::uint32_t kCount = 1U << 23;

float At(std::uint32_t mantissa) {
  const std::uint32_t bits = 0x3f800000U | mantissa;
  float w = 0;
  std::memcpy(&w, &bits, sizeof w);
  return w;
}

}  // namespace

__global__ void Reciprocals(float* out) {
  const std::uint32_t m = blockIdx.x * blockDim.x + threadIdx.x;
  float r = 0;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(__uint_as_float(0x3f800000U | m)));
  out[m] = r;
}

int main() {
  float* device = nullptr;
  cudaMalloc(&device, kCount * sizeof(float));
  Reciprocals<<<kCount / 256, 256>>>(device);
  std::vector<float> r(kCount);
  if (cudaMemcpy(r.data(), device, kCount * sizeof(float), cudaMemcpyDeviceToHost) != cudaSuccess) {
    std::puts("CUDA failed");
    return 1;
  }
  std::uint32_t differ = 0;
  double least = 0, most = 0;
  for (std::uint32_t m = 0; m < kCount; ++m) {
    differ += r[m] != 1.0F / At(m) ? 1 : 0;
    const double unit = m == 0 ? 0x1p-23 : 0x1p-24;
    const double error = (double{r[m]} - 1 / double{At(m)}) / unit;
    least = std::fmin(least, error);
    most = std::fmax(most, error);
  }
  std::printf("%u of %u are not correctly rounded; error %.3f to %.3f units in the last place\n",
              differ, kCount, least, most);
  std::printf("2 * 1/(255/128): %a, rounded %a\n", double{r[0x7f0000]}, double{1.0F / At(0x7f0000)});
  return 0;
}
