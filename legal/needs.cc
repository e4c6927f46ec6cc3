#include "legal/needs.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/coverage.h"
#include "core/drawing.h"

namespace rasterproof::legal {
namespace {

// The needs from the counts of each triangle drawn alone.
void AddNeedsOfAlone(const FamilySamples& all, const Observed& observed, std::vector<Need>& needs) {
  for (std::size_t t = 0; t < observed.alone.size(); ++t) {
    if (all.covers_anything[t]) continue;
    const CoverageCounts& counts = *observed.alone[t];
    std::vector<std::int64_t> open_at(counts.size(), -1);
    std::vector<int> decided(counts.size(), 0);
    for (const std::size_t s : all.covered[t]) decided[s] = 1;
    for (std::size_t o = all.first_open[t]; o < all.first_open[t + 1]; ++o) {
      open_at[all.open[o].sample] = static_cast<std::int64_t>(o);
    }
    for (std::size_t s = 0; s < counts.size(); ++s) {
      const int seen = static_cast<int>(counts.Count(s)) - decided[s];
      Need need{{t, s}, {}, seen, seen};
      if (open_at[s] >= 0) need.open.push_back(static_cast<std::size_t>(open_at[s]));
      if (!need.open.empty() || seen != 0) needs.push_back(std::move(need));
    }
  }
}

void AddNeedsOfCounts(const FamilySamples& all, const CoverageCounts& counts, bool is_mask,
                      std::vector<Need>& needs) {
  const int anything = all.Anything();
  const std::vector<int> decided = all.CoveredTimes(counts.size());
  std::vector<std::vector<std::size_t>> open = all.OpenBySample(counts.size());
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const auto seen = static_cast<int>(counts.Count(s));
    Need need{
        {Seen::kTogether, s}, std::move(open[s]), seen - decided[s] - anything, seen - decided[s]};
    if (is_mask && seen != 0) {
      need.least = decided[s] + anything > 0 ? 0 : 1;
      need.most = static_cast<int>(need.open.size());
    }
    if (!need.IsEmpty() || !need.open.empty()) needs.push_back(std::move(need));
  }
}

void AddNeedsOfPrimitiveIds(const FamilySamples& all, const Observed& observed,
                            std::vector<Need>& needs) {
  const std::vector<std::int32_t>& ids = *observed.primitive_ids;
  if (all.Anything() != 0) return;  // it may hide any other
  // Later in the order of drawing: more visible.
  const auto rank = [&](std::size_t t) {
    const auto n = static_cast<std::int64_t>(t);
    return observed.last_is_visible ? n : static_cast<std::int64_t>(all.covered.size()) - 1 - n;
  };
  std::vector<std::int64_t> decided(ids.size(), -1);  // the highest rank that must cover it
  for (std::size_t t = 0; t < all.covered.size(); ++t) {
    for (const std::size_t s : all.covered[t]) decided[s] = std::max(decided[s], rank(t));
  }
  const std::vector<std::vector<std::size_t>> open = all.OpenBySample(ids.size());
  for (std::size_t s = 0; s < ids.size(); ++s) {
    const std::int64_t seen = ids[s] == kNoPrimitive ? -1 : rank(static_cast<std::size_t>(ids[s]));
    bool is_explained = decided[s] == seen;
    for (const std::size_t o : open[s]) {
      const std::int64_t here = rank(all.open[o].triangle);
      if (here < seen) continue;
      const int covers = here == seen ? 1 : 0;
      is_explained = is_explained || here == seen;
      needs.push_back({{Seen::kTogether, s}, {o}, covers, covers});
    }
    if (!is_explained || decided[s] > seen) needs.push_back({{Seen::kTogether, s}, {}, 1, 1});
  }
}

}  // namespace

std::vector<Need> NeedsOf(const FamilySamples& all, const Observed& observed) {
  std::vector<Need> needs;
  AddNeedsOfAlone(all, observed, needs);
  if (observed.together != nullptr)
    AddNeedsOfCounts(all, *observed.together, observed.is_mask, needs);
  if (observed.primitive_ids != nullptr) AddNeedsOfPrimitiveIds(all, observed, needs);
  return needs;
}

}  // namespace rasterproof::legal
