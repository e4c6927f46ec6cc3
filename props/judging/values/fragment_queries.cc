#include "props/judging/values/fragment_queries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "core/drawing.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// Exact barycentrics are rationals, some ten microseconds each.
constexpr std::size_t kMostFragments = 24;
// All tolerances below take the format's fl(x op y) = (x op y)(1 + d), |d| <= u, and a product or a
// quotient that underflows as off by eta / 2 more. They are worked out in double, to first order in
// u; this factor covers both: what is left out is at most some 2^5 u of a bound, 2^-19 in float32,
// and what double rounds is at most 2^5 2^-53 of it.
constexpr double kSecondOrderFactor = 1 + 0x1p-16;

// Of the five-operation form: each product carries three roundings and the difference one more,
// 3 u S + u |E|, and |E| <= S. Only its two products can underflow: eta / 2 each, doubled once more
// by the last rounding at most.
constexpr double kEdgeErrorMultiplier = 4;
constexpr double kEdgeUnderflows = 2;

// Of the sum of three edge values as the area: two additions, each off by u times at most the sum
// of the values' magnitudes.
constexpr double kAreaSumErrorMultiplier = 2;

// Of a depth, in u of max |z| times W = sum |l_i|, which is at least 1 because the barycentrics sum
// to one. By barycentrics: a product, and two additions of partial sums, 3 W. By deltas from one
// vertex, with z of one sign: a difference and a product for each of two barycentrics, 2 W; two
// additions of partial sums of at most 1 + W each, 4 W.
constexpr double kDepthErrorMultiplier = 6;

// Where sums of products stay below this, nothing that the forms compute overflows: what they round
// and add to it is less than a factor of four.
constexpr double MostSumOfProducts(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p126 : 0x1p1022;
}

double SumOfProducts(Point2 a, Point2 b, Point2 p) {
  return std::fabs((p.x - a.x) * (b.y - a.y)) + std::fabs((p.y - a.y) * (b.x - a.x));
}

double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

double EdgeTolerance(Point2 a, Point2 b, Point2 p, Precision precision) {
  const double u = UnitRoundoff(precision);
  return kSecondOrderFactor * (kEdgeErrorMultiplier * u * SumOfProducts(a, b, p) +
                               kEdgeUnderflows * SmallestSubnormal(precision));
}

using Points3 = std::array<Point2, 3>;

bool Overflows(const Points3& v, Point2 p, Precision precision) {
  const double most = MostSumOfProducts(precision);
  for (int i = 0; i < 3; ++i) {
    if (!(SumOfProducts(EdgeStart(v, i), EdgeEnd(v, i), p) < most)) return true;
  }
  return !(SumOfProducts(v[0], v[1], v[2]) < most);
}

// Depths that no two of 256 vertices in a row share; exact in every format. Far apart,
// or nearly flat in one of three degrees: what is walked or kept coarsely loses small differences.
class Depths {
 public:
  explicit Depths(const Scene& scene) : bits_(kBits[static_cast<std::size_t>(scene.width) % 4]) {}

  double Of(std::size_t vertex) const {
    // Eight places far apart, and 32 next to each.
    const auto place =
        static_cast<double>(1 + 3 * vertex % 8) - static_cast<double>(vertex / 8 % 32) / 32;
    return (bits_ == kBits[0] ? 0 : 0.5) + std::ldexp(place, -bits_);
  }

 private:
  static constexpr std::array kBits{3, 7, 11, 15};

  int bits_;
};

// `size`: the sum of the exact barycentrics' magnitudes, at most.
double DepthTolerance(const SubjectInfo& info, const Fragment& f, double size) {
  const double step = DepthStep(info.profile.values.depth);
  if (info.fragments.depth_error > 0) return info.fragments.depth_error + step;
  const double u = UnitRoundoff(info.input);
  // Barycentrics that are off by t_i move the depth by at most sum t_i max |z|, by barycentrics or,
  // z being of one sign, by deltas.
  double barycentric_error = 0;
  for (const double tolerance : f.barycentric_tolerances) barycentric_error += tolerance;
  const double largest = std::max({std::fabs(f.z[0]), std::fabs(f.z[1]), std::fabs(f.z[2])});
  return kSecondOrderFactor *
             (barycentric_error + kDepthErrorMultiplier * u * (size + barycentric_error)) *
             largest +
         step;
}

