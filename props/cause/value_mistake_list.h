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
  std::set<std::size_t> cases = {};  ///< with wrong numbers that it explains
};

/// The mistakes that are known of such numbers.
std::vector<Mistake> MistakesOf(NumbersOf what);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_VALUE_MISTAKE_LIST_H_
