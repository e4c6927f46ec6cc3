#include "legal/needs.h"

#include <algorithm>
#include <cstdint>
#include <span>
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

// How many of the triangles at each sample are counted on one side: those that have it in every
// legal model, and perhaps some of those that have not one side in all of them.
void AddNeedsOfSide(const FamilySamples& all, std::span<const int> sides, int side,
                    const std::vector<std::uint32_t>& counts, std::vector<Need>& needs) {
  std::vector<int> decided(counts.size(), 0);
  std::vector<int> loose(counts.size(), all.Anything());
  for (std::size_t t = 0; t < all.covered.size(); ++t) {
    if (sides[t] == -side) continue;
    for (const std::size_t s : all.covered[t]) ++(sides[t] == side ? decided : loose)[s];
  }
  std::vector<std::vector<std::size_t>> open(counts.size());
  for (std::size_t o = 0; o < all.open.size(); ++o) {
    const OpenSample& one = all.open[o];
    if (sides[one.triangle] == side) open[one.sample].push_back(o);
    if (sides[one.triangle] == 0) ++loose[one.sample];
  }
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const int seen = static_cast<int>(counts[s]) - decided[s];
    Need need{{Seen::kTogether, s}, std::move(open[s]), seen - loose[s], seen};
    if (!need.IsEmpty()) needs.push_back(std::move(need));
  }
}

// Ids where any of several triangles may be visible: that one covers the sample.
void AddNeedsOfUnorderedIds(const FamilySamples& all, const std::vector<std::int32_t>& ids,
                            std::vector<Need>& needs) {
  if (all.Anything() != 0) return;       // it may hide any other
  std::vector<bool> must(ids.size());    // some triangle covers it
  std::vector<bool> covers(ids.size());  // the one that was seen does
  const auto is_seen = [&](std::size_t t, std::size_t s) {
    return ids[s] != kNoPrimitive && static_cast<std::size_t>(ids[s]) == t;
  };
  for (std::size_t t = 0; t < all.covered.size(); ++t) {
    for (const std::size_t s : all.covered[t]) {
      must[s] = true;
      covers[s] = covers[s] || is_seen(t, s);
    }
  }
  const std::vector<std::vector<std::size_t>> open = all.OpenBySample(ids.size());
  for (std::size_t s = 0; s < ids.size(); ++s) {
    bool is_explained = ids[s] == kNoPrimitive ? !must[s] : covers[s];
    for (const std::size_t o : open[s]) {
      const bool is_it = is_seen(all.open[o].triangle, s);
      is_explained = is_explained || is_it;
      if (ids[s] == kNoPrimitive || is_it)
        needs.push_back({{Seen::kTogether, s}, {o}, is_it ? 1 : 0, is_it ? 1 : 0});
    }
    if (!is_explained) needs.push_back({{Seen::kTogether, s}, {}, 1, 1});
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

// Visible triangles of which the side was seen that no legal model counts them on.
void AddNeedsOfVisibleSide(const Observed& observed, std::vector<Need>& needs) {
  const std::vector<std::int32_t>& ids = *observed.primitive_ids;
  for (std::size_t s = 0; s < ids.size(); ++s) {
    if (observed.ShowsWrongSide(s)) needs.push_back({{Seen::kTogether, s}, {}, 1, 1});
  }
}

}  // namespace

bool Observed::ShowsWrongSide(std::size_t sample) const {
  if (sides == Sides::kNotCompared || primitive_ids == nullptr || visible_front == nullptr)
    return false;
  const std::int32_t id = (*primitive_ids)[sample];
  if (id == kNoPrimitive) return false;
  const int front = sides == Sides::kPositiveArea ? 1 : -1;
  return side_of[static_cast<std::size_t>(id)] == ((*visible_front)[sample] ? -front : front);
}

std::vector<Need> NeedsOf(const FamilySamples& all, const Observed& observed) {
  std::vector<Need> needs;
  AddNeedsOfAlone(all, observed, needs);
  if (observed.together != nullptr)
    AddNeedsOfCounts(all, *observed.together, observed.is_mask, needs);
  if (observed.sides != Sides::kNotCompared && observed.together != nullptr) {
    const int front = observed.sides == Sides::kPositiveArea ? 1 : -1;
    AddNeedsOfSide(all, observed.side_of, front, observed.together->front, needs);
    AddNeedsOfSide(all, observed.side_of, -front, observed.together->back, needs);
  }
  if (observed.primitive_ids != nullptr) AddNeedsOfVisibleSide(observed, needs);
  if (observed.primitive_ids != nullptr && observed.any_is_visible) {
    AddNeedsOfUnorderedIds(all, *observed.primitive_ids, needs);
  } else if (observed.primitive_ids != nullptr) {
    AddNeedsOfPrimitiveIds(all, observed, needs);
  }
  return needs;
}

}  // namespace rasterproof::legal
