// A sample at a vertex holds the vertex's number, to the bit.
#include <array>
#include <cstddef>
#include <cstdint>

#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace vertices_keep_their_values {

// The vertex that the point is at, or 3.
std::size_t VertexAt(const ValueOwners& owners, Point2 p) {
  std::size_t i = 0;
  for (; i < 3; ++i) {
    const exact::HomogeneousPoint& v = (*owners.known)[i];
    if (v.w.Sign() != 0 && v.x == v.w * p.x && v.y == v.w * p.y) break;
  }
  return i;
}

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  if (!owners.known) return Verdict::Held(0);
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    const bool is_flat = channel.interpolation == Interpolation::kFlat;
    if (is_flat || channel.interpolation == Interpolation::kInverseW) continue;
    if (channel.at == EvaluatedAt::kCentroid) continue;
    const Point2 p = PlaceOfValue(f, channel);
    const std::size_t i = VertexAt(owners, p);
    if (i == 3) continue;
    if (!exact::Interpolant(*owners.known, p).Weights(channel.interpolation)) continue;
    if (!RangeOf(shown, f, owners, channel, NumbersAt(f, channel))) continue;
    ++exercised;
    const double expected = NumbersAt(f, channel)[i];
    const double x = shown.Of(f, k);
    if (x == expected) continue;
    return ValueViolation(f, channel, "is not its vertex's", {x}, {expected}, NumberKind::kValue,
                          /*to_the_bit=*/true);
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAlone, Judge, FragmentChoice::kAtVertices);
}

constexpr std::array kRules{ProfileRule{[](const Profile& p) { return p.values.exact_at_vertices; },
                                        "values that are exact at vertices",
                                        "the profile does not promise exact values at vertices"}};

}  // namespace vertices_keep_their_values

extern constinit const Property kVerticesKeepTheirValues{
    .name = "VerticesKeepTheirValues",
    .group = "values",
    .clause = "At vertex i the barycentric i is one and the others are zero.",
    .tolerance = kExact,
    .domains = kVertexValueDomains,
    .gate = AsksOf(Shows::kValues, vertices_keep_their_values::kRules,
                   "a sample at a vertex of the triangle that it shows"),
    .ask = vertices_keep_their_values::Ask,
};

}  // namespace rasterproof::props
