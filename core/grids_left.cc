#include "core/grids_left.h"

#include <algorithm>
#include <tuple>

namespace rasterproof {
namespace {

auto KindOf(const GridsOnTarget& grids) {
  return std::tuple(grids.clip_space, grids.samples, grids.width, grids.height);
}

}  // namespace

std::string GridsLeft::Text() const {
  const auto has = [this](int bits) { return (set_ >> bits & 1U) != 0; };
  std::string text;
  for (int first = 0; first <= kMostBits; ++first) {
    if (!has(first)) continue;
    int last = first;
    while (last < kMostBits && has(last + 1)) ++last;
    if (!text.empty()) text += ", ";
    if (first == kMostBits) {
      text += "no grid";
    } else if (last == kMostBits) {
      text += std::to_string(first) + " or more";
    } else {
      text += std::to_string(first);
      if (last > first) text += " to " + std::to_string(last);
    }
    first = last;
  }
  return text.empty() ? "none" : text;
}

void AddGrids(const std::vector<GridsOnTarget>& more, std::vector<GridsOnTarget>& to) {
  for (const GridsOnTarget& grids : more) {
    const auto at = std::ranges::lower_bound(to, KindOf(grids), {}, &KindOf);
    if (at == to.end() || !at->IsOfTheSameTarget(grids)) {
      to.insert(at, grids);
      continue;
    }
    at->cases += grids.cases;
    at->left.Intersect(grids.left);
  }
}

}  // namespace rasterproof
