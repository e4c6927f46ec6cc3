#include "props/judging/winners.h"

#include <algorithm>
#include <cstddef>

#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

std::string WinnerText(std::int32_t winner) {
  return winner == kNoTriangle ? "no triangle" : "triangle " + std::to_string(winner);
}

}  // namespace

std::vector<bool> CoveredSamples(const CoverageCounts& counts) {
  std::vector<bool> covered(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) covered[k] = counts.Count(k) != 0;
  return covered;
}

std::vector<std::int32_t> WinnersOf(const std::vector<std::vector<bool>>& covered,
                                    WinnerOrder order) {
  std::vector<std::int32_t> winners(covered.front().size(), kNoTriangle);
  for (std::size_t t = 0; t < covered.size(); ++t) {
    for (std::size_t k = 0; k < winners.size(); ++k) {
      const bool wins = order == WinnerOrder::kLastDrawn || winners[k] == kNoTriangle;
      if (covered[t][k] && wins) winners[k] = static_cast<std::int32_t>(t);
    }
  }
  return winners;
}

Verdict SameWinners(const Drawing& observed, const std::vector<std::int32_t>& expected,
                    std::size_t triangles, std::uint64_t exercised, const std::string& how) {
  std::uint64_t wrong = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (observed.winners[k] != expected[k] && wrong++ == 0) first = k;
  }
  if (wrong == 0) return Verdict::Held(exercised);
  Witness witness = WitnessAtIndex(observed.counts, first);
  witness.triangle =
      std::max(observed.winners[first], expected[first]) % static_cast<std::int32_t>(triangles);
  witness.observed = WinnerText(observed.winners[first]) + " wins";
  witness.expected = WinnerText(expected[first]) + ", by the triangles " + how;
  return Verdict::Violated(std::max<std::uint64_t>(exercised, 1),
                           "another triangle wins than the declared order says at " +
                               std::to_string(wrong) + " of " + std::to_string(expected.size()) +
                               " samples",
                           witness);
}

}  // namespace rasterproof::props
