// What Infer() would ask of the likeliest models is asked ahead.
#include "props/engine/pulled_infer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/subject_info.h"
#include "exact/coverage.h"

namespace rasterproof::props {
namespace {

// Hands jobs on, and keeps those that have an answer.
class Listening final : public Subject {
 public:
  explicit Listening(KnownAnswers& answers) : answers_(answers) {}
  const SubjectInfo& OwnInfo() const override { return answers_.Info(); }
  bool SharesCalls() const override { return true; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    for (const DrawJob& job : jobs) {
      if (answers_.TimesAnswered(job) != 0) known_.push_back(job);
    }
    return answers_.DrawMany(jobs);
  }
  std::span<const DrawJob> known() const { return known_; }

 private:
  KnownAnswers& answers_;
  std::vector<DrawJob> known_;
};

// Draws as a model does, in the form that the subject has.
DrawOutcome DrawnByModel(const LikelyModel& model, const SubjectInfo& info, const DrawJob& job) {
  DrawOutcome outcome;
  outcome.end = EndOf([&] {
    CoverageCounts counts = exact::Coverage(SceneOf(job), model.profile, job.options);
    if (model.facing == FacingReport::kReversed) std::swap(counts.front, counts.back);
    if (info.coverage != CoverageKind::kFacingCounts) JoinFacings(counts);
    Drawing& drawing = outcome.drawing;
    drawing.counts = std::move(counts);
    if (!ShowsPrimitiveIds(info)) return;
    for (std::size_t k = 0; k < drawing.counts.size(); ++k)
      drawing.primitive_ids.push_back(drawing.counts.Count(k) != 0 ? 0 : kNoPrimitive);
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    if (job.wants.centroids) drawing.centroids.resize(drawing.counts.size());
  });
  return outcome;
}

// The scenes of draws by which models can be told apart.
std::vector<Scene> ScenesOf(std::span<const DrawJob> jobs) {
  std::vector<Scene> scenes;
  for (const DrawJob& job : jobs) {
    if (job.options == DrawOptions{} && !job.scene->clip_space && job.Triangles().size() == 1) {
      scenes.push_back(SceneOf(job));
      scenes.back().precision = Precision::kFloat32;
    }
  }
  return scenes;
}

}  // namespace

// Of the models that come nearest to what is known; at first of the stated one.
void PulledInfer::AskAhead(KnownAnswers& answers, std::span<const DrawJob> known) const {
  constexpr std::size_t kMostModels = 4;
  constexpr std::size_t kMostOfAModel = 1200;  // requests; its course takes a third of them
  std::vector<LikelyModel> likely = LikelyModels(answers, ScenesOf(known), kMostModels);
  if (likely.empty()) likely.push_back({answers.Info().profile});
  InferOptions ahead = options_;
  for (const LikelyModel& model : likely) {
    if (!answers.HasRoom()) break;
    answers.Suppose([&](const DrawJob& job) { return DrawnByModel(model, answers.Info(), job); });
    // What is shrunk at the end is shrunk in one way, whichever model leads there.
    const bool is_first = &model == &likely.front();
    const std::size_t most = answers.wanted() + kMostOfAModel;
    ahead.ahead = InferAhead{[&] { return answers.missed(); },
                             [&] { return is_first && answers.wanted() < most; }};
    Infer(answers, ahead);
  }
  answers.Suppose({});
  // The first answers once more: does the subject still draw as it did?
  constexpr std::size_t kAskedAgain = 16;
  for (std::size_t k = 0; k < std::min(kAskedAgain, known.size()); ++k) answers.Want(known[k]);
}

bool PulledInfer::GoOn(KnownAnswers& answers) {
  if (result_) return true;
  const std::uint64_t before = answers.missed();
  Listening listening(answers);
  answers.Take(KnownAnswers::Missing::kEndsTheCall);
  Inference inference = Infer(listening, options_);
  answers.Take(KnownAnswers::Missing::kIsRefused);
  done_ = inference.experiments;
  if (answers.missed() == before) {
    inference.seconds = 0;
    result_ = std::move(inference);
    return true;
  }
  // All that is asked of a subject that no model fits, and the experience that models are ranked
  // by.
  DrawAimless(listening, options_);
  AskAhead(answers, listening.known());
  return false;
}

}  // namespace rasterproof::props
