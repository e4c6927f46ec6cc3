#include "props/judging/values/value_queries.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "core/profile.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/redraw.h"
#include "props/judging/values/compared_numbers.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_channels.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostValueFragments = 24;
constexpr std::size_t kMostLookedAt = 1024;  // to see whether they lie on an edge
// A w farther from 1 than this, or its reciprocal, makes products of the usual forms leave float32.
constexpr double kUsualW = 0x1p30;

bool HasFiniteCorners(const RayCorners& v) {
  return std::ranges::all_of(v, [](const RayCorner& corner) {
    return std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.w);
  });
}

// The known corners: as given, or at their places on the grid.
std::optional<ValueOwners> Known(const PlacedCase& c, const Triangle& t, bool is_snapped) {
  if (is_snapped && c.scene.clip_space && c.why_not_placed) return std::nullopt;
  const std::array<Vertex, 3> given = Corners(c.scene, t);
  const bool is_divided = !c.scene.clip_space || (is_snapped && !c.placed.clip_space);
  ValueOwners owners;
  RayCorners& v = owners.corners.emplace_back();
  std::array<Point2, 3> at{};
  std::array<double, 3> w{1, 1, 1};
  const std::array<Vertex, 3> placed = Corners(is_snapped ? c.placed : c.scene, t);
  for (std::size_t i = 0; i < 3; ++i) {
    if (c.scene.clip_space) w[i] = given[i].w;
    at[i] = WindowPoint(placed[i]);
    v[i] = is_divided ? RayCorner{at[i].x * w[i], at[i].y * w[i], w[i]}
                      : RayCorner{given[i].x, given[i].y, given[i].w};
  }
  if (!HasFiniteCorners(v)) return std::nullopt;
  owners.known = is_divided ? exact::WindowTriangle(at, w) : exact::ClipTriangle(given);
  return owners;
}

// In clip space: within a step of the coarsest legal grid from the quotient, and what the subject's
// own division may be off.
std::optional<std::array<LegalPlaces, 3>> PlacesInClipSpace(const PlacedCase& c,
                                                            const std::array<Vertex, 3>& v) {
  const Freedom& freedom = c.profile.freedom;
  if (!freedom.transform_error || c.profile.contract != Contract::kSampleExact) return std::nullopt;
  const int bits = freedom.least_bits.value_or(c.profile.snap.bits);
  const double step = bits == Snap::kNone ? 0 : std::ldexp(1 + freedom.snap_tolerance, -bits);
  std::array<LegalPlaces, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(v[i].w > 0)) return std::nullopt;
    const auto around = [&](double x) {
      const double q = x / v[i].w;
      const double reach = step + std::fabs(q) * (*freedom.transform_error * 0x1p-24 + 0x1p-50);
      return std::pair(q - reach, q + reach);
    };
    const auto [x0, x1] = around(v[i].x);
    const auto [y0, y1] = around(v[i].y);
    places[i] = {{x0, y0}, {x1, y1}};
  }
  return places;
}

// All ends of the rectangles; the corners as given are among what lies between.
std::optional<ValueOwners> Free(const PlacedCase& c, const Triangle& t) {
  const std::array<Vertex, 3> given = Corners(c.scene, t);
  auto places = c.scene.clip_space ? PlacesInClipSpace(c, given) : LegalPlacesOf(c, t);
  if (!places) return std::nullopt;
  std::array<double, 3> w{1, 1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    auto& [low, high] = (*places)[i];
    if (c.scene.clip_space) {
      w[i] = given[i].w;
    } else {
      low = {std::min(low.x, given[i].x), std::min(low.y, given[i].y)};
      high = {std::max(high.x, given[i].x), std::max(high.y, given[i].y)};
    }
  }
  ValueOwners owners;
  for (unsigned ends = 0; ends < 64; ++ends) {
    RayCorners& v = owners.corners.emplace_back();
    for (unsigned i = 0; i < 3; ++i) {
      const auto& [low, high] = (*places)[i];
      const double x = (ends >> 2 * i & 1U) != 0 ? high.x : low.x;
      const double y = (ends >> (2 * i + 1) & 1U) != 0 ? high.y : low.y;
      v[i] = {x * w[i], y * w[i], w[i]};
    }
    if (!HasFiniteCorners(v)) return std::nullopt;
  }
  return owners;
}

