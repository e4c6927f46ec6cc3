#include "props/catalog/neighbour_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "props/catalog/planar_mesh.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kPairs = 6;
constexpr double kNear = 1;  // pixels

// In double: which samples count as near the edge is a choice, not a verdict.
bool IsNear(const Neighbours& pair, Point2 p) {
  const double dx = pair.b.x - pair.a.x;
  const double dy = pair.b.y - pair.a.y;
  const double edge = (p.x - pair.a.x) * dy - (p.y - pair.a.y) * dx;
  return !(std::fabs(edge) > kNear * std::hypot(dx, dy));
}

}  // namespace

Verdict PairsCoverOnce(Subject& subject, const Case& c,
                       const std::function<bool(const Neighbours&)>& takes) {
  std::uint64_t exercised = 0;
  std::uint64_t not_judged = 0;
  for (const Neighbours& pair : SharedEdges(c, kPairs)) {
    if (!takes(pair)) continue;
    const Case alone = OnlyTriangles(c, {pair.first, pair.second});
    const MeshView beside_the_edge{[&](const SamplePlace& place) { return IsNear(pair, place.at); },
                                   true};
    Verdict verdict = JudgePlanarMesh(subject, alone, beside_the_edge);
    exercised += verdict.exercised;
    not_judged += verdict.not_judged;
    if (verdict.outcome != Outcome::kViolated) continue;
    verdict.exercised = exercised;
    verdict.witness->triangle = static_cast<int>(pair.first);
    verdict.witness->edge = pair.edge;
    verdict.message += " beside the edge that triangles " + std::to_string(pair.first) + " and " +
                       std::to_string(pair.second) + " share";
    return verdict;
  }
  Verdict verdict = Verdict::Held(exercised);
  verdict.not_judged = not_judged;
  return verdict;
}

}  // namespace rasterproof::props
