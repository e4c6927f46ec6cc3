#include "props/shrink/shrink.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "props/shrink/cost.h"
#include "props/shrink/passes.h"

namespace rasterproof::props {
namespace {

// Candidates are copies: enough of them for a search tree, never more than memory holds.
constexpr std::size_t kMostCollectedTriangles = std::size_t{1} << 20;

// Collects what the passes propose and accepts none of it.
class CollectingAttempts final : public Attempts {
 public:
  explicit CollectingAttempts(const Case& c) : current_(c) {}
  const Case& Current() const override { return current_; }
  bool Try(Case candidate) override {
    if (CostOf(candidate) < CostOf(current_)) {
      collected_ += candidate.scene.triangles.size() + candidate.scene.vertices.size();
      candidates_.push_back(std::move(candidate));
    }
    return false;
  }
  bool Exhausted() const override { return collected_ >= kMostCollectedTriangles; }
  std::vector<Case> Take() { return std::move(candidates_); }

 private:
  const Case& current_;
  std::size_t collected_ = 0;
  std::vector<Case> candidates_;
};

// Takes every simpler candidate that still fails.
class Greedy final : public Attempts {
 public:
  Greedy(const Case& c, const FailsOrEnd& fails, std::uint64_t budget)
      : result_{c, 0}, fails_(fails), budget_(budget) {}
  const Case& Current() const override { return result_.minimal; }
  bool Try(Case candidate) override {
    if (Exhausted() || !(CostOf(candidate) < CostOf(result_.minimal))) return false;
    ++result_.evaluations;
    const std::optional<bool> fails = fails_(candidate);
    is_ended_ = !fails;
    if (!fails.value_or(false)) return false;
    result_.minimal = std::move(candidate);
    return true;
  }
  bool Exhausted() const override { return is_ended_ || result_.evaluations >= budget_; }
  Shrunk Take() { return std::move(result_); }

 private:
  Shrunk result_;
  const FailsOrEnd& fails_;
  std::uint64_t budget_;
  bool is_ended_ = false;
};

}  // namespace

std::vector<Case> ShrinkCandidates(const Case& c) {
  CollectingAttempts collector(c);
  RunPasses(collector);
  return collector.Take();
}

Shrunk Shrink(const Case& failing, const FailsOrEnd& fails, std::uint64_t budget) {
  Greedy greedy(failing, fails, budget);
  // Every accepted candidate costs less, and there is no endless descent among tuples of naturals:
  // the loop ends even without a budget.
  Cost before = CostOf(greedy.Current());
  for (;;) {
    RunPasses(greedy);
    const Cost after = CostOf(greedy.Current());
    if (greedy.Exhausted() || !(after < before)) break;
    before = after;
  }
  return greedy.Take();
}

}  // namespace rasterproof::props