double SizeOfBarycentrics(const BarycentricQuery& q) {
  double size = 0;
  for (const exact::Rational& barycentric : ExactBarycentrics(q)) {
    size += std::fabs(barycentric.ToDouble());
  }
  return size;
}

// A triangle's edge values and area at a sample with their errors, to derive barycentrics from.
struct EdgeErrors {
  std::array<double, 3> value{};      // |E_i|, at most
  std::array<double, 3> tolerance{};  // of E_i
  double area = 0;                    // |area|, at least, and as the subject may see it
  double area_tolerance = 0;          // of the area, computed by itself or as the sum of the E_i
};

EdgeErrors EdgeErrorsAt(const Points3& v, Point2 p, Precision precision) {
  EdgeErrors errors;
  double sum = 0;
  double sum_tolerance = 0;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Point2 a = EdgeStart(v, i);
    const Point2 b = EdgeEnd(v, i);
    errors.tolerance[k] = EdgeTolerance(a, b, p, precision);
    errors.value[k] = std::fabs(EdgeValue(a, b, p)) + errors.tolerance[k];
    sum += errors.value[k] + errors.tolerance[k];
    sum_tolerance += errors.tolerance[k];
  }
  const double alone = EdgeTolerance(v[0], v[1], v[2], precision);
  sum_tolerance += kAreaSumErrorMultiplier * UnitRoundoff(precision) * sum;
  errors.area_tolerance = std::max(alone, sum_tolerance);
  // Once for what the subject divides by, once for the value that is worked out here.
  errors.area = std::fabs(EdgeValue(v[0], v[1], v[2])) - errors.area_tolerance - alone;
  return errors;
}

// The worst of both, part by part.
EdgeErrors Worst(const EdgeErrors& a, const EdgeErrors& b) {
  EdgeErrors worst;
  for (std::size_t i = 0; i < 3; ++i) {
    worst.value[i] = std::max(a.value[i], b.value[i]);
    worst.tolerance[i] = std::max(a.tolerance[i], b.tolerance[i]);
  }
  worst.area = std::min(a.area, b.area);
  worst.area_tolerance = std::max(a.area_tolerance, b.area_tolerance);
  return worst;
}

constexpr std::array<double, 3> kNothingIsStated{kNothing, kNothing, kNothing};

// They grow with each value and tolerance, and as the area gets less.
std::array<double, 3> TolerancesOf(const EdgeErrors& errors, Precision precision) {
  const double u = UnitRoundoff(precision);
  if (!(errors.area > errors.area_tolerance)) return kNothingIsStated;
  std::array<double, 3> barycentric{};  // |l_i|, at most
  std::array<double, 3> quotient{};     // tolerance of E_i over the area
  for (std::size_t i = 0; i < 3; ++i) {
    barycentric[i] = errors.value[i] / errors.area;
    quotient[i] =
        kSecondOrderFactor *
            ((errors.tolerance[i] + barycentric[i] * errors.area_tolerance) / errors.area +
             u * barycentric[i]) +
        SmallestSubnormal(precision);
  }
  std::array<double, 3> tolerances = quotient;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    // (1 - l_j) - l_k, in either order: a difference of at most 1 + |l|, and the last rounding.
    const double rounded = u * (1 + std::max(barycentric[j], barycentric[k]) + barycentric[i]);
    tolerances[i] =
        std::max(quotient[i], kSecondOrderFactor * (quotient[j] + quotient[k] + rounded));
  }
  return tolerances;
}

// The sample is where the pattern puts it, or anywhere that is as far from there as any place of
// the pixel may be.
LegalPlaces SamplePlacesOf(const PlacedCase& c, Point2 at) {
  const double reach = SampleReach(c.profile);
  return {{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}};
}

// The worst over all places of the sample: S_i, |E_i| and d are convex in p.
EdgeErrors EdgeErrorsOver(const Points3& v, const LegalPlaces& sample, Precision precision) {
  const auto [low, high] = sample;
  EdgeErrors worst = EdgeErrorsAt(v, low, precision);
  if (low == high) return worst;
  for (const Point2 p : {high, Point2{low.x, high.y}, Point2{high.x, low.y}}) {
    worst = Worst(worst, EdgeErrorsAt(v, p, precision));
  }
  return worst;
}

