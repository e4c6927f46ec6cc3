// What a value should be, and by how much a shown one is off.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_ERRORS_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_ERRORS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/values/value_kernels.h"
#include "core/value_result.h"
#include "exact/rational.h"
#include "reference/value_methods.h"

namespace rasterproof::bench {

/// A pixel of a triangle with the oracle's value and derivative there.
///
/// Conditions are those of exact/values.h about the point that a method is judged by
/// (reference::ConditionAbout), in double.
struct ExactValue {
  ValueTriangle triangle = {};
  int x = 0;
  int y = 0;
  int first_x = 0;          ///< where its span begins
  std::uint32_t index = 0;  ///< of the triangle in its scene
  exact::Rational value;
  exact::Rational dx;
  std::array<double, 3> condition{};  ///< by ConditionAbout
  std::array<double, 3> share{};      ///< sum M_i / |d|, by ConditionAbout
  double dx_condition = 0;            ///< C_x
};

/// Nothing on the horizon, and for a triangle without area.
std::optional<ExactValue> ExactValueAt(const ValueTriangle& triangle, int x, int y);

/// A stated bound.
struct ValueBound {
  double conditions = 0;
  double unit = 0x1p-24;  ///< of rounding
  double ulps = 0;        ///< besides, of float32
  std::size_t about = 0;  ///< a ConditionAbout
  bool is_of_derivative = false;
  bool is_stated = true;
};

/// The errors of one method on one family, pixel by pixel.
class ValueErrors {
 public:
  ValueErrors(bool is_derivative, const ValueBound& bound)
      : is_derivative_(is_derivative), bound_(bound) {}
  void Add(const ExactValue& exact, float shown);
  /// Everything but names and times.
  void WriteTo(ValueBenchRow& row);

 private:
  bool is_derivative_;
  ValueBound bound_;
  ValueBenchRow row_;
  std::vector<double> ulps_;
  std::vector<double> texels_;
};

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_ERRORS_H_