// Whether clipping leaves the triangle as it is: of a polygon of more edges, whose new vertices are
// placed anew, specifications ask for no more than a value in the hull.
bool IsLeftWhole(const PlacedCase& c, const Triangle& t) {
  const auto box = UnclippedBox(c.profile, c.scene.width, c.scene.height);
  return !box || std::ranges::all_of(Corners(c.scene, t), [&](const Vertex& v) {
    const double w = c.scene.clip_space ? v.w : 1;
    return w > 0 && box->Contains(v.x / w, v.y / w);
  });
}

std::vector<ValueOwners> ReadingsOf(const PlacedCase& c, const SubjectInfo& info,
                                    const Triangle& t) {
  const BarycentricsOf of = info.fragments.barycentrics_of;
  std::vector<ValueOwners> readings;
  const auto add = [&](std::optional<ValueOwners> owners) {
    if (!owners) return false;
    readings.push_back(*std::move(owners));
    return true;
  };
  if (LeavesGridPointsOpen(c.profile) && !IsLeftWhole(c, t)) return {};
  if (of != BarycentricsOf::kGiven && LeavesGridPointsOpen(c.profile)) {
    return add(Free(c, t)) ? std::move(readings) : std::vector<ValueOwners>();
  }
  const bool is_snapped = !c.profile.snap.IsNone() || c.profile.fixed.has_value();
  if (of != BarycentricsOf::kSnapped || !is_snapped) {
    if (!add(Known(c, t, false))) return {};
  }
  if (of != BarycentricsOf::kGiven && is_snapped) {
    if (!add(Known(c, t, true))) return {};
  }
  return readings;
}

// A condition bounds an error to first order: of n / d, with d off by a share e of itself, it grows
// by 1 / (1 - e). Nothing where d may be half as large as it should be.
std::optional<double> GrowthOf(double denominator_condition, double conditions,
                               Precision precision) {
  const double share = conditions * UnitRoundoff(precision) * denominator_condition;
  return share < 0.5 ? std::optional(1 / (1 - share)) : std::nullopt;
}

// Whether the usual forms keep within the format's range, and what they lose where they underflow:
// each product, and the value itself, at most half the least subnormal, which is u times the least
// normal number. Who flushes loses up to that, of the vertices' numbers too.
std::optional<double> UsualUnderflow(const ShownValues& shown, const ValueEstimate& e,
                                     const RayCorners& v, const std::array<double, 3>& numbers,
                                     double condition) {
  const Precision precision = shown.precision;
  const double most = precision == Precision::kFloat32 ? 0x1p126 : 0x1p1022;
  double largest = std::fabs(e.value);
  double largest_w = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(v[i].w >= 1 / kUsualW && v[i].w <= kUsualW)) return std::nullopt;
    largest = std::max(largest, std::fabs(numbers[i]));
    largest_w = std::max(largest_w, v[i].w);
  }
  const double denominator = std::fabs(e.denominator);
  if (!(condition * std::max(denominator, 1.0) < most)) return std::nullopt;
  const double lost = LeastNormal(precision) * (1 + 8 * largest_w * (1 + largest) / denominator);
  return kUsualConditions * UnitRoundoff(precision) * lost +
         (shown.rule.flushes ? lost + LeastNormal(precision) * e.denominator_condition : 0);
}

