// rasterproof pipe shrink and pipe infer: a program that is not at hand, asked in rounds.
//
// Each call runs the verb from its beginning on the answers of all earlier rounds. Where there is
// no answer yet, what is likely to be asked from there on is the next round.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/hash_text.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/infer/infer.h"
#include "props/judging/redraw.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/submit.h"
#include "props/shrink/foresee.h"
#include "tool/case/cmd_case.h"
#include "tool/case/replay.h"
#include "tool/description.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/infer/cmd_infer.h"
#include "tool/infer/infer_text.h"
#include "tool/load_case.h"
#include "tool/outside.h"
#include "tool/pipe/cmd_pipe.h"
#include "tool/pipe/rounds.h"
#include "tool/resolve.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

constexpr int kConfirmed = 2;  // answers that a result rests on
// Requests of a round. More of them make rounds fewer, but slowly: what shrinking asks is foreseen
// by its likelihood. Of inferring the whole course is foreseen for each likely model.
constexpr std::size_t kMostOfShrinking = 1000;
constexpr std::size_t kMostOfInferring = 4000;

// The description of the program, as it is judged.
class Described final : public Subject {
 public:
  explicit Described(const RoundsOptions& options) : info_(InfoOfProgram(options.description)) {
    if (!options.profile.empty()) JudgeBy(io::ReadProfile(options.profile), *this);
  }
  const SubjectInfo& OwnInfo() const override { return info_; }

 private:
  SubjectInfo info_;
};

std::string StatementsOf(const SubjectInfo& info) {
  return HashText(DescriptionText(info, io::ProfileToJson(info.profile)));
}

int TellChanged(const ChangedAnswer& changed) {
  io::WriteStandardOutput(fmt::format("inconclusive: {}\n", changed.what()));
  return kExitInconclusive;
}

int TellWaiting(const Rounds& rounds) {
  io::WriteStandardOutput(fmt::format(
      "inconclusive so far: {} is not there yet; let the program write it, then run the same "
      "command again\n",
      *rounds.waits_for()));
  return kExitInconclusive;
}

int TellAsked(Rounds& rounds) {
  const std::size_t requests = rounds.asked();
  const std::size_t number = rounds.Write();
  io::WriteStandardOutput(fmt::format(
      "inconclusive so far: round {} asks {} requests in {}; let the program answer them into {}, "
      "then run the same command again\n",
      number, requests, rounds.PathOf(number, "requests"), rounds.PathOf(number, "answers")));
  return kExitInconclusive;
}

// What shrinking may ask.
class ShrinkAhead {
 public:
  ShrinkAhead(AnswersOfRounds& subject, Rounds& rounds, const LoadedCase& loaded,
              std::uint64_t evaluations)
      : subject_(subject),
        rounds_(rounds),
        loaded_(loaded),
        property_(PropertyOf(loaded)),
        evaluations_(evaluations) {}

  void Ask() {
    AskAll(loaded_.value);
    const props::KnownFailures known{[this](const Case& candidate) { return Fails(candidate); },
                                     [this](const Case& candidate) {
                                       AskAll(candidate);
                                       return rounds_.HasRoom();
                                     }};
    const Case smallest = props::Foresee(loaded_.value, known, evaluations_);
    AskAboutResult(smallest);
    // The first answers once more, in every round: does the program still draw as it did?
    subject_.AskUpTo(kOnceMore);
    AskAll(loaded_.value);
    subject_.AskUpTo(1);
  }

  // What is told of the smallest case: is it so once more, which triangle is it, and the picture.
  void AskAboutResult(const Case& smallest) {
    subject_.Take(AnswersOfRounds::Unanswered::kIsRefused);
    subject_.AskUpTo(kConfirmed);
    props::TryCase(subject_, property_, smallest);
    subject_.AskUpTo(1);
    Verdict verdict = props::RunCase(subject_, property_, smallest);
    if (verdict.outcome == Outcome::kViolated) SeeIfItCan(subject_, smallest, verdict);
    subject_.Take(AnswersOfRounds::Unanswered::kEndsTheCall);
  }

 private:
  static constexpr int kOnceMore = 1 << 20;

  std::optional<bool> Fails(const Case& candidate) {
    const std::uint64_t before = subject_.missed();
    const props::Trial trial = props::TryCase(subject_, property_, candidate);
    if (subject_.missed() != before) return std::nullopt;
    return trial.verdict.outcome == Outcome::kViolated;
  }

  // The questions of all checks of the case, whatever comes of the first ones.
  void AskAll(const Case& c) {
    const props::Description description = props::DescriptionOf(subject_);
    const props::CaseJudge hand(property_, c, description);
    if (hand.IsDone()) return;
    subject_.Take(AnswersOfRounds::Unanswered::kIsRefused);
    for (const props::Check& check : hand.AllChecks()) {
      const props::Check alone{check.questions, {}};
      const props::Request request{&hand.Placed(), &alone, nullptr};
      props::Submit(subject_, {&request, 1});
    }
    subject_.Take(AnswersOfRounds::Unanswered::kEndsTheCall);
  }

  AnswersOfRounds& subject_;
  Rounds& rounds_;
  const LoadedCase& loaded_;
  const props::Property& property_;
  std::uint64_t evaluations_;
};

void RequireShrinkable(const LoadedCase& loaded) {
  const props::Property& property = PropertyOf(loaded);
  if (!property.is_about_sequence) return;
  throw InputError(fmt::format("property {}", property.name),
                   "it is about what one call leaves to the next, and a file of requests is no "
                   "sequence of calls",
                   "shrink it where the program runs: replay --shrink --exec");
}