// What holds of a fragment wherever the profile lets its triangle's corners lie.
struct AnyOwners {
  std::array<LegalPlaces, 3> places;
  EdgeErrors errors;
  bool inside = true;
  bool overflows = false;
};

// The corners as given are no grid points, and may lie beside all that are legal.
void AddGiven(const PlacedCase& c, const Triangle& t, std::array<LegalPlaces, 3>& places) {
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  for (std::size_t k = 0; k < 3; ++k) {
    auto& [low, high] = places[k];
    low = {std::min(low.x, v[k].x), std::min(low.y, v[k].y)};
    high = {std::max(high.x, v[k].x), std::max(high.y, v[k].y)};
  }
}

// Edge values and the area are affine in each coordinate of the corners: over rectangles their
// signs are those at the rectangles' corners if all agree there, and their magnitudes and the sums
// of products, being convex, are greatest there. Nothing if the triangle may be flat, or clipped.
std::optional<AnyOwners> OverLegalPlaces(const PlacedCase& c, const Triangle& t, Point2 p,
                                         const SubjectInfo& info) {
  auto places = LegalPlacesOf(c, t);
  if (!places) return std::nullopt;
  if (info.fragments.barycentrics_of == BarycentricsOf::kEither) AddGiven(c, t, *places);
  const Precision precision = info.input;
  const LegalPlaces sample = SamplePlacesOf(c, p);
  std::optional<AnyOwners> all;
  int facing = 0;
  for (unsigned ends = 0; ends < 64; ++ends) {
    Points3 v;
    for (unsigned k = 0; k < 3; ++k) {
      const auto& [low, high] = (*places)[k];
      v[k] = {(ends >> 2 * k & 1U) != 0 ? high.x : low.x,
              (ends >> (2 * k + 1) & 1U) != 0 ? high.y : low.y};
    }
    const int here = exact::Facing(v);
    if (here == 0 || (all && here != facing)) return std::nullopt;
    facing = here;
    const EdgeErrors errors = EdgeErrorsOver(v, sample, precision);
    if (!all) all = AnyOwners{*places, errors};
    all->errors = Worst(all->errors, errors);
    all->inside = all->inside && InClosedTriangle(v, p);
    all->overflows = all->overflows || Overflows(v, p, precision);
  }
  return all;
}

// Fills in the fragment's tolerances; false if nothing holds of it.
bool TolerateAnyOwners(const PlacedCase& c, const SubjectInfo& info, Fragment& f) {
  const Triangle& t = c.scene.triangles[static_cast<std::size_t>(f.query.triangle)];
  const auto any = OverLegalPlaces(c, t, f.query.place.at, info);
  if (!any) return false;
  f.free_places = {any->places, SamplePlacesOf(c, f.query.place.at)};
  f.query.inside = any->inside;
  const double stated = info.fragments.barycentric_error;
  f.barycentric_tolerances = stated > 0       ? std::array<double, 3>{stated, stated, stated}
                             : any->overflows ? kNothingIsStated
                                              : TolerancesOf(any->errors, info.input);
  // Inside the exact ones sum to one in magnitude as well.
  double size = 1;
  if (!any->inside) {
    size = (any->errors.value[0] + any->errors.value[1] + any->errors.value[2]) /
           std::max(any->errors.area, 0.0);
  }
  f.depth_tolerance = DepthTolerance(info, f, size);
  return true;
}

// The draws of a case: asked for all, and for one thing alone.
struct Draws {
  const Drawing& all;
  const Drawing& alone;
  Outputs wanted_alone;

  const Drawing& Of(bool asked_alone) const { return asked_alone ? alone : all; }
};

