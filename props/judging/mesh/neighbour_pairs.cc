#include "props/judging/mesh/neighbour_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "core/scene.h"
#include "exact/rational.h"
#include "legal/owners.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kPairs = 6;
constexpr double kNear = 1;  // pixels
// Doubles decide which of two distances is the smaller one unless they are this close.
constexpr double kDoubtful = 0x1p-20;

// The corners of the box that holds what is near the edge; around the eye an edge can reach
// anywhere.
std::pair<Point2, Point2> Around(const Vertex& a, const Vertex& b, bool clip_space) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  if (clip_space) return {{-kFar, -kFar}, {kFar, kFar}};
  return {{std::min(a.x, b.x) - kNear, std::min(a.y, b.y) - kNear},
          {std::max(a.x, b.x) + kNear, std::max(a.y, b.y) + kNear}};
}

}  // namespace

std::vector<Neighbours> NeighbourPair::Some(const PlacedCase& c) { return SharedEdges(c, kPairs); }

NeighbourPair::NeighbourPair(const PlacedCase& c, const Neighbours& pair)
    : pair_(pair),
      alone_(c.Only({pair.first, pair.second})),
      open_(alone_, /*spares_outline=*/true),
      ties_(alone_) {
  const Snap& rounding = alone_.profile.scanline_rounding;
  if (!rounding.IsNone()) outer_moves_ = std::ldexp(1.0, -rounding.bits);
  const Scene& placed = alone_.placed;
  for (const auto& [t, shared_edge] :
       {std::pair{std::size_t{0}, pair.edge}, std::pair{std::size_t{1}, pair.second_edge}}) {
    const std::array<Vertex, 3> v = Corners(placed, placed.triangles[t]);
    for (int i = 0; i < 3; ++i) {
      const VisibleEdge edge(EdgeStart(v, i), EdgeEnd(v, i));
      if (i != shared_edge) {
        outer_.push_back(edge);
      } else if (!shared_) {
        shared_ = edge;
        std::tie(low_, high_) = Around(EdgeStart(v, i), EdgeEnd(v, i), placed.clip_space);
      }
    }
  }
}

std::vector<SamplePlace> NeighbourPair::SamplesBesideTheEdge() const {
  std::vector<SamplePlace> samples;
  for (int row = 0; row < alone_.scene.height; ++row) {
    for (int x = 0; x < alone_.scene.width; ++x) {
      for (int s = 0; s < alone_.profile.pattern.samples(); ++s) {
        const SamplePlace place = PlaceOf(alone_, x, row, s);
        if (!SharedEdgeIsNearest(place.at) || open_.IsBesideTheOutline(place.at)) continue;
        samples.push_back(place);
      }
    }
  }
  return samples;
}

bool NeighbourPair::SharedEdgeIsNearest(Point2 p) const {
  if (p.x < low_.x || p.x > high_.x || p.y < low_.y || p.y > high_.y) return false;
  const double shared = shared_->Distance(p);
  if (!(shared <= kNear)) return false;
  return std::ranges::all_of(outer_, [&](const VisibleEdge& outer) {
    const double distance = outer.Distance(p);
    if (distance <= outer_moves_) return false;
    if (std::fabs(distance - shared) > kDoubtful) return distance > shared;
    const std::optional<exact::Rational> exactly = outer.SquaredDistance(p);
    return !exactly || *exactly > *shared_->SquaredDistance(p);
  });
}

bool NeighbourPair::MayShare(const SamplePlace& sample, std::size_t index,
                             std::uint32_t count) const {
  return count > 1 && legal::SharesTies(alone_.profile) && ties_.Allow(count, index, sample.at);
}

Verdict NeighbourPair::CoveredTimes(std::uint32_t count, const SamplePlace& sample,
                                    Verdict so_far) const {
  const std::string beside = " beside the edge that triangles " + std::to_string(pair_.first) +
                             " and " + std::to_string(pair_.second) + " share";
  const bool at_least = count == 0 && legal::SharesTies(alone_.profile);
  so_far.outcome = Outcome::kViolated;
  so_far.message = (count == 0 ? "a gap" : "an overlap") + beside;
  so_far.witness =
      WitnessAt(static_cast<int>(pair_.first), pair_.edge, sample, {"covered ", count, " times"},
                {at_least ? "at least once" : "exactly once"});
  return so_far;
}

}  // namespace rasterproof::props