std::optional<double> ToleranceOf(const ShownValues& shown, const ValueEstimate& e,
                                  const RayCorners& v, Interpolation interpolation,
                                  const std::array<double, 3>& numbers, Point2 p) {
  const ValueError& error = shown.rule.error;
  const double u = UnitRoundoff(shown.precision);
  if (error.IsStated()) {
    const auto growth = GrowthOf(e.denominator_condition, error.conditions, shown.precision);
    if (!growth || std::fabs(e.value) > LargestNumber(shown.precision)) return std::nullopt;
    return error.ulps * UlpOf(e.value, shown.precision) + error.absolute +
           *growth * error.conditions * u * e.condition;
  }
  const UsualConditions usual = UsualConditionsOf(v, interpolation, numbers, p);
  const auto growth = GrowthOf(usual.denominator, kUsualConditions, shown.precision);
  const auto lost = UsualUnderflow(shown, e, v, numbers, usual.value);
  if (!growth || !lost) return std::nullopt;
  return *growth * (kUsualConditions * u * usual.value + *lost);
}

// Whether no exchange of two vertices, and no other plane, gives what may be shown.
bool TellsMistakes(const ValueRange& range, const ValueFragment& f, const RayCorners& v,
                   const Channel& channel, const std::array<double, 3>& a) {
  const Point2 p = PlaceOfValue(f, channel);
  const auto tells = [&](Interpolation interpolation, const std::array<double, 3>& numbers) {
    return range.SurelyExcludes(EstimateValue(v, interpolation, numbers, p).value);
  };
  const bool is_perspective = channel.interpolation == Interpolation::kPerspective;
  if (is_perspective || channel.interpolation == Interpolation::kLinear) {
    if (!tells(channel.interpolation, {a[1], a[0], a[2]})) return false;
    if (!tells(channel.interpolation, {a[0], a[2], a[1]})) return false;
  }
  if (v[0].w == v[1].w && v[1].w == v[2].w) return true;
  return tells(is_perspective ? Interpolation::kLinear : Interpolation::kPerspective, a);
}

std::vector<Point2> PointsOf(Point2 at, double reach) {
  if (reach == 0) return {at};
  return {{at.x - reach, at.y - reach},
          {at.x + reach, at.y - reach},
          {at.x - reach, at.y + reach},
          {at.x + reach, at.y + reach}};
}

// Exactly: by corners that are known.
bool IsAtACorner(const ValueFragment& f) {
  return std::ranges::any_of(f.readings, [&](const ValueOwners& owners) {
    if (!owners.known) return false;
    const auto is_here = [&](const exact::HomogeneousPoint& v) {
      return v.w.Sign() != 0 && v.x == v.w * f.place.at.x && v.y == v.w * f.place.at.y;
    };
    return std::ranges::any_of(*owners.known, is_here);
  });
}

// Exactly: on the line opposite the third corner.
bool IsOnTheFirstEdge(const ValueFragment& f) {
  return std::ranges::all_of(f.readings, [&](const ValueOwners& owners) {
    if (!owners.known) return false;
    const auto weights = WeightsOfPower(owners.corners.front(), 0, f.place.at);
    const double sum = std::fabs(weights[0]) + std::fabs(weights[1]) + std::fabs(weights[2]);
    if (std::fabs(weights[2]) > sum * 0x1p-20) return false;
    const auto exact =
        exact::Interpolant(*owners.known, f.place.at).Weights(Interpolation::kLinear);
    return exact && (*exact)[2].Sign() == 0;
  });
}

// Near enough to be asked exactly.
bool IsNearACorner(const PlacedCase& c, const Triangle& t, Point2 p) {
  constexpr double kNear = 1;
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  return std::ranges::any_of(v, [&](const Vertex& corner) {
    const double w = c.scene.clip_space ? corner.w : 1;
    return std::fabs(corner.x / w - p.x) <= kNear && std::fabs(corner.y / w - p.y) <= kNear;
  });
}

}  // namespace

std::array<double, 3> NumbersAt(const ValueFragment& f, const Channel& channel) {
  if (channel.interpolation == Interpolation::kInverseW) return {1, 1, 1};
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i)
    numbers[i] = channel.values[static_cast<std::size_t>(f.vertices[i])];
  return numbers;
}

