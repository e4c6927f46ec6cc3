// What the edge, incremental and symmetry claims ask an edge evaluator about.
#ifndef RASTERPROOF_PROPS_JUDGING_EDGE_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_EDGE_QUERIES_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/evaluators.h"
#include "core/question.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/judging/places.h"

namespace rasterproof::props {

/// One edge and one sample near it.
struct EdgeQuery {
  int triangle = 0;
  int edge = 0;
  Point2 a;
  Point2 b;
  SamplePlace place;
};

/// The verdict to give if the subject shows no edge values or the case has none to ask about.
std::optional<Verdict> CannotAskEdges(const Subject& subject, const Case& c);

/// Every edge of a few triangles, at samples near any of that triangle's edges.
std::vector<EdgeQuery> SomeEdgeQueries(const Case& c);

/// A query where the subject states a bound on its value.
struct BoundedEdge {
  EdgeQuery query;
  double bound = 0;
};

/// SomeEdgeQueries, where the subject's bound claims anything.
std::vector<BoundedEdge> SomeBoundedEdges(const Case& c, const EdgeEvaluator& bounds);

/// Asks for the value at each.
Questions ValuesAt(std::span<const BoundedEdge> edges);

/// What the subject says at a query.
struct EdgeAnswer {
  EdgeQuery query;
  double value = 0;
  double bound = 0;
};

/// The subject's answers to SomeEdgeQueries, where its bound claims anything.
std::vector<EdgeAnswer> ClaimedEdgeValues(const EdgeEvaluator& edges, const Case& c);

/// A violation at a query: what the claim says, and the values that contradict it.
Verdict EdgeViolation(const EdgeQuery& q, std::uint64_t exercised, const std::string& claim,
                      const std::string& observed, const std::string& expected);

/// "E = p/q" for the witness: the exact value of E(a, b; p).
std::string ExactEdgeText(Point2 a, Point2 b, Point2 p);

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

/// Holds if the subject's values at the images are `factor` times its values, up to the sum of the
/// bounds it claims for both. Put to the test only where every image is exact, of the subject's
/// input format, on the subpixel grid and within the limit.
///
/// Domain:     factor a power of two of either sign.
Verdict EdgeValuesFollow(Subject& subject, const Case& c, std::span<const EdgeMap> maps,
                         const std::string& claim);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_EDGE_QUERIES_H_
