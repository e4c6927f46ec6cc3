#include "props/judging/neighbour_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/scene.h"
#include "core/subject_errors.h"
#include "props/judging/places.h"
#include "props/judging/planar_mesh.h"
#include "props/judging/redraw.h"
#include "props/judging/visible_edge.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kPairs = 6;
constexpr double kNear = 1;  // pixels
// Doubles tell which of two distances is the smaller one unless they are this close.
constexpr double kDoubtful = 0x1p-20;

// The edges of two neighbours, the one they share apart from the four others.
class PairEdges {
 public:
  PairEdges(const Scene& placed, const Neighbours& pair) {
    const auto add = [&](std::size_t t, int shared_edge) {
      const std::array<Vertex, 3> v = Corners(placed, placed.triangles[t]);
      for (int i = 0; i < 3; ++i) {
        const VisibleEdge edge(EdgeStart(v, i), EdgeEnd(v, i));
        if (i != shared_edge) {
          outer_.push_back(edge);
        } else if (!shared_) {
          shared_ = edge;
        }
      }
    };
    add(pair.first, pair.edge);
    add(pair.second, pair.second_edge);
  }

  // Within a pixel of the shared edge, and no other edge is nearer: what is seen elsewhere is no
  // evidence about the shared edge.
  bool SharedIsNearest(Point2 p) const {
    const double shared = shared_->Distance(p);
    if (!(shared <= kNear)) return false;
    return std::ranges::all_of(outer_, [&](const VisibleEdge& outer) {
      const double distance = outer.Distance(p);
      if (std::fabs(distance - shared) > kDoubtful) return distance > shared;
      const std::optional<exact::Rational> exactly = outer.SquaredDistance(p);
      return !exactly || *exactly >= *shared_->SquaredDistance(p);
    });
  }

 private:
  std::optional<VisibleEdge> shared_;
  std::vector<VisibleEdge> outer_;
};

}  // namespace

Verdict PairsCoverOnce(Subject& subject, const Case& c,
                       const std::function<bool(const Neighbours&)>& takes) {
  Verdict all = Verdict::Held(0);
  const Scene placed = PlacedScene(c);
  // Every pair is drawn, whatever comes of the first: what is asked does not depend on answers.
  for (const Neighbours& pair : SharedEdges(c, kPairs)) {
    if (!takes(pair)) continue;
    const Case alone = OnlyTriangles(c, {pair.first, pair.second});
    const PairEdges edges(placed, pair);
    const MeshView beside_the_edge{
        [&](const SamplePlace& place) { return edges.SharedIsNearest(place.at); }, true};
    Verdict verdict;
    try {
      verdict = JudgePlanarMesh(subject, alone, beside_the_edge);
    } catch (const InputError&) {
      if (!all.witness) throw;
      continue;  // whatever becomes of another pair does not unsay what was seen
    } catch (const SubjectFault&) {
      if (!all.witness) throw;
      continue;
    } catch (const SubjectTooSlow&) {
      if (!all.witness) throw;
      continue;
    }
    all.exercised += verdict.exercised;
    all.not_judged += verdict.not_judged;
    if (verdict.outcome != Outcome::kViolated || all.witness) continue;
    all.outcome = Outcome::kViolated;
    all.witness = verdict.witness;
    all.witness->triangle = static_cast<int>(pair.first);
    all.witness->edge = pair.edge;
    all.message = verdict.message + " beside the edge that triangles " +
                  std::to_string(pair.first) + " and " + std::to_string(pair.second) + " share";
  }
  if (all.outcome != Outcome::kViolated && all.exercised != 0) all.outcome = Outcome::kHolds;
  return all;
}

}  // namespace rasterproof::props
