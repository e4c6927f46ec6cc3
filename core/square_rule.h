// Square coverage: which relation between a pixel's square and a triangle counts, as data.
#ifndef RASTERPROOF_CORE_SQUARE_RULE_H_
#define RASTERPROOF_CORE_SQUARE_RULE_H_

#include <cmath>
#include <cstdint>
#include <optional>

namespace rasterproof {

/// Which squares a triangle covers.
enum class SquareRelation : std::uint8_t {
  kIntersects,  ///< the square and the triangle have a point in common
  kContains     ///< the square lies in the triangle
};

/// Which boundary points belong to a set. A half-open set includes its floor sides, towards smaller
/// coordinates of the profile's window space, and excludes its ceiling sides:
/// p belongs to it iff p + (e, e^2), e -> 0+, lies inside.
enum class Closure : std::uint8_t { kClosed, kOpen, kHalfOpen };

/// Where the triangle's vertices are taken.
enum class SquareGeometry : std::uint8_t {
  kGiven,  ///< at the given coordinates
  kPlaced  ///< where the profile's snap rule puts them; with a snap tolerance, anywhere within it
};

/// How the triangle is grown.
enum class SquareGrowth : std::uint8_t {
  kSwept,  ///< its Minkowski sum with the square [-half_width, half_width]^2
  kEdges   ///< each edge moved outward as far as that sum moves it, corners left sharp
};

/// The squares that have one relation to a triangle.
struct SquareRegion {
  SquareRelation relation = SquareRelation::kIntersects;
  Closure square = Closure::kClosed;
  Closure shape = Closure::kClosed;
  SquareGeometry geometry = SquareGeometry::kGiven;
  SquareGrowth growth = SquareGrowth::kSwept;
  /// Half the side of the swept square, in pixels: a multiple of kSquareStep. kIntersects: the
  /// triangle grows; below zero the pixel's square shrinks in its place. kContains: the triangle
  /// shrinks, so that fewer squares lie in it; below zero the pixel's square shrinks.
  double half_width = 0;

  friend bool operator==(const SquareRegion&, const SquareRegion&) = default;
};

/// Half widths are multiples of this, so that the corners of a grown square are exact doubles.
inline constexpr double kSquareStep = 0x1p-20;
inline constexpr double kLeastHalfWidth = -0.4375;
inline constexpr double kLargestHalfWidth = 1;

/// The statement about a triangle without area, which is a segment or a point.
enum class FlatSquares : std::uint8_t {
  kNothing,  ///< it covers nothing
  kFree,     ///< it may cover any squares of the may region of its closed segment
  kDrawn     ///< it covers the must region of its closed segment, and at least one square
};

/// A profile's statement about pixels as squares. A triangle covers at least the squares of `must`
/// and at most the squares of `may`, where these are stated.
struct SquareRule {
  std::optional<SquareRegion> must;
  std::optional<SquareRegion> may;
  FlatSquares flat = FlatSquares::kNothing;

  friend bool operator==(const SquareRule&, const SquareRule&) = default;
};

/// Returns whether the region can be decided. A closed square that intersects a half-open shape
/// can't be, and no specification states it.
inline bool IsDecidable(const SquareRegion& region) {
  const double steps = region.half_width / kSquareStep;
  return !(region.relation == SquareRelation::kIntersects && region.square == Closure::kClosed &&
           region.shape == Closure::kHalfOpen) &&
         region.half_width >= kLeastHalfWidth && region.half_width <= kLargestHalfWidth &&
         steps == std::floor(steps);
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SQUARE_RULE_H_
