// What passes between the library's values and the code of one SIMD target: spans, drawn onto
// planes of numbers, triangle by triangle.
//
// Plain data, as kernel_table.h says why. Coverage is found by the kernels of spans and costs
// what it does without values.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/kernel_table.h"

namespace rasterproof::library::kernels {

/// (c + b y) + a x at the centre (x, y), each operation rounded to float32.
struct ValuePlane {
  float a, b, c;
};

/// a x + b y + c in double, and the sums of the magnitudes of the products that make each up.
struct ReachLine {
  double a, b, c;
  double a_reach, b_reach, c_reach;
};

/// Corners, and what is found of them: beta_i of exact/values.h and d.
struct ValueSetUp {
  int left, top;  ///< the corner of a pixel that (x, y) / w counts from
  double x[3], y[3], w[3];
  ReachLine beta[3];
  ReachLine d;
  double most_w;   ///< in size
  double least_d;  ///< no covered pixel's |d| times most_w is less; 0: nothing is known
  double r;        ///< 1 / d, where d is one number; else 0
};

enum class ValueFill : std::uint8_t { kPlane, kNothing, kConstant };

/// A channel of the triangle: value = n / d.
struct ValueChannel {
  ValueFill fill;
  float constant;      ///< kConstant
  ValuePlane plane;    ///< fast: n and d
  ValuePlane d_plane;  ///< scaled alike; n / d itself where nothing divides
  ReachLine n;         ///< nearest
  int quick;           ///< places up to here, either way, keep kQuickShare (value_errors.h)
};

/// A drawing, and where it is.
struct ValueDrawing {
  const float* positions;
  const std::uint32_t* indices;
  std::size_t coordinates;  ///< of a position: 3, or 4 in clip space
  const float* numbers;
  std::size_t channels;
  bool is_linear;
  int width, height;
  std::size_t pitch;
  float* values;
  float *dx, *dy;  ///< nullptr: not asked for

  /// The nearest float32 at a centre, where a double's quotient does not tell it.
  float (*decide)(const ValueDrawing& drawing, std::size_t channel, int column, int row);

  ValueChannel* of_channels;  ///< as many
  double* reciprocals;        ///< 1 / d of a row, width + 16 of them
  std::uint32_t triangle;     ///< that is set up
  ValueSetUp set_up;
};

/// Draw a span of the state, a ValueDrawing* const*.
struct ValueTable {
  void (*fast)(const void* state, const KernelSpan& span);
  void (*nearest)(const void* state, const KernelSpan& span);
};

extern const ValueTable kScalarValues;
extern const ValueTable kAvx2Values;
extern const ValueTable kAvx512Values;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_
