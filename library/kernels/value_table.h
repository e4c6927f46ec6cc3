// What passes between the library's values and the code of one SIMD target: rows of one triangle.
//
// Plain data, as kernel_table.h says why. Coverage is found by the kernels of spans and costs
// what it does without values.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_

#include <cstdint>

namespace rasterproof::library::kernels {

/// (c + b y) + a x at the centre (x, y), each operation rounded to float32.
struct ValuePlane {
  float a, b, c;
};

/// One channel over the columns [x0, x1) of a row.
///
/// value = n / d, and the derivatives (n.a - value d.a) / d and (n.b - value d.b) / d; n, n.a and
/// n.b where it does not divide.
struct ValueSpan {
  ValuePlane n, d;
  bool divides;
  int row, x0, x1;
  float* value;    ///< of column x0
  float *dx, *dy;  ///< the same; nullptr: not asked for
};

/// The same, correctly rounded: n and d in double, (n_row + n_x x) / (d_row + d_x x).
struct NearestSpan {
  double n_x, n_row, d_x, d_row;
  int x0, x1;
  float* value;
  /// The quotient may be off by so many of its last places: where a middle of two floats lies
  /// among them, decide(state, column) tells the value.
  std::int64_t doubt;
  float (*decide)(const void* state, int column);
  const void* state;
};

/// Of the quotient in NearestSpan, relative, besides those of n and d.
constexpr double kQuotientError = 0x1p-41;

struct ValueTable {
  void (*values)(const ValueSpan&);
  void (*nearest)(const NearestSpan&);
};

extern const ValueTable kScalarValues;
extern const ValueTable kAvx2Values;
extern const ValueTable kAvx512Values;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_TABLE_H_
