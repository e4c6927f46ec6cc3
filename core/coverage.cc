#include "core/coverage.h"

#include <cstddef>
#include <cstdint>

namespace rasterproof {

CoverageCounts& CoverageCounts::operator+=(const CoverageCounts& more) {
  for (std::size_t k = 0; k < size(); ++k) {
    front[k] += more.front[k];
    back[k] += more.back[k];
  }
  return *this;
}

CoverageDifference Compare(const CoverageCounts& observed, const CoverageCounts& expected) {
  CoverageDifference difference;
  difference.samples = expected.size();
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t want = expected.Count(k);
    const std::uint32_t have = observed.Count(k);
    if (want != 0) ++difference.covered;
    if (observed.front[k] == expected.front[k] && observed.back[k] == expected.back[k]) continue;
    if (difference.wrong++ == 0) difference.first_wrong = k;
    if (have < want) ++difference.missing;
    if (have > want) ++difference.unexpected;
  }
  return difference;
}

}  // namespace rasterproof
