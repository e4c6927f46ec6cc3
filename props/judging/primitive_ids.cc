#include "props/judging/primitive_ids.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

WitnessValue PrimitiveAt(std::int32_t id, std::string words) {
  if (id == kNoPrimitive) return {"no triangle" + std::move(words)};
  return {"triangle ", id, std::move(words)};
}

}  // namespace

std::vector<bool> CoveredSamples(const CoverageCounts& counts) {
  std::vector<bool> covered(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) covered[k] = counts.Count(k) != 0;
  return covered;
}

std::vector<std::int32_t> PrimitiveIdsOf(const std::vector<std::vector<bool>>& covered,
                                         Visible order) {
  std::vector<std::int32_t> primitive_ids(covered.front().size(), kNoPrimitive);
  for (std::size_t t = 0; t < covered.size(); ++t) {
    for (std::size_t k = 0; k < primitive_ids.size(); ++k) {
      const bool wins = order == Visible::kLastDrawn || primitive_ids[k] == kNoPrimitive;
      if (covered[t][k] && wins) primitive_ids[k] = static_cast<std::int32_t>(t);
    }
  }
  return primitive_ids;
}

Verdict SamePrimitiveIds(const Drawing& observed, const std::vector<std::int32_t>& expected,
                         std::size_t triangles, std::uint64_t exercised, const std::string& how) {
  std::uint64_t wrong = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (observed.primitive_ids[k] != expected[k] && wrong++ == 0) first = k;
  }
  if (wrong == 0) return Verdict::Held(exercised);
  Witness witness = WitnessAtIndex(observed.counts, first);
  witness.triangle = std::max(observed.primitive_ids[first], expected[first]) %
                     static_cast<std::int32_t>(triangles);
  witness.observed = PrimitiveAt(observed.primitive_ids[first], " wins");
  witness.expected = PrimitiveAt(expected[first], ", by the triangles " + how);
  return Verdict::Violated(std::max<std::uint64_t>(exercised, 1),
                           "the visible triangle contradicts the stated order at " +
                               std::to_string(wrong) + " of " + std::to_string(expected.size()) +
                               " samples",
                           witness);
}

}  // namespace rasterproof::props
