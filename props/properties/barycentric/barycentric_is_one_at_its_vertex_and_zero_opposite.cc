// Barycentric i is one at vertex i and zero on the opposite edge, its ends included, up to its
// bound.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/edge.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentric_is_one_at_its_vertex_and_zero_opposite {

// The corners of a triangle and every sample near it that lies exactly on one of its edge lines.
std::vector<BarycentricQuery> CornersAndTies(const PlacedCase& c) {
  std::vector<BarycentricQuery> queries;
  for (const CornersPlace& corners : SomeProperTriangles(c)) {
    for (const Point2& vertex : corners.at) {
      queries.push_back({corners.triangle, corners.at, {-1, -1, 0, vertex}, true});
    }
    for (const SamplePlace& place : SamplesNearEdges(c, corners.at, 4)) {
      const auto on_edge = [&](int i) {
        return exact::EdgeSign(EdgeStart(corners.at, i), EdgeEnd(corners.at, i), place.at) == 0;
      };
      if (on_edge(0) || on_edge(1) || on_edge(2)) {
        queries.push_back({corners.triangle, corners.at, place, false});
      }
    }
  }
  return queries;
}

Verdict Judge(const std::vector<BarycentricAnswer>& answers) {
  std::uint64_t exercised = 0;
  for (const auto& [q, forms] : answers) {
    const Point2 p = q.place.at;
    for (const auto& [form, barycentrics, bounds] : forms) {
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool at_vertex = p == q.v[k];
        const bool opposite = exact::EdgeSign(EdgeStart(q.v, i), EdgeEnd(q.v, i), p) == 0;
        if (!(at_vertex || opposite) || !IsStated(bounds[k])) continue;
        ++exercised;
        const double expected = at_vertex ? 1 : 0;
        if (AgreeWithin(barycentrics[k], expected, -1, bounds[k], 0)) continue;
        return BarycentricViolation(
            q, i, exercised,
            std::string("barycentric (") + std::string(FormName(form)) +
                (at_vertex ? ") is not one at its vertex" : ") is not zero on the opposite edge"),
            {barycentrics[k]}, {expected, " within ", bounds[k]});
      }
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskBarycentrics(CornersAndTies(c), *subject.barycentrics, Judge);
}

}  // namespace barycentric_is_one_at_its_vertex_and_zero_opposite

extern constinit const Property kBarycentricIsOneAtItsVertexAndZeroOpposite{
    .name = "BarycentricIsOneAtItsVertexAndZeroOpposite",
    .group = "barycentric",
    .clause = "lambda_i is 1 at vertex i and 0 on the opposite edge.",
    .tolerance = kBarycentricBounds,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics,
                  "area not zero; at vertices and at samples exactly on an edge line"),
    .ask = barycentric_is_one_at_its_vertex_and_zero_opposite::Ask,
};

}  // namespace rasterproof::props
