#include "legal/edge_owners.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace rasterproof::legal {
namespace {

// Two triangles that may turn have no owner of their common edge if their corners have more choices
// of places than this: two clauses each, for each sample.
constexpr std::size_t kMostChoices = 4096;

// A triangle's side of an edge between two positions.
struct Side {
  std::size_t triangle = 0;
  std::size_t corner = 0;  ///< where the edge begins
  int side = 0;            ///< +1 or -1: on which side of it the triangle lies; 0: it varies
};

bool CanLieOnEdge(const FamilyView& view, const Side& side, Point2 p) {
  for (const Point2 a : view.PlacesOf(side.triangle, side.corner)) {
    for (const Point2 b : view.PlacesOf(side.triangle, (side.corner + 1) % 3)) {
      if (LiesOnEdge(a, b, p)) return true;
    }
  }
  return false;
}

// Of the places of both triangles' corners.
std::size_t ChoicesOf(const FamilyView& view, const Side& first, const Side& second) {
  std::size_t choices = view.PlacesOf(second.triangle, (second.corner + 2) % 3).size();
  for (std::size_t k = 0; k < 3; ++k) choices *= view.PlacesOf(first.triangle, k).size();
  return choices;
}

}  // namespace

std::vector<CommonEdgeSample> CommonEdgeSamplesOf(const FamilyView& view,
                                                  const std::vector<OpenSample>& open,
                                                  const std::vector<std::size_t>& first_open,
                                                  const std::vector<int>& facing) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Side>> sides;
  for (std::size_t t = 0; t < view.triangles(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = view.PositionOf(t, k);
      const std::size_t b = view.PositionOf(t, (k + 1) % 3);
      if (a == b) continue;
      sides[{std::min(a, b), std::max(a, b)}].push_back({t, k, a < b ? facing[t] : -facing[t]});
    }
  }
  std::vector<CommonEdgeSample> samples;
  for (const auto& [edge, of] : sides) {
    if (of.size() != 2 || of[0].side * of[1].side == 1) continue;
    std::optional<std::size_t> opposite;
    if (of[0].side * of[1].side == 0) {
      // One that is left out may be the owner.
      if (view.MayDrop() || ChoicesOf(view, of[0], of[1]) > kMostChoices) continue;
      opposite = (of[1].corner + 2) % 3;
    }
    std::size_t i = first_open[of[0].triangle];
    std::size_t j = first_open[of[1].triangle];
    while (i < first_open[of[0].triangle + 1] && j < first_open[of[1].triangle + 1]) {
      if (open[i].sample < open[j].sample) {
        ++i;
      } else if (open[j].sample < open[i].sample) {
        ++j;
      } else {
        if (!open[i].is_clipped && !open[j].is_clipped && CanLieOnEdge(view, of[0], open[i].at))
          samples.push_back({&open[i], &open[j], of[0].corner, opposite});
        ++i;
        ++j;
      }
    }
  }
  return samples;
}

}  // namespace rasterproof::legal
