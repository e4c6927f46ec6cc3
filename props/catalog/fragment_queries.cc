#include "props/catalog/fragment_queries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/profile.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/catalog/precondition.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// Exact weights are rationals, some ten microseconds each.
constexpr std::size_t kMostFragments = 24;
// What the bounds' own evaluation in double may lose, and the terms of second order in u.
constexpr double kSlack = 1 + 0x1p-16;

double UnitRoundoff(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-24 : 0x1p-53;
}

double SumOfProducts(Point2 a, Point2 b, Point2 p) {
  return std::fabs((p.x - a.x) * (b.y - a.y)) + std::fabs((p.y - a.y) * (b.x - a.x));
}

double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// 3 u S + u |E| of the five-operation form, and a subnormal for each operation.
double EdgeTolerance(Point2 a, Point2 b, Point2 p, Precision precision) {
  const double u = UnitRoundoff(precision);
  const double eta = precision == Precision::kFloat32 ? 0x1p-149 : 0x1p-1074;
  const double sum = SumOfProducts(a, b, p);
  return kSlack * (4 * u * sum + 5 * eta);  // |E| <= S
}

bool Overflows(const WeightQuery& q, Precision precision) {
  const double most = precision == Precision::kFloat32 ? 0x1p126 : 0x1p1022;
  for (int i = 0; i < 3; ++i) {
    if (!(SumOfProducts(EdgeStart(q.v, i), EdgeEnd(q.v, i), q.place.at) < most)) return true;
  }
  return !(SumOfProducts(q.v[0], q.v[1], q.v[2]) < most);
}

// Depths that no two vertices of a triangle are likely to share; exact in every format.
double DepthOf(std::size_t vertex) { return 0.125 * static_cast<double>(1 + 3 * vertex % 8); }

double DepthTolerance(const SubjectInfo& info, const Fragment& f) {
  if (info.fragments.depth_error > 0) return info.fragments.depth_error;
  const double u = UnitRoundoff(info.input);
  const std::array<exact::Rational, 3> weights = ExactWeights(f.query);
  double tolerance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = std::fabs(weights[i].ToDouble());
    tolerance += (f.weight_tolerances[i] + 6 * u * std::max(1.0, weight)) * std::fabs(f.z[i]);
  }
  return tolerance;
}

}  // namespace

std::optional<Verdict> CannotAskFragments(Subject& subject, const Case& c) {
  if (subject.Whole().Info().coverage != CoverageKind::kFragments) {
    return Verdict::NotApplicable("the subject shows no fragments");
  }
  if (subject.Whole().Info().fragments.weights_of == WeightsOf::kSnapped &&
      c.profile.freedom.snap_tolerance != 0) {
    return Verdict::NotApplicable(
        "the profile leaves the grid points free that the weights belong to");
  }
  return CannotEvaluate(subject, c);
}

std::array<double, 3> WeightTolerances(const SubjectInfo& info, const WeightQuery& q) {
  const double declared = info.fragments.weight_error;
  if (declared > 0) return {declared, declared, declared};
  if (Overflows(q, info.input)) return {kNothing, kNothing, kNothing};
  const double u = UnitRoundoff(info.input);
  const double area_tolerance = EdgeTolerance(q.v[0], q.v[1], q.v[2], info.input);
  // Once for what the subject divides by, once for the value that is worked out here.
  const double least_area = std::fabs(EdgeValue(q.v[0], q.v[1], q.v[2])) - 2 * area_tolerance;
  if (!(least_area > area_tolerance)) return {kNothing, kNothing, kNothing};
  std::array<double, 3> tolerances{};
  for (int i = 0; i < 3; ++i) {
    const Point2 a = EdgeStart(q.v, i);
    const Point2 b = EdgeEnd(q.v, i);
    const double edge_tolerance = EdgeTolerance(a, b, q.place.at, info.input);
    const double weight = (std::fabs(EdgeValue(a, b, q.place.at)) + edge_tolerance) / least_area;
    tolerances[static_cast<std::size_t>(i)] =
        kSlack * ((edge_tolerance + weight * area_tolerance) / least_area + u * weight) + 0x1p-149;
  }
  return tolerances;
}

std::vector<Fragment> SomeFragments(Subject& subject, const Case& c) {
  Subject& whole = subject.Whole();
  const SubjectInfo& info = whole.Info();
  DrawJob job{c.scene, c.options, c.profile.lattice.samples()};
  for (std::size_t k = 0; k < job.scene.vertices.size(); ++k) job.scene.vertices[k].z = DepthOf(k);
  const Drawing drawing = whole.Show(job);
  const bool snapped = info.fragments.weights_of == WeightsOf::kSnapped;
  const Scene owners = snapped ? SnapScene(job.scene, c.profile) : job.scene;
  std::vector<std::size_t> covered;
  for (std::size_t k = 0; k < drawing.winners.size(); ++k) {
    if (drawing.winners[k] != kNoTriangle) covered.push_back(k);
  }
  std::vector<Fragment> fragments;
  const auto samples = static_cast<std::size_t>(drawing.counts.samples);
  const auto width = static_cast<std::size_t>(drawing.counts.width);
  for (std::size_t n = 0; n < covered.size(); n += covered.size() / kMostFragments + 1) {
    const std::size_t k = covered[n];
    Fragment f;
    f.query.triangle = drawing.winners[k];
    const Triangle& t = owners.triangles[static_cast<std::size_t>(f.query.triangle)];
    const std::array<Vertex, 3> corners = Corners(owners, t);
    for (std::size_t i = 0; i < 3; ++i) {
      f.query.v[i] = WindowPoint(corners[i]);
      f.z[i] = corners[i].z;
    }
    if (!std::ranges::all_of(corners, IsFinite) || exact::Facing(f.query.v) == 0) continue;
    f.query.place = PlaceOf(c, static_cast<int>(k / samples % width),
                            static_cast<int>(k / samples / width), static_cast<int>(k % samples));
    f.query.inside = InClosedTriangle(f.query.v, f.query.place.at);
    f.weights = drawing.weights[k];
    f.depth = drawing.depths[k];
    f.weight_tolerances = WeightTolerances(info, f.query);
    f.depth_tolerance = DepthTolerance(info, f);
    fragments.push_back(f);
  }
  return fragments;
}

Verdict FragmentViolation(const Fragment& fragment, int entry, std::uint64_t exercised,
                          const std::string& claim, const std::string& observed,
                          const std::string& expected) {
  return WeightViolation(fragment.query, entry, exercised, claim, observed, expected);
}

std::string WeightsText(const Fragment& fragment) {
  const std::array<double, 3>& l = fragment.weights;
  return HexText(l[0]) + ", " + HexText(l[1]) + ", " + HexText(l[2]);
}

}  // namespace rasterproof::props
