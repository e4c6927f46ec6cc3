#include "props/infer/race.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "props/infer/directed.h"

namespace rasterproof::props {
namespace {

// A pair that two in ten directed triangles split is missed by the first number in 2 of 1000 tries,
// by the second never.
constexpr int kTriesAtRandom = 24;
constexpr int kTriesForEachPair = 600;
constexpr int kFailuresInARow = 8;
// Checks that are drawn in one call. Triangles aimed at a pair come one by one: each pair is chosen
// by what the last triangle left.
constexpr int kInOneCall = 16;

}  // namespace

bool Race::Run(const Scene& scene) {
  std::vector<CoverageCounts> seen = observer_.Draw(std::span(&scene, 1));
  return !seen.empty() && Learn(scene, std::move(seen.front()));
}

bool Race::Learn(const Scene& scene, CoverageCounts seen) {
  if (seen.size() == 0) return false;  // refused
  if (left_.empty()) {
    experiments_.push_back({scene, std::move(seen)});
    return true;
  }
  Prediction prediction(scene, space_, observer_.facing());
  const Model simplest = left_.front();
  std::erase_if(left_, [&](const Model& model) { return !prediction.Explains(model, seen); });
  if (left_.empty()) last_refuted_ = LastRefuted{simplest, experiments_.size()};
  experiments_.push_back({scene, std::move(seen)});
  return true;
}

bool Race::SplitPair(const Model& a, const Model& b, int tries) {
  for (int attempt = 0; attempt < tries; ++attempt) {
    PhiloxSource bits(seed_, drawn_++);
    const std::optional<Scene> scene = observer_.Given(SplittingTriangle(bits, space_, a, b));
    if (!scene) continue;
    Prediction prediction(*scene, space_, observer_.facing());
    if (!prediction.Parts(a, b)) continue;
    if (Run(*scene)) return true;
    if (observer_.HasBrokenOff()) return false;
  }
  return false;
}

void Race::SplitAtRandom() {
  int failures = 0;
  while (left_.size() > 1 && failures < kFailuresInARow && !observer_.HasBrokenOff()) {
    PhiloxSource bits(seed_, drawn_++);
    const auto last = static_cast<std::int64_t>(left_.size()) - 1;
    const auto i = static_cast<std::size_t>(bits.Int(0, last - 1));
    const auto j = static_cast<std::size_t>(bits.Int(static_cast<std::int64_t>(i) + 1, last));
    const Model a = left_[i];  // copies: a run strikes models out
    const Model b = left_[j];
    failures = SplitPair(a, b, kTriesAtRandom) ? 0 : failures + 1;
  }
}

void Race::Split() {
  SplitAtRandom();
  // Models that agree with the first one agree with each other as far as anyone looked.
  std::size_t k = 1;
  Model first = left_.empty() ? Model{} : left_.front();
  while (k < left_.size() && !observer_.HasBrokenOff()) {
    const Model other = left_[k];
    if (SplitPair(first, other, kTriesForEachPair)) {
      // The list is shorter and perhaps led by another model: every pair is looked at again.
      if (!left_.empty()) first = left_.front();
      k = 1;
    } else {
      ++k;
    }
  }
}

void Race::Check(int count) {
  SubjectInfo info = observer_.info();
  constexpr double kFarthest = 0x1p13;
  const double limit = std::min(info.profile.coordinate_limit, kFarthest);
  while (count > 0 && !observer_.HasBrokenOff()) {
    // As if the subject were what is left of the race: cases aim at its grid and its samples.
    if (!left_.empty()) info.profile = space_.ProfileOf(left_.front());
    info.profile.coordinate_limit = limit;
    int tried = std::min(count, kInOneCall);
    std::vector<Scene> scenes;
    std::vector<int> tries;  // it took to come to each
    for (int k = 0; k < tried; ++k) {
      PhiloxSource bits(seed_, drawn_ + static_cast<std::uint64_t>(k));
      const std::optional<Scene> scene = observer_.Given(OrdinaryTriangle(bits, info));
      if (!scene) continue;
      scenes.push_back(*scene);
      tries.push_back(k + 1);
    }
    std::vector<CoverageCounts> seen = observer_.Draw(scenes);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const std::size_t before = left_.size();
      Learn(scenes[k], std::move(seen[k]));
      if (left_.size() == before) continue;
      tried = tries[k];  // what follows was aimed at a model that may be gone
      break;
    }
    drawn_ += static_cast<std::uint64_t>(tried);
    count -= tried;
  }
}

}  // namespace rasterproof::props
