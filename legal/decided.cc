#include "legal/decided.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

#include "core/coverage.h"
#include "legal/choices.h"
#include "legal/family_samples.h"
#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"
#include "model/segment_distance.h"
#include "model/snap.h"
#include "model/target_profile.h"

namespace rasterproof::legal {
namespace {

// With more decisions at one sample than this, only bounds are computed.
constexpr std::size_t kMostSearched = 16;

std::uint64_t BitOf(int count) { return std::uint64_t{1} << std::clamp(count, 0, kMostCounted); }

std::uint64_t BitsBetween(int least, int most) {
  std::uint64_t bits = 0;
  for (int count = std::max(least, 0); count <= std::min(most, kMostCounted); ++count)
    bits |= BitOf(count);
  return bits | BitOf(most);
}

// The numbers of covering triangles at one sample in legal models of the family: a bit for each.
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
OpenDecision WhyOpen(const FamilyView& view, int width, std::size_t triangle, std::size_t sample) {
  const auto samples = static_cast<std::size_t>(view.samples_per_pixel());
  const std::size_t pixel = sample / samples;
  const auto row_length = static_cast<std::size_t>(width);
  const Point2 at = view.At(static_cast<int>(pixel % row_length),
                            static_cast<int>(pixel / row_length), sample % samples);
  OpenDecision why{triangle, sample, -1, HUGE_VAL};
  for (std::size_t e = 0; e < 3; ++e) {
    const Point2 a = view.PlacesOf(triangle, (e + 1) % 3)[0];
    const Point2 b = view.PlacesOf(triangle, (e + 2) % 3)[0];
    const double distance = SegmentDistance(a, b, at);
    if (distance < why.distance) {
      why.edge = static_cast<int>(e);
      why.distance = distance;
    }
  }
  return why;
}

// Every model of the profile belongs to a family: a sample must be covered iff all families say so.
void AddTriangles(const FamilySamples& all, bool is_first,
                  std::vector<TriangleDecided>& triangles) {
  triangles.resize(all.covered.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    TriangleDecided& triangle = triangles[t];
    std::set<std::size_t> covered(all.covered[t].begin(), all.covered[t].end());
    std::set<std::size_t> may(triangle.may.begin(), triangle.may.end());
    for (std::size_t o = all.first_open[t]; o < all.first_open[t + 1]; ++o)
      may.insert(all.open[o].sample);
    if (is_first) triangle.must.assign(covered.begin(), covered.end());
    for (const std::size_t s : triangle.must) {
      if (!covered.contains(s)) may.insert(s);
    }
    std::erase_if(triangle.must, [&](std::size_t s) { return !covered.contains(s); });
    for (const std::size_t s : covered) {
      if (!std::ranges::binary_search(triangle.must, s)) may.insert(s);
    }
    triangle.may.assign(may.begin(), may.end());
    triangle.is_anything = triangle.is_anything || all.covers_anything[t];
    triangle.facing = is_first || triangle.facing == all.facing[t] ? all.facing[t] : 0;
  }
}

void AddFamily(const FamilyView& view, const std::vector<bool>* only, bool is_first,
               Decided& decided) {
  const FamilySamples all(view, only);
  const std::size_t samples = decided.counts.size();
  const std::vector<int> covered = all.CoveredTimes(samples);
  const std::vector<std::vector<std::size_t>> open = all.OpenBySample(samples);
  std::vector<std::vector<const CommonEdgeSample*>> edges(samples);
  for (const CommonEdgeSample& edge : all.common_edges) edges[edge.first->sample].push_back(&edge);
  const int anything = all.Anything();
  for (std::size_t s = 0; s < samples; ++s) {
    if (only != nullptr && !(*only)[s]) continue;
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
  AddTriangles(all, is_first, decided.triangles);
}

}  // namespace

int Decided::Least(std::size_t sample) const { return std::countr_zero(counts[sample]); }
int Decided::Most(std::size_t sample) const { return 63 - std::countl_zero(counts[sample]); }

std::uint64_t Decided::NumberOpen() const {
  std::uint64_t open = 0;
  for (std::size_t s = 0; s < counts.size(); ++s) open += IsDecided(s) ? 0 : 1;
  return open;
}

Decided DecidedSamples(const Scene& scene, const TargetProfile& profile,
                       const std::vector<bool>* only) {
  Decided decided{scene.width, scene.height, profile.pattern.samples(), {}, {}, {}, 0, 0};
  decided.counts.assign(CoverageCounts::Size(scene.width, scene.height, decided.samples), 0);
  if (profile.freedom.MovesVertices() && !profile.snap.IsNone())
    decided.step = std::ldexp(1.0, -LegalGrids(profile.snap, profile.freedom).front().bits);
  const std::vector<Family> families = FamiliesOf(profile, scene);
  for (std::size_t f = 0; f < families.size(); ++f)
    AddFamily(FamilyView(scene, profile, families[f]), only, f == 0, decided);
  const FamilyView canonical(scene, profile, families.front());
  for (std::size_t t = 0; t < decided.triangles.size(); ++t) {
    for (const std::size_t s : decided.triangles[t].may)
      decided.open.push_back(WhyOpen(canonical, scene.width, t, s));
  }
  return decided;
}

std::vector<bool> OpenOfSomeTriangle(const Scene& scene, const TargetProfile& profile) {
  std::vector<TriangleDecided> triangles;
  const std::vector<Family> families = FamiliesOf(profile, scene);
  for (std::size_t f = 0; f < families.size(); ++f)
    AddTriangles(FamilySamples(FamilyView(scene, profile, families[f])), f == 0, triangles);
  std::vector<bool> open(
      CoverageCounts::Size(scene.width, scene.height, profile.pattern.samples()));
  for (const TriangleDecided& triangle : triangles) {
    if (triangle.is_anything) open.assign(open.size(), true);
    for (const std::size_t s : triangle.may) open[s] = true;
  }
  return open;
}

}  // namespace rasterproof::legal