int ShrinkInRounds(const ShrinkRoundsOptions& options) {
  const Described described(options.rounds);
  ReplayOptions replay{
      .choice = options.choice, .shrink = options.output, .evaluations = options.evaluations};
  replay.choice.subject = described.Info().name;
  replay.choice.profile = options.rounds.profile;
  std::shared_ptr<Rounds> rounds;
  LoadedCase loaded = LoadCase(replay.choice, "replay", [&] {
    return std::make_unique<AnswersOfRounds>(described.Info(), nullptr);
  });
  RequireShrinkable(loaded);
  RequireTakes(*loaded.subject, loaded.value.scene, "case");
  RequireDrawsSamples(*loaded.subject, loaded.value.profile, "case");
  RoundsTask task{{"verb", "shrink"},
                  {"description or profile", StatementsOf(described.Info())},
                  {"case", HashText(io::CaseToJson({loaded.value, "", ""}))},
                  {"property", std::string(PropertyOf(loaded).name)},
                  {"number of evaluations", std::to_string(options.evaluations)}};
  rounds = std::make_shared<Rounds>(options.rounds.folder, std::move(task), described.Info(),
                                    kMostOfShrinking);
  if (rounds->waits_for()) return TellWaiting(*rounds);
  auto made = std::make_unique<AnswersOfRounds>(described.Info(), rounds);
  AnswersOfRounds& subject = *made;
  loaded.subject = std::move(made);
  const Counterexample found = props::ShrinkFailing(subject, PropertyOf(loaded), loaded.value,
                                                    ShrinkingBy(subject, options.evaluations));
  ShrinkAhead ahead(subject, *rounds, loaded, options.evaluations);
  if (subject.missed() != 0) {
    ahead.Ask();
  } else if (found.outcome == Outcome::kViolated) {
    ahead.AskAboutResult(found.value);
  }
  return rounds->asked() != 0 ? TellAsked(*rounds) : Replay(replay, std::move(loaded));
}

// Draws as a model does, in the form that the program has.
DrawOutcome DrawnByModel(const props::LikelyModel& model, const SubjectInfo& info,
                         const DrawJob& job) {
  DrawOutcome outcome;
  outcome.end = EndOf([&] {
    CoverageCounts counts = exact::Coverage(SceneOf(job), model.profile, job.options);
    if (model.facing == props::FacingReport::kReversed) std::swap(counts.front, counts.back);
    if (info.coverage != CoverageKind::kFacingCounts) props::JoinFacings(counts);
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

// Of each draw that is known its scene.
std::vector<Scene> ScenesOf(const std::vector<DrawJob>& jobs) {
  std::vector<Scene> scenes;
  for (const DrawJob& job : jobs) {
    if (job.options == DrawOptions{} && !job.scene->clip_space && job.Triangles().size() == 1) {
      scenes.push_back(SceneOf(job));
      scenes.back().precision = Precision::kFloat32;
    }
  }
  return scenes;
}

// What is asked of the models that come nearest to what is known; at first of the stated one.
void InferAhead(AnswersOfRounds& subject, const std::shared_ptr<Rounds>& rounds,
                const props::InferOptions& choice) {
  constexpr std::size_t kMostModels = 4;
  constexpr std::size_t kMostOfAModel = 1200;  // requests; its course takes a third of them
  std::vector<props::LikelyModel> likely =
      props::LikelyModels(subject, ScenesOf(rounds->answered()), kMostModels);
  if (likely.empty()) likely.push_back({subject.Info().profile});
  props::InferOptions ahead = choice;
  for (const props::LikelyModel& model : likely) {
    if (!rounds->HasRoom()) break;
    subject.Suppose([&](const DrawJob& job) { return DrawnByModel(model, subject.Info(), job); });
    // What is shrunk at the end is shrunk in one way, whichever model leads there.
    const bool is_first = &model == &likely.front();
    const std::size_t most = rounds->asked() + kMostOfAModel;
    ahead.ahead = props::InferAhead{[&] { return subject.missed(); },
                                    [&] { return is_first && rounds->asked() < most; }};
    props::Infer(subject, ahead);
    // All that is asked of a subject that no model fits, and the experience that models are
    // ranked by.
    if (is_first) props::DrawAimless(subject, choice);
  }
  subject.Suppose({});
  // The first answers once more: does the program still draw as it did?
  constexpr std::size_t kAskedAgain = 16;
  for (std::size_t k = 0; k < std::min(kAskedAgain, rounds->answered().size()); ++k)
    rounds->Ask(rounds->answered()[k]);
}

int InferInRounds(const InferRoundsOptions& options) {
  const Described described(options.rounds);
  const SubjectInfo& info = described.Info();
  RequireSamples(info);
  RoundsTask task{{"verb", "infer"},
                  {"description or profile", StatementsOf(info)},
                  {"seed", std::to_string(options.seed)}};
  const auto rounds =
      std::make_shared<Rounds>(options.rounds.folder, std::move(task), info, kMostOfInferring);
  if (rounds->waits_for()) return TellWaiting(*rounds);
  AnswersOfRounds subject(info, rounds);
  props::InferOptions choice;
  choice.seed = options.seed;
  const props::Inference inference = props::Infer(subject, choice);
  if (subject.missed() == 0) return TellInference(inference, info, options.json);
  InferAhead(subject, rounds, choice);
  return TellAsked(*rounds);
}

}  // namespace

int RunShrinkRounds(const ShrinkRoundsOptions& options) {
  RequireHonestEnvironment();
  try {
    return ShrinkInRounds(options);
  } catch (const ChangedAnswer& changed) {
    return TellChanged(changed);
  }
}

int RunInferRounds(const InferRoundsOptions& options) {
  RequireHonestEnvironment();
  try {
    return InferInRounds(options);
  } catch (const ChangedAnswer& changed) {
    return TellChanged(changed);
  }
}

}  // namespace rasterproof::tool