Point2 PlaceOfValue(const ValueFragment& f, const Channel& channel) {
  if (channel.at == EvaluatedAt::kCentroid && f.centroid) return *f.centroid->at;
  return channel.at == EvaluatedAt::kCentre ? f.centre : f.place.at;
}

std::optional<ValueRange> RangeOf(const ShownValues& shown, const ValueFragment& f,
                                  const ValueOwners& owners, const Channel& channel,
                                  const std::array<double, 3>& numbers) {
  const double reach = channel.at == EvaluatedAt::kCentre ? 0 : f.reach;
  ValueRange range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  std::optional<bool> is_negative;
  for (const RayCorners& v : owners.corners) {
    for (const Point2 p : PointsOf(PlaceOfValue(f, channel), reach)) {
      const ValueEstimate e = EstimateValue(v, channel.interpolation, numbers, p);
      if (!std::isfinite(e.value) || !std::isfinite(e.condition)) return std::nullopt;
      // Beyond what double tells, only the exact decision of known owners is left.
      const bool is_told = kEstimateError * e.denominator_condition < 0.5;
      if (!owners.known && !is_told) return std::nullopt;
      if (is_negative && *is_negative != std::signbit(e.denominator)) return std::nullopt;
      is_negative = std::signbit(e.denominator);
      const std::optional<double> tolerance =
          ToleranceOf(shown, e, v, channel.interpolation, numbers, p);
      if (!tolerance || !std::isfinite(*tolerance)) return std::nullopt;
      range.low = std::min(range.low, e.value);
      range.high = std::max(range.high, e.value);
      range.margin = std::max(range.margin, kEstimateError * e.condition);
      range.tolerance = std::max(range.tolerance, *tolerance);
    }
  }
  return range;
}

ValueFragment FragmentAt(const PlacedCase& c, const SubjectInfo& info, const Drawing& drawing,
                         std::size_t index, const std::vector<ValueOwners>* readings) {
  ValueFragment f;
  f.index = index;
  f.triangle = drawing.primitive_ids[f.index];
  f.vertices = c.scene.triangles[static_cast<std::size_t>(f.triangle)];
  const Witness at = WitnessAtIndex(drawing.counts, f.index);
  f.place = PlaceOf(c, at.x, at.y, at.sample);
  f.reach = SampleReach(c.profile);
  const Point2 location = c.profile.pattern.locations[static_cast<std::size_t>(at.sample)];
  f.centre = {f.place.at.x - location.x + 0.5, f.place.at.y - location.y + 0.5};
  f.readings = readings != nullptr ? *readings : ReadingsOf(c, info, f.vertices);
  return f;
}

std::vector<ValueFragment> FragmentsOf(const PlacedCase& c, const SubjectInfo& info,
                                       const Drawing& drawing, FragmentChoice choice) {
  std::vector<std::size_t> covered;
  for (std::size_t k = 0; k < drawing.primitive_ids.size(); ++k) {
    if (drawing.primitive_ids[k] == kNoPrimitive) continue;
    if (choice == FragmentChoice::kAtVertices) {
      const Triangle& t = c.scene.triangles[static_cast<std::size_t>(drawing.primitive_ids[k])];
      const Witness at = WitnessAtIndex(drawing.counts, k);
      if (!IsNearACorner(c, t, PlaceOf(c, at.x, at.y, at.sample).at)) continue;
    }
    covered.push_back(k);
  }
  if (choice == FragmentChoice::kInPartOfAPixel) {
    const auto is_part = [&](std::size_t k) {
      return std::ranges::count(CoveredInPixel(drawing, k), false) != 0;
    };
    if (std::ranges::any_of(covered, is_part)) std::erase_if(covered, std::not_fn(is_part));
  }
  std::vector<ValueFragment> some;
  const std::size_t most =
      choice == FragmentChoice::kOnTheFirstEdge ? kMostLookedAt : kMostValueFragments;
  for (std::size_t n = 0; n < covered.size(); n += covered.size() / most + 1) {
    ValueFragment f = FragmentAt(c, info, drawing, covered[n]);
    if (f.readings.empty()) continue;
    if (choice == FragmentChoice::kAtVertices && !IsAtACorner(f)) continue;
    if (choice == FragmentChoice::kOnTheFirstEdge && !IsOnTheFirstEdge(f)) continue;
    some.push_back(std::move(f));
  }
  return some;
}

