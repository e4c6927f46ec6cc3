#include "props/judging/legal_counts.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/profile.h"
#include "exact/coverage.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "model/target_profile.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

bool IsAmong(std::uint64_t numbers, std::uint32_t drawn, bool counts) {
  if (!counts && drawn != 0) return (numbers & ~std::uint64_t{1}) != 0;
  const std::uint32_t most = legal::kMostCounted;
  return (numbers >> std::min(drawn, most) & 1U) != 0;
}

std::string WordsOf(std::uint64_t numbers) {
  std::string words;
  for (int k = 0; k <= legal::kMostCounted; ++k) {
    if ((numbers >> k & 1U) != 0) words += (words.empty() ? "" : " or ") + std::to_string(k);
  }
  return words + " in every legal model";
}

}  // namespace

std::optional<std::string> WhyNoLegalCounts(const Scene& scene, const TargetProfile& profile) {
  if (profile.freedom.IsNone()) return std::nullopt;
  return legal::WhyNotJoint(scene, profile);
}

LegalCounts::LegalCounts(const Scene& scene, const PlacedCase& c) {
  if (c.profile.freedom.IsNone()) {
    only_ = exact::Coverage(scene, c.profile, WholeTarget(c));
  } else {
    numbers_ = legal::DecidedSamples(scene, c.profile).counts;
  }
}

std::uint64_t LegalCounts::Apart(const LegalCounts& other) const {
  if (only_) return Compare(*only_, *other.only_).wrong;
  std::uint64_t apart = 0;
  for (std::size_t k = 0; k < numbers_.size(); ++k) {
    if ((numbers_[k] & other.numbers_[k]) == 0) ++apart;
  }
  return apart;
}

DrawQuestion LegalCounts::QuestionOf(const Scene& scene, const PlacedCase& c) {
  return c.profile.freedom.IsNone() ? CountsOf(scene, c.profile, WholeTarget(c))
                                    : WholeCallOf(scene, c.profile, WholeTarget(c));
}

Verdict LegalCounts::VerdictOn(const CoverageCounts& drawn, bool counts, std::uint64_t exercised,
                               const std::string& of) const {
  return only_ ? SameCounts(drawn, *only_, exercised, "the model's" + of)
               : JudgeBySample(drawn, counts, exercised, of);
}

std::vector<std::size_t> LegalCounts::Wrong(const CoverageCounts& drawn, bool counts) const {
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const bool is_right = only_
                              ? drawn.front[k] == only_->front[k] && drawn.back[k] == only_->back[k]
                              : IsAmong(numbers_[k], drawn.Count(k), counts);
    if (!is_right) wrong.push_back(k);
  }
  return wrong;
}

Verdict LegalCounts::JudgeBySample(const CoverageCounts& drawn, bool counts,
                                   std::uint64_t exercised, const std::string& of) const {
  const std::vector<std::size_t> all = Wrong(drawn, counts);
  if (all.empty()) return Verdict::Held(exercised);
  const std::size_t wrong = all.size();
  const std::size_t first = all.front();
  Witness witness = WitnessAtIndex(drawn, first);
  witness.observed = std::to_string(drawn.Count(first));
  witness.expected = WordsOf(numbers_[first]);
  return Verdict::Violated(exercised,
                           "coverage differs from every legal model's" + of + " at " +
                               std::to_string(wrong) + " of " + std::to_string(numbers_.size()) +
                               " samples",
                           std::move(witness));
}

}  // namespace rasterproof::props
