#include "legal/family_samples.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "legal/edge_owners.h"

namespace rasterproof::legal {

FamilySamples::FamilySamples(const FamilyView& view, const std::vector<bool>* only) {
  for (std::size_t t = 0; t < view.triangles(); ++t) {
    TriangleSamples samples = view.Of(t, only);
    first_open.push_back(open.size());
    for (Exclusion& exclusion : samples.exclusions) {
      for (auto& [sample, covered] : exclusion) sample += open.size();
      exclusions.push_back(std::move(exclusion));
    }
    std::ranges::move(samples.open, std::back_inserter(open));
    covered.push_back(std::move(samples.covered));
    facing.push_back(samples.facing);
    covers_anything.push_back(samples.covers_anything);
  }
  first_open.push_back(open.size());
  if (view.OwnsByEdge()) common_edges = CommonEdgeSamplesOf(view, open, first_open, facing);
}

std::vector<std::vector<std::size_t>> FamilySamples::OpenBySample(std::size_t samples) const {
  std::vector<std::vector<std::size_t>> by_sample(samples);
  for (std::size_t o = 0; o < open.size(); ++o) by_sample[open[o].sample].push_back(o);
  return by_sample;
}

std::vector<int> FamilySamples::CoveredTimes(std::size_t samples) const {
  std::vector<int> times(samples, 0);
  for (const std::vector<std::size_t>& of : covered) {
    for (const std::size_t s : of) ++times[s];
  }
  return times;
}

int FamilySamples::Anything() const {
  return static_cast<int>(std::ranges::count(covers_anything, true));
}

}  // namespace rasterproof::legal
