// Error against run time of interpolated values: measured by bench, rendered by report.
#ifndef RASTERPROOF_CORE_VALUE_RESULT_H_
#define RASTERPROOF_CORE_VALUE_RESULT_H_

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rasterproof {

/// Triangles whose values are hard in one way.
struct ValueBenchFamily {
  std::string name;
  std::string summary;  ///< a sentence
  bool is_clip_space = false;
  std::uint64_t triangles = 0;
  std::uint64_t covered = 0;  ///< pixels
  std::uint64_t judged = 0;   ///< of them, compared with the exact value
  double floor_ns = 0;        ///< a covered pixel: the frame with a constant stored
};

/// A value, to be seen again.
struct ValueBenchCase {
  std::array<std::array<double, 4>, 3> corners{};  ///< x, y, w before the division, and the number
  double x = 0;                                    ///< the pixel's centre
  double y = 0;
  double shown = 0;
  double exact = 0;  ///< the nearest double
};

/// One method on one family. NaN: there is none.
struct ValueBenchRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::uint32_t family = 0;  ///< index in BenchResult::value_families
  std::string method;        ///< of reference/value_methods.h; "library"
  std::string target;        ///< instruction set
  std::string shows;         ///< "value" or "d/dx"
  double ns_low = kNone;     ///< a covered pixel, less the floor: a median with its interval
  double ns = kNone;
  double ns_high = kNone;
  double ulps = 0;  ///< largest error, float32's units in the last place of the exact number
  double ulps_999 = 0;
  double texels = 0;  ///< the same, the number times 4096
  double texels_999 = 0;
  double share_of_bound = kNone;  ///< largest error / bound, where one is stated
  std::uint64_t unbounded = 0;    ///< judged pixels of which no error is stated
  std::uint64_t not_finite = 0;
  ValueBenchCase worst;  ///< of the largest error in ulps
};

/// Up to which power of two a parameter may grow until a value in [0, 1] is off by more than half
/// a texel of 4096. Failing is not monotone: nothing is stated beyond the first failing one.
struct ValueBenchLimit {
  std::string parameter;  ///< "w-ratio", "distance", "aspect"
  std::string method;
  std::string target;
  double held_to = ValueBenchRow::kNone;   ///< the exponent; NaN: not even the first
  double fails_at = ValueBenchRow::kNone;  ///< NaN: nowhere
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_VALUE_RESULT_H_
