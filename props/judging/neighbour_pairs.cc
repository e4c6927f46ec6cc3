#include "props/judging/neighbour_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
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

// The violation of a pair drawn alone, on the case that it is of.
void NamePair(const Neighbours& pair, Verdict& verdict) {
  verdict.witness->triangle = static_cast<int>(pair.first);
  verdict.witness->edge = pair.edge;
  verdict.message += " beside the edge that triangles " + std::to_string(pair.first) + " and " +
                     std::to_string(pair.second) + " share";
}

}  // namespace

Asked CompareNeighbours(const Case& c, const Description& subject,
                        const std::function<bool(const Neighbours&)>& takes) {
  Asked asked;
  const Scene placed = PlacedScene(c);
  for (const Neighbours& pair : SharedEdges(c, kPairs)) {
    if (!takes(pair)) continue;
    MeshView beside_the_edge{[edges = PairEdges(placed, pair)](const SamplePlace& place) {
                               return edges.SharedIsNearest(place.at);
                             },
                             true};
    Asked alone = CompareWithItsWinding(OnlyTriangles(c, {pair.first, pair.second}),
                                        std::move(beside_the_edge), subject);
    for (Check& check : alone.checks) {
      check.judge = [pair, judge = std::move(check.judge)](const Answers& answers) {
        Verdict verdict = judge(answers);
        if (verdict.outcome == Outcome::kViolated) NamePair(pair, verdict);
        return verdict;
      };
      asked.checks.push_back(std::move(check));
    }
  }
  return asked;
}

}  // namespace rasterproof::props
