#include "props/judging/edge_queries.h"

#include <cmath>
#include <cstdint>

#include "core/ulp.h"
#include "exact/edge.h"
#include "model/snap.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/precondition.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

// Together about a thousand queries for a case, a fraction of a millisecond.
constexpr int kTriangles = 4;
constexpr int kPerEdge = 4;

// scale * x + shift if that is exact, else nothing.
std::optional<double> ExactAffine(double x, double scale, double shift) {
  const double scaled = scale * x;
  if (scaled / scale != x) return std::nullopt;
  const double sum = scaled + shift;
  const bool exact = std::isfinite(sum) && sum - scaled == shift && sum - shift == scaled;
  return exact ? std::optional(sum) : std::nullopt;
}

bool IsInput(double x, const SubjectInfo& info, const Profile& profile) {
  if (profile.fixed && !(profile.fixed->InRange(x) && profile.fixed->IsGiven(x))) return false;
  return (info.input == Precision::kFloat64 || IsFloat32(x)) &&
         SnapCoordinate(x, profile.snap) == x && std::fabs(x) <= profile.coordinate_limit;
}

std::optional<Point2> Image(const EdgeMap& map, Point2 p, const SubjectInfo& info,
                            const Profile& profile) {
  const std::optional<double> x = ExactAffine(p.x, map.sx, map.tx);
  const std::optional<double> y = ExactAffine(p.y, map.sy, map.ty);
  if (!x || !y || !IsInput(*x, info, profile) || !IsInput(*y, info, profile)) return std::nullopt;
  return map.transpose ? Point2{*y, *x} : Point2{*x, *y};
}

}  // namespace

std::optional<Verdict> CannotAskEdges(const Subject& subject, const Case& c) {
  if (subject.Edges() == nullptr) {
    return Verdict::NotApplicable("the subject shows no edge values");
  }
  return CannotEvaluate(subject, c);
}

std::vector<EdgeQuery> SomeEdgeQueries(const Case& c) {
  std::vector<EdgeQuery> queries;
  for (const CornersPlace& corners : SomeTriangles(c, kTriangles)) {
    for (const SamplePlace& place : SamplesNearEdges(c, corners.at, kPerEdge)) {
      for (int i = 0; i < 3; ++i) {
        queries.push_back(
            {corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i), place});
      }
    }
  }
  return queries;
}

std::vector<BoundedEdge> SomeBoundedEdges(const Case& c, const EdgeEvaluator& bounds) {
  std::vector<BoundedEdge> edges;
  for (const EdgeQuery& q : SomeEdgeQueries(c)) {
    const double bound = bounds.ErrorBound(q.a, q.b, q.place.at);
    if (Claims(bound)) edges.push_back({q, bound});
  }
  return edges;
}

Questions ValuesAt(std::span<const BoundedEdge> edges) {
  Questions questions;
  for (const BoundedEdge& edge : edges) {
    questions.edges.push_back({edge.query.a, edge.query.b, edge.query.place.at});
  }
  return questions;
}

std::vector<EdgeAnswer> ClaimedEdgeValues(const EdgeEvaluator& edges, const Case& c) {
  std::vector<EdgeAnswer> answers;
  for (const EdgeQuery& q : SomeEdgeQueries(c)) {
    const double bound = edges.ErrorBound(q.a, q.b, q.place.at);
    if (Claims(bound)) answers.push_back({q, edges.Value(q.a, q.b, q.place.at), bound});
  }
  return answers;
}

Verdict EdgeViolation(const EdgeQuery& q, std::uint64_t exercised, const std::string& claim,
                      const std::string& observed, const std::string& expected) {
  return Verdict::Violated(
      exercised,
      claim + ": edge " + HexText(q.a) + " -> " + HexText(q.b) + " at " + HexText(q.place.at),
      WitnessAt(q.triangle, q.edge, q.place, observed, expected));
}

std::string ExactEdgeText(Point2 a, Point2 b, Point2 p) {
  return "E = " + exact::EdgeValue(a, b, p).ToString();
}

Verdict EdgeValuesFollow(Subject& subject, const Case& c, std::span<const EdgeMap> maps,
                         const std::string& claim) {
  if (std::optional<Verdict> refusal = CannotAskEdges(subject, c)) return *refusal;
  const EdgeEvaluator& edges = *subject.Edges();
  std::uint64_t exercised = 0;
  for (const auto& [q, value, bound] : ClaimedEdgeValues(edges, c)) {
    const Point2 p = q.place.at;
    for (const EdgeMap& map : maps) {
      const std::optional<Point2> a = Image(map, q.a, subject.Info(), c.profile);
      const std::optional<Point2> b = Image(map, q.b, subject.Info(), c.profile);
      const std::optional<Point2> at = Image(map, p, subject.Info(), c.profile);
      if (!a || !b || !at) continue;
      const double image_bound = edges.ErrorBound(*a, *b, *at);
      const double scaled_bound = std::fabs(map.factor) * bound;
      if (!Claims(image_bound) || !Claims(scaled_bound)) continue;
      ++exercised;
      const double image = edges.Value(*a, *b, *at);
      if (AgreeWithin(image, map.factor * value, -1, image_bound, scaled_bound)) continue;
      return EdgeViolation(q, exercised, claim, HexText(image),
                           HexText(map.factor * value) + " within " +
                               HexText(image_bound + scaled_bound) + "; " +
                               ExactEdgeText(*a, *b, *at) + " of the image");
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
