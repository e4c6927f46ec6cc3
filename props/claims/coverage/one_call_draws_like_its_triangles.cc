// A call with a mesh gives what the calls with each of its triangles alone add up to: the sum of counts, the union of masks, the winner by the declared order.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/winners.h"

namespace rasterproof::props {
namespace {

// A mesh of more triangles is judged by its first ones: what a rasterizer does with neighbours in
// the list shows among them.
constexpr std::size_t kMostTriangles = 32;
// So often the first triangle stands before the others: a byte can't number those any more.
constexpr std::size_t kBefore = 256;

// The triangles of one call, by their place in the case.
using Order = std::vector<std::size_t>;

DrawJob InOrder(DrawJob job, const Order& order) {
  job.triangles.emplace();
  for (const std::size_t t : order) job.triangles->push_back(job.scene->triangles[t]);
  return job;
}

// The mesh, so many times over; and behind so many repetitions of its first triangle.
std::array<Order, 2> OrdersOf(std::size_t count, std::size_t times) {
  Order plain;
  for (std::size_t n = 0; n < times * count; ++n) plain.push_back(n % count);
  Order late(kBefore, 0);
  late.insert(late.end(), plain.begin(), plain.end());
  return {plain, late};
}

// A call for each order, and then one for each triangle.
std::vector<DrawJob> WholesAndSingles(const Case& c, std::span<const Order> orders,
                                      std::size_t count) {
  DrawJob job(c.scene, c.options, c.profile.lattice.samples());
  job.wants = kCoverageAndIds;
  std::vector<DrawJob> jobs;
  for (const Order& order : orders) jobs.push_back(InOrder(job, order));
  for (std::size_t t = 0; t < count; ++t) jobs.push_back(InOrder(job, {t}));
  return jobs;
}

void AddAlone(const CoverageCounts& alone, bool is_mask, CoverageCounts& sum) {
  sum += alone;
  if (!is_mask) return;
  for (std::uint32_t& count : sum.front) count = std::min(count, 1U);
}

// Whether a drawing in one call is what its triangles' own add up to.
Verdict LikeItsTriangles(const SubjectInfo& info, const Drawing& mesh, const Order& order,
                         std::span<const Drawing* const> alone, std::uint64_t decisions) {
  if (ShowsWinners(info)) {
    std::vector<std::vector<bool>> covered;
    for (const std::size_t t : order) covered.push_back(CoveredSamples(alone[t]->counts));
    return SameWinners(mesh, WinnersOf(covered, info.fragments.order), alone.size(), decisions,
                       "drawn alone");
  }
  CoverageCounts sum(mesh.counts.width, mesh.counts.height, mesh.counts.samples);
  for (const std::size_t t : order) {
    AddAlone(alone[t]->counts, info.coverage == CoverageKind::kMask, sum);
  }
  return SameCounts(mesh.counts, sum, decisions, "that of its triangles drawn alone");
}

Verdict Judge(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (c.scene.triangles.size() < 2) {
    return {Outcome::kNotExercised, 0, 0, "a mesh of one triangle", std::nullopt};
  }
  Subject& whole = subject.Whole();
  const SubjectInfo& info = whole.Info();
  // Winners: twice, so that something always lies on top.
  const std::size_t times = ShowsWinners(info) ? 2 : 1;
  const auto count = std::min(c.scene.triangles.size(), kMostTriangles);
  const std::array<Order, 2> orders = OrdersOf(count, times);
  const std::vector<DrawJob> jobs = WholesAndSingles(c, orders, count);
  const std::vector<DrawOutcome> outcomes = whole.DrawMany(jobs);
  // Fewer outcomes than jobs: the last is a fault, which Get() throws.
  const auto drawn = [&](std::size_t job) {
    return &outcomes[std::min(job, outcomes.size() - 1)].Get();
  };
  std::vector<const Drawing*> alone;
  for (std::size_t t = 0; t < count; ++t) alone.push_back(drawn(orders.size() + t));
  const std::uint64_t decisions = DecisionsOf(c);
  for (std::size_t k = 0; k < orders.size(); ++k) {
    Verdict verdict = LikeItsTriangles(info, *drawn(k), orders[k], alone, decisions);
    if (verdict.outcome != Outcome::kViolated) continue;
    if (k == 1) {
      verdict.message += " (behind " + std::to_string(kBefore) + " repetitions of the first)";
    }
    return verdict;
  }
  return Verdict::Held(2 * decisions);
}

}  // namespace

constinit const Property kOneCallDrawsLikeItsTriangles{
    .name = "OneCallDrawsLikeItsTriangles",
    .group = "coverage",
    .clause =
        "A mesh is its triangles: what one call with all of them gives, also behind 256 "
        "others, is what calls with each alone add up to.",
    .precondition = "contract sample-exact; coordinates within the limit; two triangles or more",
    .tolerance = kExact,
    .domains = kMeshes,
    .check = Judge,
};

}  // namespace rasterproof::props
