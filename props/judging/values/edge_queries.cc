#include "props/judging/values/edge_queries.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/ulp.h"
#include "exact/edge.h"
#include "model/snap.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Together about a thousand queries for a case, a fraction of a millisecond.
constexpr int kEdgeTriangles = 4;
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

std::vector<EdgeQuery> SomeEdgeQueries(const PlacedCase& c) {
  std::vector<EdgeQuery> queries;
  for (const CornersPlace& corners : SomeTriangles(c, kEdgeTriangles)) {
    for (const SamplePlace& place : SamplesNearEdges(c, corners.at, kPerEdge)) {
      for (int i = 0; i < 3; ++i) {
        queries.push_back(
            {corners.triangle, i, EdgeStart(corners.at, i), EdgeEnd(corners.at, i), place});
      }
    }
  }
  return queries;
}

// A value at an image, and the value that it should follow from.
struct ImageValue {
  EdgeQuestion image;
  double image_bound = 0;
  std::size_t of = 0;  ///< among the edges
  double factor = 1;
  double scaled_bound = 0;
};

// Nothing where the image is no input, or a bound promises nothing.
std::optional<ImageValue> ImageOf(const PlacedCase& c, const Description& subject,
                                  const BoundedEdge& edge, const EdgeMap& map) {
  const EdgeQuery& q = edge.query;
  const std::optional<Point2> a = Image(map, q.a, subject.info, c.profile);
  const std::optional<Point2> b = Image(map, q.b, subject.info, c.profile);
  const std::optional<Point2> at = Image(map, q.place.at, subject.info, c.profile);
  if (!a || !b || !at) return std::nullopt;
  const double image_bound = subject.edges->ErrorBound(*a, *b, *at);
  const double scaled_bound = std::fabs(map.factor) * edge.bound;
  if (!IsStated(image_bound) || !IsStated(scaled_bound)) return std::nullopt;
  return ImageValue{{*a, *b, *at}, image_bound, 0, map.factor, scaled_bound};
}

std::vector<ImageValue> ImagesOf(const PlacedCase& c, const Description& subject,
                                 std::span<const BoundedEdge> edges,
                                 std::span<const EdgeMap> maps) {
  std::vector<ImageValue> images;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    for (const EdgeMap& map : maps) {
      std::optional<ImageValue> image = ImageOf(c, subject, edges[k], map);
      if (!image) continue;
      image->of = k;
      images.push_back(*image);
    }
  }
  return images;
}

}  // namespace

std::vector<BoundedEdge> SomeBoundedEdges(const PlacedCase& c, const EdgeBounds& bounds) {
  std::vector<BoundedEdge> edges;
  for (const EdgeQuery& q : SomeEdgeQueries(c)) {
    const double bound = bounds.ErrorBound(q.a, q.b, q.place.at);
    if (IsStated(bound)) edges.push_back({q, bound});
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

Verdict EdgeViolation(const EdgeQuery& q, std::uint64_t exercised, const std::string& property,
                      WitnessValue observed, WitnessValue expected) {
  return Verdict::Violated(
      exercised,
      property + ": edge " + HexText(q.a) + " -> " + HexText(q.b) + " at " + HexText(q.place.at),
      WitnessAt(q.triangle, q.edge, q.place, std::move(observed), std::move(expected)));
}

Checks EdgeValuesFollow(const PlacedCase& c, const Description& subject,
                        std::span<const EdgeMap> maps, std::string_view wrong) {
  std::vector<BoundedEdge> edges = SomeBoundedEdges(c, *subject.edges);
  std::vector<ImageValue> images = ImagesOf(c, subject, edges, maps);
  Questions questions = ValuesAt(edges);
  for (const ImageValue& image : images) questions.edges.push_back(image.image);
  return OneCheck(std::move(questions), [edges = std::move(edges), images = std::move(images),
                                         wrong = std::string(wrong)](const Answers& answers) {
    for (std::size_t k = 0; k < images.size(); ++k) {
      const auto& [image, image_bound, of, factor, scaled_bound] = images[k];
      const double expected = factor * answers.edges[of];
      const double observed = answers.edges[edges.size() + k];
      if (AgreeWithin(observed, expected, -1, image_bound, scaled_bound)) continue;
      return EdgeViolation(edges[of].query, k + 1, wrong, {observed},
                           {expected, " within ", image_bound + scaled_bound,
                            "; E = ", ExactEdge(image.a, image.b, image.p), " of the image"});
    }
    return Verdict::Held(images.size());
  });
}

}  // namespace rasterproof::props
