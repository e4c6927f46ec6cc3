// The edges and samples that the edge, incremental and symmetry properties ask about.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_EDGE_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_EDGE_QUERIES_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/question.h"
#include "core/verdict.h"
#include "props/judging/gate.h"
#include "props/judging/places.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// One edge and one sample near it.
struct EdgeQuery {
  int triangle = 0;
  int edge = 0;
  Point2 a;
  Point2 b;
  SamplePlace place;
};

/// The gate of a property about edge values.
inline constexpr Gate kAsksEdgeValues{
    .shows = Shows::kEdgeValues, .contract = ContractNeeded::kNone, .unwrapped = true};

/// A query where the subject states a bound on its value.
struct BoundedEdge {
  EdgeQuery query;
  double bound = 0;
};

/// Every edge of a few triangles, at samples near any of that triangle's edges, where the subject's
/// bound promises anything.
std::vector<BoundedEdge> SomeBoundedEdges(const PlacedCase& c, const EdgeBounds& bounds);

/// Asks for the value at each.
Questions ValuesAt(std::span<const BoundedEdge> edges);

/// A violation at a query: the property's claim, and the values that contradict it.
Verdict EdgeViolation(const EdgeQuery& q, std::uint64_t exercised, const std::string& property,
                      WitnessValue observed, WitnessValue expected);

/// A map of the plane onto itself, (x, y) -> (sx x + tx, sy y + ty), then x and y exchanged if
/// `transpose`. E of the images is `factor` times E.
struct EdgeMap {
  double sx = 1;
  double sy = 1;
  double tx = 0;
  double ty = 0;
  bool transpose = false;
  double factor = 1;
};

/// Whether the subject's values at the images are `factor` times its values, up to the sum of the
/// bounds it states for both. Asked only where every image is exact, of the subject's input format,
/// on the subpixel grid and within the limit. A violation says `wrong`.
///
/// Domain:     factor a power of two of either sign; a subject that shows edge values.
Checks EdgeValuesFollow(const PlacedCase& c, const Description& subject,
                        std::span<const EdgeMap> maps, std::string_view wrong);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_EDGE_QUERIES_H_
