#include "props/cause/value_mistake_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/value_rule.h"
#include "props/judging/values/precision_units.h"

namespace rasterproof::props {
namespace {

using Made = std::vector<MadeNumber>;

Point2 PlaceOf(const ShownNumber& s) { return PlaceOfValue(s.f, s.channel); }

MadeNumber Estimated(const ShownNumber& s, Interpolation plane, const VertexNumbers& a, Point2 p) {
  return ValueOfPlane(s.owners.corners.front(), plane, a, p);
}

bool IsInterpolated(const ShownNumber& s) {
  return s.channel.interpolation != Interpolation::kFlat;
}

// sum g_i a_i / sum g_i.
MadeNumber WeighedBy(const ShownNumber& s, const VertexNumbers& g) {
  const double sum = g[0] + g[1] + g[2];
  MadeNumber e = Estimated(s, Interpolation::kPerspective, s.numbers, PlaceOf(s));
  e.value = (g[0] * s.numbers[0] + g[1] * s.numbers[1] + g[2] * s.numbers[2]) / sum;
  const double size = std::fabs(g[0]) + std::fabs(g[1]) + std::fabs(g[2]);
  e.condition *= 1 + size / std::fabs(sum);
  return e;
}

MadeNumber OfPower(const ShownNumber& s, int power) {
  return WeighedBy(s, WeightsOfPower(s.owners.corners.front(), power, PlaceOf(s)));
}

MadeNumber OfAbsoluteW(const ShownNumber& s) {
  const RayCorners& v = s.owners.corners.front();
  VertexNumbers g = WeightsOfPower(v, 0, PlaceOf(s));
  for (std::size_t i = 0; i < 3; ++i) g[i] *= v[i].w < 0 ? -1 : 1;
  return WeighedBy(s, g);
}

void AddPlanes(std::vector<Mistake>& list) {
  const auto plane = [](Interpolation stated, Interpolation taken) {
    return [stated, taken](const ShownNumber& s) -> Made {
      if (s.channel.interpolation != stated) return {};
      return {Estimated(s, taken, s.numbers, PlaceOf(s))};
    };
  };
  list.push_back({"affine-weights", "interpolates on the screen what is in perspective",
                  plane(Interpolation::kPerspective, Interpolation::kLinear)});
  list.push_back({"affine-weights", "interpolates in perspective what is affine on the screen",
                  plane(Interpolation::kLinear, Interpolation::kPerspective)});
  list.push_back({"affine-weights", "interpolates depth in perspective",
                  plane(Interpolation::kInverseW, Interpolation::kPerspective)});
  list.push_back({"missing-division", "does not divide depth by w",
                  plane(Interpolation::kInverseW, Interpolation::kLinear)});
  list.push_back({"missing-division", "does not divide by the interpolated 1/w",
                  plane(Interpolation::kPerspective, Interpolation::kInverseW)});
  const auto power = [](int of) {
    return [of](const ShownNumber& s) -> Made {
      if (s.channel.interpolation != Interpolation::kPerspective) return {};
      return {OfPower(s, of)};
    };
  };
  list.push_back({"weights-by-w", "takes |w| for w", [](const ShownNumber& s) -> Made {
                    if (s.channel.interpolation != Interpolation::kPerspective) return {};
                    return {OfAbsoluteW(s)};
                  }});
  list.push_back({"weights-by-w", "divides weights by w twice", power(-1)});
  list.push_back({"weights-by-w", "multiplies weights by w instead of dividing", power(2)});
  list.push_back({"weights-by-w", "divides weights by w squared and by w", power(-2)});
}

void AddExchanges(std::vector<Mistake>& list) {
  struct Order {
    std::array<std::size_t, 3> of;
    std::string_view what;
  };
  constexpr std::array<Order, 5> kOrders{{{{1, 0, 2}, "exchanges the first two weights"},
                                          {{0, 2, 1}, "exchanges the last two weights"},
                                          {{2, 1, 0}, "exchanges the first and the last weight"},
                                          {{1, 2, 0}, "gives each weight to the next vertex"},
                                          {{2, 0, 1}, "gives each weight to the vertex before"}}};
  struct Side {
    int facing;
    std::string_view what;
  };
  constexpr std::array<Side, 3> kSides{{{0, ""}, {-1, " of back faces"}, {1, " of front faces"}}};
  for (const Side& side : kSides) {
    for (const Order& order : kOrders) {
      list.push_back({"exchanged-weights", std::string(order.what).append(side.what),
                      [order, facing = side.facing](const ShownNumber& s) -> Made {
                        if (!IsInterpolated(s) || (facing != 0 && s.facing != facing)) return {};
                        const VertexNumbers& a = s.numbers;
                        return {Estimated(s, s.channel.interpolation,
                                          {a[order.of[0]], a[order.of[1]], a[order.of[2]]},
                                          PlaceOf(s))};
                      }});
    }
  }
}

void AddPlaces(std::vector<Mistake>& list) {
  const auto at = [](auto place) {
    return [place](const ShownNumber& s) -> Made {
      if (!IsInterpolated(s)) return {};
      return {Estimated(s, s.channel.interpolation, s.numbers, place(s))};
    };
  };
  list.push_back({"wrong-place", "evaluates at the pixel's centre",
                  at([](const ShownNumber& s) { return s.f.centre; })});
  struct Move {
    Point2 by;
    std::string_view what;
  };
  for (const Move& move :
       {Move{{-0.5, -0.5}, "half a pixel towards the origin"},
        Move{{0.5, 0.5}, "half a pixel away from the origin"},
        Move{{-0.5, 0}, "half a pixel to the left"}, Move{{0.5, 0}, "half a pixel to the right"},
        Move{{0, -0.5}, "half a pixel before the row"},
        Move{{0, 0.5}, "half a pixel behind the row"}, Move{{1, 0}, "at the next pixel"},
        Move{{-1, 0}, "at the pixel before"}, Move{{0, 1}, "in the next row"},
        Move{{0, -1}, "in the row before"}}) {
    list.push_back({"wrong-place", std::string("evaluates ").append(move.what),
                    at([by = move.by](const ShownNumber& s) {
                      const Point2 p = PlaceOf(s);
                      return Point2{p.x + by.x, p.y + by.y};
                    })});
  }
  list.push_back(
      {"other-corners", "interpolates between the other corners: given, not snapped, or snapped",
       [](const ShownNumber& s) -> Made {
         if (!IsInterpolated(s) || s.other_corners == nullptr) return {};
         return {ValueOfPlane(*s.other_corners, s.channel.interpolation, s.numbers, PlaceOf(s))};
       }});
}

void AddOtherTriangles(std::vector<Mistake>& list) {
  for (const ListNeighbour side : {ListNeighbour::kBefore, ListNeighbour::kAfter}) {
    list.push_back({"other-corners", std::string("takes the plane of ").append(WordsOf(side)),
                    [side](const ShownNumber& s) -> Made {
                      if (!IsInterpolated(s) || !s.HasTriangle(side)) return {};
                      const std::optional<OtherPlane> other = s.PlaneOf(side);
                      if (!other) return {{std::nan(""), 0}};
                      return {ValueOfPlane(other->corners, s.channel.interpolation, other->numbers,
                                           PlaceOf(s))};
                    }});
  }
}

void AddFlat(std::vector<Mistake>& list) {
  constexpr std::array<std::string_view, 3> kVertices{"first", "second", "last"};
  for (std::size_t i = 0; i < 3; ++i) {
    list.push_back(
        {"wrong-provoking-vertex",
         std::string("takes flat values from the ").append(kVertices[i]).append(" vertex"),
         [i](const ShownNumber& s) -> Made {
           if (IsInterpolated(s)) return {};
           return {{s.numbers[i]}};
         }});
  }
  list.push_back(
      {"wrong-provoking-vertex", "interpolates flat values", [](const ShownNumber& s) -> Made {
         if (IsInterpolated(s)) return {};
         return {Estimated(s, Interpolation::kPerspective, s.numbers, PlaceOf(s))};
       }});
}

MadeNumber WAt(const ShownNumber& s, Point2 p) { return WOfPlane(s.owners.corners.front(), p); }

// What is shown is not what was asked for.
void AddQuantities(std::vector<Mistake>& list) {
  list.push_back({"clamped-values", "clamps values to [0, 1]", [](const ShownNumber& s) -> Made {
                    if (!IsInterpolated(s)) {
                      const bool is_last = s.values.rule.provoking == ProvokingVertex::kLast;
                      return {{std::clamp(s.numbers[is_last ? 2 : 0], 0.0, 1.0), 0, 0.0}};
                    }
                    MadeNumber made = Estimated(s, s.channel.interpolation, s.numbers, PlaceOf(s));
                    made.value = std::clamp(made.value, 0.0, 1.0);
                    return {made};
                  }});
  list.push_back({"subnormals", "flushes values to zero", [](const ShownNumber& s) -> Made {
                    const double least = LeastNormal(s.values.precision);
                    if (!IsInterpolated(s)) return {};
                    const MadeNumber made =
                        Estimated(s, s.channel.interpolation, s.numbers, PlaceOf(s));
                    if (std::fabs(made.value) < least) return {{0, 0, 0.0}};
                    return {};
                  }});
  for (const int by : {1, -1}) {
    list.push_back({"wrong-quantity",
                    by > 0 ? "shows the next channel's values" : "shows the channel before",
                    [by](const ShownNumber& s) -> Made {
                      const std::vector<Channel>& all = s.values.channels;
                      const std::size_t other =
                          (s.entry + all.size() + static_cast<std::size_t>(by)) % all.size();
                      const Channel& channel = all[other];
                      const VertexNumbers a = NumbersAt(s.f, channel);
                      if (channel.interpolation == Interpolation::kFlat) {
                        const bool is_last = s.values.rule.provoking == ProvokingVertex::kLast;
                        return {{a[is_last ? 2 : 0], 0}};
                      }
                      return {Estimated(s, channel.interpolation, a, PlaceOfValue(s.f, channel))};
                    }});
  }
}

void AddInverses(std::vector<Mistake>& list) {
  list.push_back({"wrong-quantity", "shows w where 1/w is asked for",
                  [](const ShownNumber& s) -> Made { return {WAt(s, PlaceOf(s))}; }});
  list.push_back({"affine-weights", "interpolates w on the screen, and shows 1 over it",
                  [](const ShownNumber& s) -> Made {
                    const RayCorners& v = s.owners.corners.front();
                    const MadeNumber w =
                        Estimated(s, Interpolation::kLinear, {v[0].w, v[1].w, v[2].w}, PlaceOf(s));
                    return {{1 / w.value, w.condition / (w.value * w.value)}};
                  }});
}

MadeNumber DepthOf(const ShownNumber& s) {
  return Estimated(s, Interpolation::kInverseW, s.numbers, PlaceOf(s));
}

// Of a depth in [0, 1]: `times` it and `plus`.
void AddDepthMap(std::vector<Mistake>& list, std::string what, double times, double plus) {
  list.push_back({"depth-range", std::move(what), [times, plus](const ShownNumber& s) -> Made {
                    MadeNumber z = DepthOf(s);
                    z.value = times * z.value + plus;
                    return {z};
                  }});
}

// How far off a depth may be before it is rounded.
double DepthMargin(const ShownNumber& s, const MadeNumber& z) {
  const ValueError& error = s.values.rule.error;
  return error.IsStated() ? error.absolute
                          : kUsualConditions * UnitRoundoff(s.values.precision) * z.condition;
}

// The nearest multiple of a step of 2^-n or 1 / n, rounded once.
double OnGrid(double x, double step) {
  const double most = std::nearbyint(1 / step);
  return std::nearbyint(x * most) / most;
}

// The multiple of `step` that is shown, if it is beside the depth, or else the nearest to that; as
// a double or a float.
Made RoundedDepth(const ShownNumber& s, double step) {
  const MadeNumber z = DepthOf(s);
  const double clamped = std::clamp(z.value, 0.0, 1.0);
  double made = OnGrid(s.x, step);
  if (!(std::fabs(made - clamped) <= step / 2 + DepthMargin(s, z))) made = OnGrid(clamped, step);
  return {{made, 0, 0.0}, {static_cast<double>(static_cast<float>(made)), 0, 0.0}};
}

// Rounded down to a code of the format; not known where the depth may be of either of two.
Made TruncatedDepth(const ShownNumber& s, double step) {
  const MadeNumber z = DepthOf(s);
  const double codes = std::clamp(z.value, 0.0, 1.0) / step;
  const double code = std::floor(codes);
  const double part = codes - code;
  if (!(std::min(part, 1 - part) > DepthMargin(s, z) / step)) return {{std::nan(""), 0}};
  const double made = code / std::nearbyint(1 / step);
  return {{made, 0, 0.0}, {static_cast<double>(static_cast<float>(made)), 0, 0.0}};
}

void AddDepths(std::vector<Mistake>& list) {
  list.push_back({"wrong-quantity", "shows w where a depth is asked for",
                  [](const ShownNumber& s) -> Made { return {WAt(s, PlaceOf(s))}; }});
  list.push_back(
      {"affine-weights", "interpolates z/w in perspective", [](const ShownNumber& s) -> Made {
         const RayCorners& v = s.owners.corners.front();
         VertexNumbers over = s.numbers;
         for (std::size_t i = 0; i < 3; ++i) over[i] /= v[i].w;
         return {Estimated(s, Interpolation::kPerspective, over, PlaceOf(s))};
       }});
  AddDepthMap(list, "maps depths from [0, 1] to [-1, 1]", 2, -1);
  AddDepthMap(list, "maps depths from [-1, 1] to [0, 1]", 0.5, 0.5);
  AddDepthMap(list, "shows 1 - z", -1, 1);
  list.push_back(
      {"depth-range", "does not clamp depths to [0, 1]", [](const ShownNumber& s) -> Made {
         MadeNumber z = DepthOf(s);
         if (z.value >= 0 && z.value <= 1) return {};
         z.within = kUsualConditions * UnitRoundoff(s.values.precision) * z.condition;
         return {z};
       }});
  list.push_back({"depth-rounding", "rounds depths down", [](const ShownNumber& s) -> Made {
                    const double step = DepthStep(s.values.rule.depth);
                    return step != 0 ? TruncatedDepth(s, step) : Made();
                  }});
  for (const auto& [bits, most] : {std::pair(16, 0xffff), std::pair(24, 0xffffff)}) {
    list.push_back({"depth-rounding",
                    std::string("keeps depths in ").append(std::to_string(bits)).append(" bits"),
                    [step = 1.0 / most](const ShownNumber& s) -> Made {
                      return step != DepthStep(s.values.rule.depth) ? RoundedDepth(s, step)
                                                                    : Made();
                    }});
    list.push_back({"depth-rounding",
                    std::string("cuts depths to ").append(std::to_string(bits)).append(" bits"),
                    [step = 1.0 / most](const ShownNumber& s) -> Made {
                      return step != DepthStep(s.values.rule.depth) ? TruncatedDepth(s, step)
                                                                    : Made();
                    }});
    list.push_back(
        {"depth-rounding",
         std::string("cuts depths to multiples of 2^-").append(std::to_string(bits)),
         [bits](const ShownNumber& s) { return TruncatedDepth(s, std::ldexp(1.0, -bits)); }});
    list.push_back(
        {"depth-rounding",
         std::string("rounds depths to multiples of 2^-").append(std::to_string(bits)),
         [bits](const ShownNumber& s) { return RoundedDepth(s, std::ldexp(1.0, -bits)); }});
  }
}

}  // namespace

std::string_view WordsOf(ListNeighbour side) {
  return side == ListNeighbour::kBefore ? "the triangle before in the list"
                                        : "the next triangle in the list";
}

bool ShownNumber::HasTriangle(ListNeighbour side) const {
  const auto count = static_cast<int>(values.scene->triangles.size());
  return side == ListNeighbour::kBefore ? f.triangle > 0 : f.triangle + 1 < count;
}

std::optional<OtherPlane> ShownNumber::PlaneOf(ListNeighbour side) const {
  const OtherTriangle* const other =
      side == ListNeighbour::kBefore ? triangle_before : triangle_after;
  if (other == nullptr) return std::nullopt;
  OtherPlane plane{*other->corners, numbers};
  for (std::size_t i = 0; i < 3 && !channel.values.empty(); ++i)
    plane.numbers[i] = channel.values[static_cast<std::size_t>(other->vertices[i])];
  return plane;
}

MadeNumber ValueOfPlane(const RayCorners& v, Interpolation plane, const VertexNumbers& a,
                        Point2 p) {
  const ValueEstimate e = EstimateValue(v, plane, a, p);
  return {e.value, e.condition};
}

MadeNumber WOfPlane(const RayCorners& v, Point2 p) {
  const MadeNumber over = ValueOfPlane(v, Interpolation::kInverseW, {1, 1, 1}, p);
  return {1 / over.value, over.condition / (over.value * over.value)};
}

std::vector<Mistake> MistakesOf(NumbersOf what) {
  std::vector<Mistake> list;
  if (what == NumbersOf::kDerivatives) return MistakesOfDerivatives();
  AddPlanes(list);
  if (what == NumbersOf::kInverseW) {
    AddInverses(list);
    return list;
  }
  AddExchanges(list);
  AddFlat(list);
  AddPlaces(list);
  AddOtherTriangles(list);
  if (what == NumbersOf::kDepths) AddDepths(list);
  if (what == NumbersOf::kChannels) AddQuantities(list);
  return list;
}

}  // namespace rasterproof::props