Verdict JudgeFragment(const ShownValues& shown, const ValueFragment& f, ValueJudge judge) {
  std::optional<Verdict> first;
  for (const ValueOwners& owners : f.readings) {
    Verdict verdict = judge(shown, f, owners);
    if (verdict.outcome != Outcome::kViolated) return verdict;
    if (!first) first = std::move(verdict);
  }
  return *std::move(first);
}

std::optional<double> DerivativeTolerance(const ShownValues& shown, const ValueFragment& f,
                                          const RayCorners& v, const Channel& channel, int axis,
                                          const std::array<Point2, 2>& ends) {
  const std::array<double, 3> a = NumbersAt(f, channel);
  const Interpolation by = channel.interpolation;
  const bool is_of_plane = ends[0] == ends[1];
  const auto k = static_cast<std::size_t>(axis);
  const double u = UnitRoundoff(shown.precision);
  const ValueError& error = shown.rule.derivative_error;
  double tolerance = 0;
  for (const Point2 p : ends) {
    const ValueEstimate e = EstimateValue(v, by, a, p);
    const UsualConditions usual = UsualConditionsOf(v, by, a, p);
    const double conditions = error.IsStated() ? error.conditions : 2 * kUsualConditions;
    const double condition = error.IsStated()
                                 ? is_of_plane ? e.derivative_conditions[k] : e.condition
                             : is_of_plane ? usual.derivatives[k]
                                           : usual.value;
    const auto growth = GrowthOf(error.IsStated() ? e.denominator_condition : usual.denominator,
                                 conditions, shown.precision);
    if (!growth || !std::isfinite(condition)) return std::nullopt;
    double lost = 0;
    if (!error.IsStated()) {
      const auto underflow = UsualUnderflow(shown, e, v, a, condition);
      if (!underflow) return std::nullopt;
      lost = 2 * *underflow;
    }
    // The denominator is in a derivative squared.
    tolerance += *growth * *growth * (conditions * u * condition + lost);
    if (is_of_plane) break;
  }
  return error.absolute + tolerance;
}

ValueCheck CheckValue(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners,
                      const Channel& channel, const std::array<double, 3>& numbers, double x) {
  ValueCheck check;
  const std::optional<ValueRange> range = RangeOf(shown, f, owners, channel, numbers);
  if (!range) return check;
  check.is_judged = true;
  const RayCorners& first = owners.corners.front();
  check.tells = TellsMistakes(*range, f, first, channel, numbers);
  if (!check.tells && shown.rule.error.IsStated()) {
    ValueRange exact = *range;
    exact.tolerance = 0;
    check.is_too_wide = TellsMistakes(exact, f, first, channel, numbers);
  }
  if (range->SurelyHolds(x)) {
    const double off = std::max({range->low - x, x - range->high, 0.0});
    check.ratio = range->tolerance > 0 ? off / range->tolerance : 0;
    return check;
  }
  if (!owners.known) {
    check.holds = !range->SurelyExcludes(x);
    check.expected = {"between ", range->low, " and ", range->high, " within ", range->tolerance};
    return check;
  }
  const exact::Interpolant interpolant(*owners.known, PlaceOfValue(f, channel));
  const exact::Attribute a = exact::ToAttribute(numbers);
  const auto value = interpolant.Value(channel.interpolation, a);
  if (!value) return {};
  // A tolerance of the usual forms is worked out in double as it is meant.
  exact::Rational allowed = range->tolerance;
  if (shown.rule.error.IsStated()) {
    const exact::Rational condition = interpolant.Conditions(channel.interpolation, a)->value;
    const auto e = EstimateValue(first, channel.interpolation, numbers, PlaceOfValue(f, channel));
    ValueError error = shown.rule.error;
    error.conditions *= *GrowthOf(e.denominator_condition, error.conditions, shown.precision);
    allowed = exact::Allowed(*value, condition, error, shown.precision);
  }
  const Distance distance = CompareWithExact(x, *value, allowed);
  check.ratio = distance.ratio;
  check.holds = distance.within;
  check.expected = {Exactly(*value), " within ", range->tolerance};
  return check;
}

