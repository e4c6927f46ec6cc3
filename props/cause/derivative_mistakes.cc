// Mistakes that may explain wrong derivatives.
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/value_rule.h"
#include "props/cause/value_mistake_list.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/precision_units.h"

namespace rasterproof::props {
namespace {

using Made = std::vector<MadeNumber>;

Point2 PlaceOfSlope(const ShownNumber& s) { return PlaceOfValue(s.f, s.channel); }

MadeNumber Slope(const ShownNumber& s, Interpolation plane, const VertexNumbers& a, Point2 p,
                 int axis) {
  const ValueEstimate e = EstimateValue(s.owners.corners.front(), plane, a, p);
  const auto k = static_cast<std::size_t>(axis);
  return {e.derivatives[k], e.derivative_conditions[k]};
}

MadeNumber SlopeAt(const ShownNumber& s, Point2 p, int axis) {
  return Slope(s, s.channel.interpolation, s.numbers, p, axis);
}

MadeNumber Difference(const ShownNumber& s, Point2 from, Point2 to) {
  const auto at = [&](Point2 p) {
    return ValueOfPlane(s.owners.corners.front(), s.channel.interpolation, s.numbers, p);
  };
  const MadeNumber first = at(from), last = at(to);
  return {last.value - first.value, first.condition + last.condition};
}

// From one point to another, in pixels along the axis from the place moved across it.
MadeNumber DifferenceOf(const ShownNumber& s, double from, double to, double across = 0) {
  const Point2 p = Moved(PlaceOfSlope(s), 1 - s.axis, across);
  return Difference(s, Moved(p, s.axis, from), Moved(p, s.axis, to));
}

// The derivatives that may be meant, at a place some pixels away: of the plane, or over a quad.
Made SlopesOf(const ShownNumber& s, Point2 moved = {}) {
  const ValueRule& rule = s.values.rule;
  if (rule.derivatives == DerivativesBy::kUnstated) return {{std::nan(""), 0}};
  const Point2 here = PlaceOfSlope(s);
  Made made;
  for (const auto& [from, to] : DerivativeEnds(rule, here, s.axis)) {
    const Point2 first{from.x + moved.x, from.y + moved.y};
    const Point2 last{to.x + moved.x, to.y + moved.y};
    made.push_back(from == to ? SlopeAt(s, first, s.axis) : Difference(s, first, last));
  }
  return made;
}

Made ScaledSlopes(const ShownNumber& s, double by) {
  Made made = SlopesOf(s);
  for (MadeNumber& one : made) {
    one.value *= by;
    one.condition *= std::fabs(by);
  }
  return made;
}

void AddScales(std::vector<Mistake>& list) {
  struct Scale {
    double by;
    int axis;  // -1: both
    std::string_view what;
  };
  for (const Scale& scale :
       {Scale{2, -1, "shows derivatives twice as large"},
        Scale{0.5, -1, "shows derivatives half as large"}, Scale{-1, 0, "negates derivatives by x"},
        Scale{-1, 1, "negates derivatives by y"}, Scale{-1, -1, "negates derivatives"}}) {
    list.push_back({"wrong-derivative", std::string(scale.what),
                    [by = scale.by, axis = scale.axis](const ShownNumber& s) -> Made {
                      if (axis >= 0 && axis != s.axis) return {};
                      return ScaledSlopes(s, by);
                    }});
  }
  list.push_back({"wrong-derivative", "negates some differences",
                  [](const ShownNumber& s) -> Made {
                    Made made = SlopesOf(s);
                    for (const MadeNumber& one : ScaledSlopes(s, -1)) made.push_back(one);
                    return made;
                  },
                  true});
  list.push_back(
      {"wrong-derivative", "exchanges derivatives by x and by y", [](const ShownNumber& s) -> Made {
         ShownNumber other = s;
         other.axis = 1 - s.axis;
         return SlopesOf(other);
       }});
}

void AddSlopePlanes(std::vector<Mistake>& list) {
  list.push_back(
      {"wrong-derivative", "derives the plane on the screen", [](const ShownNumber& s) -> Made {
         if (s.channel.interpolation != Interpolation::kPerspective) return {};
         return {Slope(s, Interpolation::kLinear, s.numbers, PlaceOfSlope(s), s.axis)};
       }});
  list.push_back(
      {"wrong-derivative", "leaves out the derivative of 1/w", [](const ShownNumber& s) -> Made {
         if (s.channel.interpolation != Interpolation::kPerspective) return {};
         MadeNumber slope = Slope(s, Interpolation::kInverseW, s.numbers, PlaceOfSlope(s), s.axis);
         const MadeNumber w = WOfPlane(s.owners.corners.front(), PlaceOfSlope(s));
         slope.condition =
             std::fabs(w.value) * slope.condition + std::fabs(slope.value) * w.condition;
         slope.value *= w.value;
         return {slope};
       }});
  list.push_back({"wrong-derivative", "derives at the pixel before in the last column",
                  [](const ShownNumber& s) -> Made {
                    const int width = s.values.scene->width;
                    if (s.f.place.x == 0 || s.f.place.x != width - 1) return {};
                    return {SlopeAt(s, Moved(PlaceOfSlope(s), 0, -1), s.axis)};
                  }});
}

// What the pixel beside shows, less what this one does: of whichever triangle it shows.
Made DifferencesOfShown(const ShownNumber& s) {
  const Drawing& drawing = s.values.drawing;
  const CoverageCounts& counts = drawing.counts;
  const std::size_t channels = s.values.channels.size();
  const auto shown = [&](int by) -> std::optional<double> {
    const int x = s.f.place.x + (s.axis == 0 ? by : 0);
    const int row = s.f.place.row + (s.axis != 1 ? 0 : s.values.is_y_up ? -by : by);
    if (x < 0 || row < 0 || x >= counts.width || row >= counts.height) return std::nullopt;
    const std::size_t index = counts.Index(x, row, s.f.place.sample);
    if (drawing.primitive_ids[index] == kNoPrimitive) return std::nullopt;
    return drawing.values[index * channels + s.entry];
  };
  Made made = SlopesOf(s);
  for (const int by : {1, -1}) {
    const auto there = shown(by);
    if (!there) return {{std::nan(""), 0}};  // what it holds is not known
    const double rounding = 2 * UnitRoundoff(s.values.precision) *
                            (std::fabs(*there) + std::fabs(s.values.Of(s.f, s.entry)));
    made.push_back({by * (*there - s.values.Of(s.f, s.entry)), 0, rounding});
  }
  return made;
}

void AddDifferences(std::vector<Mistake>& list) {
  const auto add = [&](std::string what, auto made, bool is_wide = false) {
    list.push_back({"wrong-derivative", std::move(what), made, is_wide});
  };
  // Of stated quads they are those of the quad, too, or of the one beside.
  const auto to_neighbours = [](bool of_quads) {
    return [of_quads](const ShownNumber& s) -> Made {
      const DerivativesBy by = s.values.rule.derivatives;
      const bool states_quads = by == DerivativesBy::kFine || by == DerivativesBy::kCoarse;
      if (states_quads != of_quads) return {};
      return {DifferenceOf(s, 0, 1), DifferenceOf(s, -1, 0)};
    };
  };
  add("takes differences for derivatives of the plane", to_neighbours(false));
  add("takes differences between pixels of different quads", to_neighbours(true), true);
  add("takes differences over two pixels", [](const ShownNumber& s) -> Made {
    MadeNumber made = DifferenceOf(s, -1, 1);
    made.value /= 2;
    return {made};
  });
  const auto takes_first = [](const ShownNumber& s) -> Made {
    Made made;
    for (const double across : {0.0, -1.0, 1.0}) {
      made.push_back(DifferenceOf(s, 0, 1, across));
      made.push_back(DifferenceOf(s, -1, 0, across));
    }
    return made;
  };
  add("takes a quad's first row and column for all of it", takes_first, true);
  add("takes differences from pixels that show other triangles", DifferencesOfShown, true);
}

void AddOtherQuads(std::vector<Mistake>& list) {
  const auto add = [&](std::string what, auto made, bool is_wide = false) {
    list.push_back({"wrong-derivative", std::move(what), made, is_wide});
  };
  add("begins quads at odd pixels, where even ones are stated, or the other way round",
      [](const ShownNumber& s) -> Made {
        ValueRule other = s.values.rule;
        if (other.quads == QuadOrigin::kUnstated) return {};
        other.quads = other.quads == QuadOrigin::kEven ? QuadOrigin::kOdd : QuadOrigin::kEven;
        Made made;
        for (const auto& [from, to] : DerivativeEnds(other, PlaceOfSlope(s), s.axis))
          made.push_back(from == to ? SlopeAt(s, from, s.axis) : Difference(s, from, to));
        return made;
      });
  for (const int axis : {0, 1}) {
    add(
        axis == 0 ? "takes derivatives by x of the quad beside"
                  : "takes derivatives by y of the quad beside",
        [axis](const ShownNumber& s) -> Made {
          if (s.axis != axis) return {};
          return {DifferenceOf(s, 1, 2), DifferenceOf(s, 2, 3), DifferenceOf(s, -2, -1),
                  DifferenceOf(s, -3, -2)};
        },
        true);
  }
  for (const int pixels : {1, 2}) {
    for (int k = 0; k < 9; ++k) {
      const int x = pixels * (k % 3 - 1), y = pixels * (k / 3 - 1);
      if (x == 0 && y == 0) continue;
      std::string what = "takes derivatives of the ";
      what.append(pixels == 1 ? "pixel" : "quad").append(" that lies (");
      what.append(std::to_string(x)).append(", ").append(std::to_string(y)).append(") away");
      add(std::move(what), [by = Point2{static_cast<double>(x), static_cast<double>(y)}](
                               const ShownNumber& s) { return SlopesOf(s, by); });
    }
  }
}

void AddOtherPlanes(std::vector<Mistake>& list) {
  for (const ListNeighbour side : {ListNeighbour::kBefore, ListNeighbour::kAfter}) {
    list.push_back({"wrong-derivative", std::string("takes derivatives of ").append(WordsOf(side)),
                    [side](const ShownNumber& s) -> Made {
                      if (!s.HasTriangle(side)) return {};
                      const std::optional<OtherPlane> other = s.PlaneOf(side);
                      if (!other) return {{std::nan(""), 0}};
                      const ValueEstimate e = EstimateValue(other->corners, s.channel.interpolation,
                                                            other->numbers, PlaceOfSlope(s));
                      const auto k = static_cast<std::size_t>(s.axis);
                      return {{e.derivatives[k], e.derivative_conditions[k]}};
                    }});
  }
}

}  // namespace

std::vector<Mistake> MistakesOfDerivatives() {
  std::vector<Mistake> list;
  AddScales(list);
  AddSlopePlanes(list);
  AddDifferences(list);
  AddOtherQuads(list);
  AddOtherPlanes(list);
  return list;
}

}  // namespace rasterproof::props
