#include "legal/decided.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include "core/coverage.h"
#include "legal/choices.h"
#include "legal/family_samples.h"
#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"
#include "model/snap.h"
#include "model/target_model.h"

namespace rasterproof::legal {
namespace {

// More decisions at one sample are only bounded.
constexpr std::size_t kMostSearched = 16;

std::uint64_t BitOf(int count) { return std::uint64_t{1} << std::clamp(count, 0, kMostCounted); }

std::uint64_t BitsBetween(int least, int most) {
  std::uint64_t bits = 0;
  for (int count = std::max(least, 0); count <= std::min(most, kMostCounted); ++count)
    bits |= BitOf(count);
  return bits | BitOf(most);
}

// How many of the decisions at one sample legal models of the family take together: a bit for each
// number.
std::uint64_t NumbersOf(const FamilyView& view, const FamilySamples& all,
                        const std::vector<std::size_t>& open,
                        const std::vector<const CommonEdgeSample*>& edges) {
  if (open.size() == 1) {
    const std::vector<Status>& status = all.open[open[0]].by_choice;
    const auto has = [&](Status s) { return std::ranges::find(status, s) != status.end(); };
    const bool is_free = has(Status::kFree);
    return (is_free || has(Status::kOut) ? 1U : 0U) | (is_free || has(Status::kIn) ? 2U : 0U);
  }
  ModelClauses clauses(view);
  std::vector<Literal> covers;
  for (const std::size_t o : open) covers.push_back(clauses.Covers(all.open[o]));
  for (const CommonEdgeSample* edge : edges) clauses.AddOwner(*edge);
  std::uint64_t numbers = 0;
  constexpr std::uint64_t kAsManyAsItTakes = ~std::uint64_t{0};
  for (int n = 0; n <= static_cast<int>(open.size()); ++n) {
    const std::array<Literal, 1> assumed{clauses.Between(covers, n, n)};
    if (clauses.solver().Solve(assumed, kAsManyAsItTakes) == Answer::kSatisfiable)
      numbers |= std::uint64_t{1} << n;
  }
  return numbers;
}

// The nearest edge in the family's canonical places.
OpenDecision WhyOpen(const FamilyView& view, const OpenSample& open) {
  OpenDecision why{open.triangle, open.sample, -1, HUGE_VAL};
  for (std::size_t e = 0; e < 3; ++e) {
    const Point2 a = view.PlacesOf(open.triangle, (e + 1) % 3)[0];
    const Point2 b = view.PlacesOf(open.triangle, (e + 2) % 3)[0];
    const double distance = SegmentDistance(a, b, open.at);
    if (distance < why.distance) {
      why.edge = static_cast<int>(e);
      why.distance = distance;
    }
  }
  return why;
}

void AddFamily(const FamilyView& view, Decided& decided,
               std::set<std::pair<std::size_t, std::size_t>>& known) {
  const FamilySamples all(view);
  const std::size_t samples = decided.counts.size();
  const std::vector<int> covered = all.CoveredTimes(samples);
  const std::vector<std::vector<std::size_t>> open = all.OpenBySample(samples);
  std::vector<std::vector<const CommonEdgeSample*>> edges(samples);
  for (const CommonEdgeSample& edge : all.common_edges) edges[edge.first->sample].push_back(&edge);
  const int anything = all.Anything();
  for (std::size_t s = 0; s < samples; ++s) {
    const auto n = static_cast<int>(open[s].size());
    if (n == 0 || anything != 0 || open[s].size() > kMostSearched) {
      decided.counts[s] |= BitsBetween(covered[s], covered[s] + n + anything);
      if (open[s].size() > kMostSearched) ++decided.bounded;
      continue;
    }
    const std::uint64_t numbers = NumbersOf(view, all, open[s], edges[s]);
    for (int k = 0; k <= n; ++k) {
      if ((numbers >> k & 1U) != 0) decided.counts[s] |= BitOf(covered[s] + k);
    }
  }
  for (const OpenSample& sample : all.open) {
    if (known.insert({sample.triangle, sample.sample}).second)
      decided.open.push_back(WhyOpen(view, sample));
  }
}

}  // namespace

int Decided::Least(std::size_t sample) const { return std::countr_zero(counts[sample]); }
int Decided::Most(std::size_t sample) const { return 63 - std::countl_zero(counts[sample]); }

Decided DecidedSamples(const Scene& scene, const Profile& profile) {
  const Profile model = ForTarget(profile, scene.width, scene.height);
  Decided decided{scene.width, scene.height, model.pattern.samples(), {}, {}, 0, 0};
  decided.counts.assign(CoverageCounts::Size(scene.width, scene.height, decided.samples), 0);
  if (model.freedom.MovesVertices() && !model.snap.IsNone())
    decided.step = std::ldexp(1.0, -LegalGrids(model.snap, model.freedom).front().bits);
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (const Family& family : FamiliesOf(profile, scene.width, scene.height))
    AddFamily(FamilyView(scene, profile, family), decided, known);
  return decided;
}

}  // namespace rasterproof::legal
