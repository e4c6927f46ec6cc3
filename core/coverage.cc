#include "core/coverage.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/error.h"

namespace rasterproof {
namespace {

std::string ShapeOfCounts(const CoverageCounts& counts) {
  return std::to_string(counts.width) + "x" + std::to_string(counts.height) + " pixels with " +
         std::to_string(counts.samples) + " samples each";
}

}  // namespace

void RequireAsMany(const CoverageCounts& a, const CoverageCounts& b) {
  if (a.size() == b.size()) return;
  throw InputError("counts of " + ShapeOfCounts(a), "others are of " + ShapeOfCounts(b),
                   "draw by the profile that the case is judged by");
}

CoverageCounts& CoverageCounts::operator+=(const CoverageCounts& more) {
  RequireAsMany(*this, more);
  for (std::size_t k = 0; k < size(); ++k) {
    front[k] += more.front[k];
    back[k] += more.back[k];
  }
  return *this;
}

CoverageDifference Compare(const CoverageCounts& observed, const CoverageCounts& expected) {
  RequireAsMany(observed, expected);
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
