// What changed between two runs of bench.
#ifndef RASTERPROOF_REPORT_BENCH_CHANGES_H_
#define RASTERPROOF_REPORT_BENCH_CHANGES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

enum class BenchChangeKind : std::uint8_t { kSlower, kFaster, kMoreWrong, kLessWrong };

/// One method on one family, otherwise than it was.
struct BenchChange {
  BenchChangeKind kind = BenchChangeKind::kSlower;
  std::string family;
  std::string method;
  std::string target;
  std::string sink;
  double before = 0;  ///< the ratio to the baseline, or the number of wrong pairs
  double now = 0;

  bool IsForTheWorse() const {
    return kind == BenchChangeKind::kSlower || kind == BenchChangeKind::kMoreWrong;
  }
  friend bool operator==(const BenchChange&, const BenchChange&) = default;
};

/// The rows that both runs have, and in which a ratio's intervals have no number in common and lie
/// farther apart than the baseline from itself in either run; or in which other pairs are wrong,
/// where both judged as many of the same family. For the worse first.
///
/// Domain:     ratios are to the same baseline in both runs; a family of another baseline, size or
///             seed is compared in no way.
std::vector<BenchChange> BenchChanges(const BenchResult& before, const BenchResult& now);

/// A line for each, and one that says how many rows were compared.
std::string BenchChangesText(const BenchResult& before, const BenchResult& now);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_CHANGES_H_