bool IsInside(const ValueFragment& f, const ValueOwners& owners, const Channel& channel) {
  const Point2 p = PlaceOfValue(f, channel);
  if (owners.known) {
    const auto weights = exact::Interpolant(*owners.known, p).Weights(Interpolation::kPerspective);
    return weights &&
           std::ranges::all_of(*weights, [](const exact::Rational& l) { return l.Sign() >= 0; });
  }
  // Well inside, whichever combination it is.
  return std::ranges::all_of(owners.corners, [&](const RayCorners& v) {
    const auto [b0, b1, b2] = WeightsOfPower(v, 0, p);
    const double sum = b0 + b1 + b2;
    constexpr double kLeast = 0x1p-20;
    return std::min({b0 / sum, b1 / sum, b2 / sum}) > kLeast;
  });
}

std::shared_ptr<const Scene> SceneWithChannels(const PlacedCase& c) {
  auto scene = std::make_shared<Scene>(c.scene);
  scene->channels = ChannelsFor(c.scene, c.profile.values);
  return scene;
}

namespace {

// A draw of the scene; its answer is held to the rule.
Checks AskOf(const PlacedCase& c, const Description& subject, std::shared_ptr<const Scene> scene,
             const Outputs& wants, const ValueRule& rule, ValueJudge judge, FragmentChoice choice) {
  Questions questions;
  questions.draws.push_back(WholeCallOf(*scene, c.profile, c.options));
  questions.draws.back().job.wants = wants;
  return OneCheck(std::move(questions), [&c, &subject, judge, choice, rule,
                                         scene = std::move(scene)](const Answers& answers) {
    const Drawing& drawing = *answers.draws[0];
    const ShownValues shown{drawing,
                            scene->channels,
                            rule,
                            subject.info.input,
                            c.profile.y_axis == YAxis::kUp,
                            c.scene.clip_space,
                            scene.get()};
    const std::vector<ValueFragment> some = FragmentsOf(c, subject.info, drawing, choice);
    Verdict verdict =
        OneByOne(some.size(), [&](std::size_t k) { return JudgeFragment(shown, some[k], judge); });
    AddNumbersAround(c, subject.info, shown, verdict);
    return verdict;
  });
}

// Different numbers in [1/16, 15/16], exact with a factor w of few bits.
double DepthOf(std::size_t vertex) { return static_cast<double>(1 + (5 * vertex) % 15) / 16; }

}  // namespace

Checks AskValues(const PlacedCase& c, const Description& subject, const Outputs& wants,
                 ValueJudge judge, FragmentChoice choice) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  return AskOf(c, subject, SceneWithChannels(c), wants, c.profile.values, judge, choice);
}

Checks AskFragmentValues(const PlacedCase& c, const Description& subject, const Outputs& wants,
                         ValueJudge judge) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  auto scene = std::make_shared<Scene>(c.scene);
  const bool is_float = scene->precision == Precision::kFloat32;
  for (std::size_t k = 0; k < scene->vertices.size(); ++k) {
    Vertex& v = scene->vertices[k];
    const double z = scene->clip_space ? DepthOf(k) * v.w : DepthOf(k);
    v.z = is_float ? static_cast<double>(static_cast<float>(z)) : z;
  }
  const FragmentInfo& info = subject.info.fragments;
  ValueRule rule = c.profile.values;
  rule.error = {.absolute = wants.depths ? info.depth_error : info.barycentric_error};
  return AskOf(c, subject, std::move(scene), wants, rule, judge, FragmentChoice::kSome);
}

}  // namespace rasterproof::props
