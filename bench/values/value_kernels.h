// The methods of reference/value_methods.h as a competent author would write them: pixels along the
// lanes, what is one number a triangle or a row found once. One frame walks spans for all of them.
//
// Plain data: what is compiled for one SIMD target defines nothing for another.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_KERNELS_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_KERNELS_H_

#include <cstddef>
#include <cstdint>

namespace rasterproof::bench {

/// Corners before the division by w (1 in the window), and a number at each.
struct ValueTriangle {
  float x[3], y[3], w[3], a[3];
};

/// Covered columns [x0, x1) of a row; those of a triangle follow each other.
struct ValueRun {
  std::uint32_t triangle;
  int row, x0, x1;
};

/// What a kernel walks. All rows are written to one, which stays in the cache: column x at row[x].
struct ValueFrame {
  const ValueTriangle* triangles;
  const ValueRun* runs;
  std::size_t count;
  float* row;
};

struct ValueKernel {
  const char* name;  ///< of reference/value_methods.h, with "-f64" in double
  void (*fill)(const ValueFrame& frame);
};

/// Stores a number a triangle: the floor, what the frame itself takes.
inline constexpr const char* kValueFloor = "constant";

/// The library's correctly rounded values in this frame (library/kernels/nearest_spans.h).
inline constexpr const char* kCorrectlyRounded = "correctly-rounded";

/// What that asks for where a double does not tell: exact.
float NearestValueOf(const ValueTriangle& triangle, int column, int row);

struct ValueKernels {
  const char* target;
  void (*store)(float* to, int count, float value);  ///< as kernels store
  const ValueKernel* kernels;
  std::size_t count;
};

// Not defined but on x86.
extern const ValueKernels kAvx2ValueKernels;
extern const ValueKernels kAvx512ValueKernels;

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_KERNELS_H_
