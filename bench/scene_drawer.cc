#include "bench/scene_drawer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bench/family.h"
#include "core/drawing.h"
#include "core/subject_info.h"

namespace rasterproof::bench {
namespace {

class ContenderDrawer final : public SceneDrawer {
 public:
  explicit ContenderDrawer(Contender& contender) : contender_(contender) {}

  const BenchMethod& method() const override { return contender_.method(); }
  const Profile& model() const override { return contender_.model(); }
  const EdgeEvaluator* edges() const override { return contender_.edges(); }
  bool Takes(const Scene& scene) const override { return !contender_.WhyNot(FamilyOf(scene, "")); }
  std::vector<std::optional<bool>> Covers(std::span<const HardCase* const> cases) override {
    std::vector<std::optional<bool>> covers;
    std::vector<std::uint8_t> box(1);
    for (const HardCase* one : cases) {
      const FamilyInput family = FamilyOf(one->scene, "");
      contender_.Load(family);
      contender_.DrawAlone(0, {one->x, one->y, one->x + 1, one->y + 1}, box);
      contender_.LeftBehind();
      covers.emplace_back(box[0] != 0);
    }
    return covers;
  }

 private:
  Contender& contender_;
};

class SubjectDrawer final : public SceneDrawer {
 public:
  SubjectDrawer(Subject& subject, BenchMethod method)
      : subject_(subject), method_(std::move(method)) {}

  const BenchMethod& method() const override { return method_; }
  const Profile& model() const override { return subject_.Info().profile; }
  const EdgeEvaluator* edges() const override { return subject_.Edges(); }
  bool Takes(const Scene& scene) const override {
    return rasterproof::Takes(subject_.Info(), scene);
  }
  std::vector<std::optional<bool>> Covers(std::span<const HardCase* const> cases) override {
    std::vector<DrawJob> jobs;
    for (const HardCase* one : cases) {
      jobs.emplace_back(one->scene, DrawOptions{}, 1).wants = kCoverageAlone;
    }
    const std::vector<DrawOutcome> outcomes = subject_.DrawMany(jobs);
    std::vector<std::optional<bool>> covers;
    for (std::size_t k = 0; k < outcomes.size() && !EndsTheCall(outcomes[k].end.stop); ++k) {
      auto& answer = covers.emplace_back();
      if (outcomes[k].end.stop != Stop::kNone) continue;  // refused
      const CoverageCounts& counts = outcomes[k].drawing.counts;
      answer = counts.Count(counts.Index(cases[k]->x, cases[k]->y)) != 0;
    }
    return covers;
  }

 private:
  Subject& subject_;
  BenchMethod method_;
};

}  // namespace

std::unique_ptr<SceneDrawer> DrawerOf(Contender& contender) {
  return std::make_unique<ContenderDrawer>(contender);
}

std::unique_ptr<SceneDrawer> DrawerOf(Subject& subject) {
  const SubjectInfo& info = subject.Info();
  BenchMethod method;
  method.name = info.name;
  method.summary = info.summary;
  method.kind = "yours";
  method.target = "its own";
  method.model = info.profile.name;
  method.is_users = true;
  method.coordinate_limit = info.profile.coordinate_limit;
  return DrawerOf(subject, std::move(method));
}

std::unique_ptr<SceneDrawer> DrawerOf(Subject& subject, BenchMethod method) {
  return std::make_unique<SubjectDrawer>(subject, std::move(method));
}

}  // namespace rasterproof::bench