// What a draw shows of what it was asked for at its k-th sample, before it is asked whose
// barycentrics they are.
Fragment ShownAt(const Draws& draws, bool asked_alone, std::size_t k, const PlacedCase& c) {
  const Drawing& drawing = draws.Of(asked_alone);
  const Outputs& wanted = asked_alone ? draws.wanted_alone : kEverything;
  Fragment f;
  f.asked_alone = asked_alone;
  f.query.triangle = drawing.primitive_ids[k];
  const Witness at = WitnessAtIndex(drawing.counts, k);
  f.query.place = PlaceOf(c, at.x, at.y, at.sample);
  if (wanted.barycentrics) f.barycentrics = drawing.barycentrics[k];
  if (wanted.depths) f.depth = drawing.depths[k];
  return f;
}

// The fragment by these owners, or, of owners that nobody knows, with what holds of any. Nothing if
// they have no area, or nothing holds.
std::optional<Fragment> ReadBy(const Scene& owners, bool are_known, Fragment f, const PlacedCase& c,
                               const SubjectInfo& info) {
  const Triangle& t = owners.triangles[static_cast<std::size_t>(f.query.triangle)];
  const std::array<Vertex, 3> corners = Corners(owners, t);
  for (std::size_t i = 0; i < 3; ++i) {
    f.query.v[i] = WindowPoint(corners[i]);
    f.z[i] = corners[i].z;
  }
  if (!std::ranges::all_of(corners, IsFinite) || exact::Facing(f.query.v) == 0) {
    return std::nullopt;
  }
  f.owners_are_known = are_known;
  if (!are_known) return TolerateAnyOwners(c, info, f) ? std::optional(f) : std::nullopt;
  f.query.inside = InClosedTriangle(f.query.v, f.query.place.at);
  f.barycentric_tolerances = BarycentricTolerances(info, f.query);
  if (SampleReach(c.profile) != 0) {
    const auto& [v0, v1, v2] = f.query.v;
    const LegalPlaces sample = SamplePlacesOf(c, f.query.place.at);
    f.free_places = {{{{v0, v0}, {v1, v1}, {v2, v2}}}, sample};
    if (!(info.fragments.barycentric_error > 0) && IsStated(f.barycentric_tolerances[0])) {
      f.barycentric_tolerances =
          TolerancesOf(EdgeErrorsOver(f.query.v, sample, info.input), info.input);
    }
  }
  f.depth_tolerance = DepthTolerance(info, f, SizeOfBarycentrics(f.query));
  return f;
}

// A fragment by each of the owners that it may be of, one of which explains it.
using Readings = std::vector<Fragment>;

// The vertices that barycentrics may belong to.
struct Owners {
  Scene given;
  Scene snapped;
};

// None if nothing is said of the fragment.
Readings ReadingsAt(const Draws& draws, bool asked_alone, std::size_t k, const Owners& owners,
                    const PlacedCase& c, const SubjectInfo& info) {
  Fragment shown = ShownAt(draws, asked_alone, k, c);
  const Triangle& t = c.scene.triangles[static_cast<std::size_t>(shown.query.triangle)];
  BarycentricsOf of = info.fragments.barycentrics_of;
  if (of == BarycentricsOf::kEither && StaysWhereGiven(c, t)) of = BarycentricsOf::kGiven;
  const bool is_open = of != BarycentricsOf::kGiven && LeavesGridPointsOpen(c.profile);
  // In another draw another choice may be made.
  const bool is_settled = of != BarycentricsOf::kEither && !is_open;
  if (!shown.barycentrics && is_settled && draws.all.primitive_ids[k] == shown.query.triangle) {
    shown.barycentrics = draws.all.barycentrics[k];
  }
  const bool is_of_both = of == BarycentricsOf::kEither && !is_open;
  std::vector<const Scene*> scenes;
  if (of != BarycentricsOf::kSnapped) scenes.push_back(&owners.given);
  if (of == BarycentricsOf::kSnapped || is_of_both) scenes.push_back(&owners.snapped);
  Readings readings;
  for (const Scene* scene : scenes) {
    const std::optional<Fragment> reading = ReadBy(*scene, !is_open, shown, c, info);
    if (!reading) return {};
    readings.push_back(*reading);
  }
  return readings;
}

