#include "report/bench_changes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

// The same method on the same family in two runs.
struct Match {
  const BenchRow* before = nullptr;
  const BenchRow* now = nullptr;
};

bool IsSameFamily(const BenchResult& before, const BenchFamily& old, const BenchResult& now,
                  const BenchFamily& family) {
  return old.name == family.name && old.triangles == family.triangles &&
         old.covered == family.covered && before.setting.seed == now.setting.seed &&
         before.methods[old.baseline].name == now.methods[family.baseline].name;
}

bool IsSameMethod(const BenchMethod& a, const BenchMethod& b) {
  return a.name == b.name && a.target == b.target && a.sink == b.sink;
}

std::vector<Match> Matches(const BenchResult& before, const BenchResult& now) {
  std::vector<Match> matches;
  for (const BenchRow& row : now.rows) {
    const auto found = std::ranges::find_if(before.rows, [&](const BenchRow& old) {
      return IsSameMethod(before.methods[old.method], now.methods[row.method]) &&
             IsSameFamily(before, before.families[old.family], now, now.families[row.family]);
    });
    if (found != before.rows.end()) matches.push_back({&*found, &row});
  }
  return matches;
}

// How far a ratio of the baseline to itself lies from 1 in this family: a factor.
double Noise(const BenchResult& result, std::uint32_t family) {
  double noise = 1;
  for (const BenchRow& row : result.rows) {
    if (row.family != family || row.method != result.families[family].twin) continue;
    if (row.method == result.families[family].baseline || row.ratio.low <= 0) continue;
    noise = std::max({noise, row.ratio.high, 1 / row.ratio.low});
  }
  return noise;
}

// The factor between the nearer ends of two intervals without a number in common; 1 of others.
double Gap(const Interval& a, const Interval& b) {
  if (a.high < b.low) return a.high > 0 ? b.low / a.high : std::numeric_limits<double>::infinity();
  if (b.high < a.low) return b.high > 0 ? a.low / b.high : std::numeric_limits<double>::infinity();
  return 1;
}

}  // namespace

std::vector<BenchChange> BenchChanges(const BenchResult& before, const BenchResult& now) {
  std::vector<BenchChange> changes;
  for (const auto& [old, row] : Matches(before, now)) {
    const BenchMethod& method = now.methods[row->method];
    BenchChange change{.family = now.families[row->family].name,
                       .method = method.name,
                       .target = method.target,
                       .sink = method.sink};
    const double noise = std::max(Noise(before, old->family), Noise(now, row->family));
    if (Gap(old->ratio, row->ratio) > noise) {
      const bool is_slower = row->ratio.median > old->ratio.median;
      change.kind = is_slower ? BenchChangeKind::kSlower : BenchChangeKind::kFaster;
      change.before = old->ratio.median;
      change.now = row->ratio.median;
      changes.push_back(change);
    }
    const bool are_judged = old->is_judged && row->is_judged &&
                            old->judged_triangles == row->judged_triangles &&
                            old->boundary_pairs == row->boundary_pairs;
    if (are_judged && old->real.Wrong() != row->real.Wrong()) {
      const bool is_worse = row->real.Wrong() > old->real.Wrong();
      change.kind = is_worse ? BenchChangeKind::kMoreWrong : BenchChangeKind::kLessWrong;
      change.before = static_cast<double>(old->real.Wrong());
      change.now = static_cast<double>(row->real.Wrong());
      changes.push_back(change);
    }
  }
  std::vector<BenchChange> sorted;
  for (const bool worse : {true, false}) {
    std::ranges::copy_if(changes, std::back_inserter(sorted), [worse](const BenchChange& change) {
      return change.IsForTheWorse() == worse;
    });
  }
  return sorted;
}

std::string BenchChangesText(const BenchResult& before, const BenchResult& now) {
  std::string text;
  for (const BenchChange& change : BenchChanges(before, now)) {
    const std::string place = fmt::format("{}: {} by {} into {}", change.family, change.method,
                                          change.target, change.sink);
    const bool is_time =
        change.kind == BenchChangeKind::kSlower || change.kind == BenchChangeKind::kFaster;
    const std::string_view word = change.IsForTheWorse() ? (is_time ? "slower" : "more wrong")
                                                         : (is_time ? "faster" : "less wrong");
    text += is_time ? fmt::format("{}: {}, {:.3f} times the baseline before, {:.3f} now\n", word,
                                  place, change.before, change.now)
                    : fmt::format("{}: {}, {:.0f} wrong pairs before, {:.0f} now\n", word, place,
                                  change.before, change.now);
  }
  return text + fmt::format("{} rows compared with commit {} of {} on {}\n",
                            Matches(before, now).size(), before.setting.commit, before.setting.date,
                            before.setting.processor);
}

}  // namespace rasterproof::report
