// What a rasterizer states about the values that its covered samples hold.
#ifndef RASTERPROOF_CORE_VALUE_RULE_H_
#define RASTERPROOF_CORE_VALUE_RULE_H_

#include <cstdint>

namespace rasterproof {

/// The most that a number is off: the sum of three parts.
struct ValueError {
  double ulps = 0;      ///< ulps of the exact number, in the precision of the subject's input
  double absolute = 0;  ///< in the number's own unit
  /// Units of rounding (2^-24 or 2^-53) of the condition: by how much the number moves, to first
  /// order, where each product of the edge values is off by as much as it is large
  /// (exact/values.h). To first order: c conditions promise c / (1 - e) of them where the
  /// denominator is itself off by up to a share e of it, and nothing where e reaches one half.
  double conditions = 0;

  bool IsStated() const { return ulps > 0 || absolute > 0 || conditions > 0; }
  friend bool operator==(const ValueError&, const ValueError&) = default;
};

/// Of which plane barycentrics are. In window space both are the same.
enum class WeightsIn : std::uint8_t {
  kUnstated,    ///< of one of the two
  kScreen,      ///< of the screen: a point's part of the projected triangle
  kPerspective  ///< of the triangle before the division by w
};

/// The vertex that a flat value is taken from.
enum class ProvokingVertex : std::uint8_t { kUnstated, kFirst, kLast };

/// How derivatives along x and y are computed.
enum class DerivativesBy : std::uint8_t {
  kUnstated,  ///< in any of these ways
  kAnalytic,  ///< of the plane, at the point itself
  kFine,      ///< differences in a row and a column of a quad of 2 x 2 pixels
  kCoarse     ///< one difference along each axis for the whole quad
};

/// At which columns and rows quads of 2 x 2 pixels begin, counted along the profile's axes.
enum class QuadOrigin : std::uint8_t {
  kUnstated,  ///< of each triangle at any
  kEven,
  kOdd
};

/// The format that a depth is rounded to.
enum class DepthFormat : std::uint8_t {
  kUnstated,
  kFloat32,
  kFloat64,
  kUnorm16,
  kUnorm24,
  kUnorm32
};

/// The distance of two depths of a normalized format: 1 / (2^bits - 1); 0: floating point.
constexpr double DepthStep(DepthFormat format) {
  switch (format) {
    case DepthFormat::kUnorm16:
      return 1.0 / 0xffff;
    case DepthFormat::kUnorm24:
      return 1.0 / 0xffffff;
    case DepthFormat::kUnorm32:
      return 1.0 / 0xffffffff;
    case DepthFormat::kUnstated:
    case DepthFormat::kFloat32:
    case DepthFormat::kFloat64:
      break;
  }
  return 0;
}

/// Which of the format's two neighbours of a depth is shown.
enum class DepthRounding : std::uint8_t { kEither, kNearest };

/// A profile's statement about values. What is unstated is not judged, but for the error: a subject
/// that states none is held to kUsualConditions.
struct ValueRule {
  WeightsIn weights = WeightsIn::kUnstated;
  ProvokingVertex provoking = ProvokingVertex::kUnstated;
  DerivativesBy derivatives = DerivativesBy::kUnstated;
  QuadOrigin quads = QuadOrigin::kUnstated;
  // What it computes beside perspective values at samples, which all that show values do.
  bool flat = false;
  bool linear = false;
  bool inverse_w = false;
  bool centres = false;
  bool centroids = false;
  DepthFormat depth = DepthFormat::kUnstated;
  DepthRounding depth_rounding = DepthRounding::kEither;
  ValueError error = {};
  ValueError derivative_error = {};
  /// What is below the normal floats may count as zero, where no error is stated.
  bool flushes = false;
  bool equal_stay_equal = false;   ///< equal numbers at the vertices give that number, to the bit
  bool exact_at_vertices = false;  ///< a sample at a vertex holds its number, to the bit
  bool stays_in_hull = false;      ///< a value lies between the least and the greatest
  /// A value on an edge depends, to the bit, on the edge's ends alone.
  bool agrees_along_edges = false;
  bool same_in_any_order = false;  ///< rotated corners give the same number, to the bit
  /// In front of the eye, values along a row of samples of a triangle do not both rise and fall.
  bool monotone_along_rows = false;

  friend bool operator==(const ValueRule&, const ValueRule&) = default;
};

/// The error of a subject that states none, in units of rounding of what its form may have for a
/// condition (props/judging/values/value_estimates.h, which says what was tested).
inline constexpr double kUsualConditions = 16;

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_VALUE_RULE_H_
