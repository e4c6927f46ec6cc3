// Mistakes that may explain wrong values, each with the number that it makes.
#ifndef RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKE_LIST_H_
#define RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKE_LIST_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/channel.h"
#include "props/judging/values/value_estimates.h"
#include "props/judging/values/value_queries.h"

namespace rasterproof::props {

using VertexNumbers = std::array<double, 3>;

/// What a search looks at.
enum class NumbersOf : std::uint8_t { kChannels, kInverseW, kBarycentrics, kDepths, kDerivatives };

/// A triangle of the list beside the one that a number is of.
struct OtherTriangle {
  const RayCorners* corners = nullptr;
  Triangle vertices{};
};
enum class ListNeighbour : std::uint8_t { kBefore, kAfter };

/// What a rasterizer interpolates that did not replace what it set up for another triangle.
struct OtherPlane {
  RayCorners corners;
  VertexNumbers numbers;
};

/// One number that is shown, and what it is of.
struct ShownNumber {
  const ShownValues& values;
  const ValueFragment& f;
  const ValueOwners& owners;
  Channel channel;
  VertexNumbers numbers;
  double x = 0;
  int facing = 0;  ///< of the triangle on the screen
  const RayCorners* other_corners = nullptr;
  int axis = -1;          ///< of a derivative: 0 by x, 1 by y
  std::size_t entry = 0;  ///< of a channel: its place among all
  /// Those beside it in the list; null: there is none, or its corners are not known.
  const OtherTriangle* triangle_before = nullptr;
  const OtherTriangle* triangle_after = nullptr;

  bool HasTriangle(ListNeighbour side) const;
  /// The plane of the triangle beside it in the list, if that is known.
  std::optional<OtherPlane> PlaneOf(ListNeighbour side) const;
};

/// A number that a rasterizer with a mistake may show.
struct MadeNumber {
  double value = 0;
  double condition = 0;
  /// How far from it what is shown may be; nothing: as the condition and the stated error say.
  std::optional<double> within = std::nullopt;
};

struct Mistake {
  std::string_view name;
  std::string what;
  /// The numbers of which a rasterizer with the mistake shows one; empty where it makes none.
  std::function<std::vector<MadeNumber>(const ShownNumber&)> shows;
  /// Whether it lets numbers be as stated, or be one of several, and so explains what others do:
  /// it is named where none of these is left.
  bool is_wide = false;
  std::set<std::size_t> cases = {};  ///< with wrong numbers that it explains
};

/// "the triangle before in the list".
std::string_view WordsOf(ListNeighbour side);

/// The value of numbers at corners, and its condition.
MadeNumber ValueOfPlane(const RayCorners& v, Interpolation plane, const VertexNumbers& a, Point2 p);
/// 1 over the interpolated 1/w.
MadeNumber WOfPlane(const RayCorners& v, Point2 p);

/// The mistakes that are known of such numbers.
std::vector<Mistake> MistakesOf(NumbersOf what);
/// Those of kDerivatives.
std::vector<Mistake> MistakesOfDerivatives();

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKE_LIST_H_