std::vector<Readings> SomeReadings(const Draws& draws, bool asked_alone, const Owners& owners,
                                   const PlacedCase& c, const SubjectInfo& info) {
  const std::vector<std::int32_t>& ids = draws.Of(asked_alone).primitive_ids;
  std::vector<std::size_t> covered;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k] != kNoPrimitive) covered.push_back(k);
  }
  std::vector<Readings> some;
  for (std::size_t n = 0; n < covered.size(); n += covered.size() / kMostFragments + 1) {
    some.push_back(ReadingsAt(draws, asked_alone, covered[n], owners, c, info));
  }
  return some;
}

// Whether one of the readings holds, or else why the first does not.
Verdict JudgeReadings(const Readings& readings, FragmentJudge judge) {
  std::optional<Verdict> first;
  for (const Fragment& reading : readings) {
    Verdict verdict = judge({reading});
    if (verdict.outcome != Outcome::kViolated) return verdict;
    if (!first) first = std::move(verdict);
  }
  return first ? *std::move(first) : Verdict::Held(0);
}

Verdict JudgeAll(const std::vector<Readings>& fragments, FragmentJudge judge) {
  return OneByOne(fragments.size(),
                  [&](std::size_t k) { return JudgeReadings(fragments[k], judge); });
}

// With the draw whose fragment it is.
Verdict JudgeDraws(const Draws& draws, const Owners& owners, const PlacedCase& c,
                   const SubjectInfo& info, FragmentJudge judge) {
  Verdict of_all = JudgeAll(SomeReadings(draws, false, owners, c, info), judge);
  if (of_all.outcome == Outcome::kViolated) return OfDraw(0, std::move(of_all));
  Verdict of_alone = JudgeAll(SomeReadings(draws, true, owners, c, info), judge);
  if (of_alone.outcome == Outcome::kViolated) return OfDraw(1, std::move(of_alone));
  return Verdict::Held(of_all.exercised + of_alone.exercised,
                       std::max(of_all.worst_ratio, of_alone.worst_ratio));
}

}  // namespace

std::array<double, 3> BarycentricTolerances(const SubjectInfo& info, const BarycentricQuery& q) {
  const double stated = info.fragments.barycentric_error;
  if (stated > 0) return {stated, stated, stated};
  if (Overflows(q.v, q.place.at, info.input)) return kNothingIsStated;
  return TolerancesOf(EdgeErrorsAt(q.v, q.place.at, info.input), info.input);
}

std::array<double, 3> BarycentricTolerancesInPixel(const SubjectInfo& info, const Points3& v,
                                                   Point2 corner) {
  const double stated = info.fragments.barycentric_error;
  if (stated > 0) return {stated, stated, stated};
  std::optional<EdgeErrors> errors;
  for (const Point2 step : {Point2{0, 0}, Point2{1, 0}, Point2{0, 1}, Point2{1, 1}}) {
    const Point2 p{corner.x + step.x, corner.y + step.y};
    if (Overflows(v, p, info.input)) return kNothingIsStated;
    const EdgeErrors at_corner = EdgeErrorsAt(v, p, info.input);
    errors = errors ? Worst(*errors, at_corner) : at_corner;
  }
  return TolerancesOf(*errors, info.input);
}

Checks AskFragments(const PlacedCase& c, const Description& subject, const Outputs& alone,
                    FragmentJudge judge) {
  Scene scene = c.scene;
  const Depths depths(scene);
  for (std::size_t k = 0; k < scene.vertices.size(); ++k) scene.vertices[k].z = depths.Of(k);
  Questions questions;
  questions.draws.assign(2, WholeCallOf(scene, c.profile, c.options));
  questions.draws[0].job.wants = kEverything;
  questions.draws[1].job.wants = alone;
  Owners owners{scene, c.With(scene).placed};
  return OneCheck(std::move(questions),
                  [&c, &subject, alone, judge, owners = std::move(owners)](const Answers& answers) {
                    const Draws draws{*answers.draws[0], *answers.draws[1], alone};
                    return JudgeDraws(draws, owners, c, subject.info, judge);
                  });
}

Verdict FragmentViolation(const Fragment& fragment, int entry, std::uint64_t exercised,
                          const std::string& property, WitnessValue observed,
                          WitnessValue expected) {
  const std::string of_which = fragment.asked_alone ? property + ", asked for alone" : property;
  return BarycentricViolation(fragment.query, entry, exercised, of_which, std::move(observed),
                              std::move(expected));
}

}  // namespace rasterproof::props
