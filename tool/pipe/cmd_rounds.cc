#include "tool/pipe/cmd_rounds.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/hash_text.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/engine/pulled.h"
#include "subjects/process/protocol.h"
#include "tool/case/replay.h"
#include "tool/description.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/infer/infer_text.h"
#include "tool/load_case.h"
#include "tool/outside.h"
#include "tool/pipe/rounds.h"
#include "tool/resolve.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// Requests of a round. More of them make rounds fewer, but slowly: what shrinking asks is foreseen
// by its likelihood. Of inferring the whole course is foreseen for each likely model.
constexpr props::RoundSize kOfShrinking{.requests = 1000};
constexpr props::RoundSize kOfInferring{.requests = 4000};

std::string FolderOf(const std::string& subject) {
  std::string folder = subject.substr(kRoundsPrefix.size());
  if (folder.empty()) throw InputError(subject, "it names no folder", "give rounds:FOLDER");
  return folder;
}

// The description of the program, as it is judged.
class Described final : public Subject {
 public:
  Described(const std::string& subject, const std::string& profile) {
    std::string file = FolderOf(subject) + "/program.subject";
    if (!std::filesystem::exists(file)) file.clear();
    info_ = InfoOfProgram(file);
    info_.name = subject;
    if (!profile.empty()) JudgeBy(io::ReadProfile(profile), *this);
  }
  const SubjectInfo& OwnInfo() const override { return info_; }

 private:
  SubjectInfo info_;
};

// Draws by the answers of an engine that outlives it.
class DrawnByAnswers final : public Subject {
 public:
  explicit DrawnByAnswers(props::KnownAnswers& answers) : answers_(answers) {}
  const SubjectInfo& OwnInfo() const override { return answers_.OwnInfo(); }
  bool SharesCalls() const override { return true; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    return answers_.DrawMany(jobs);
  }

 private:
  props::KnownAnswers& answers_;
};

props::PulledEngine EngineOf(const SubjectInfo& info, props::RoundSize size) {
  return props::PulledEngine(info, size, [info](const DrawJob& job) {
    return subjects::RequestsText(1, {&job, 1}, info);
  });
}

std::string StatementsOf(const SubjectInfo& info) {
  return HashText(DescriptionText(info, io::ProfileToJson(info.profile)));
}

int TellWaiting(const std::string& waits_for) {
  io::WriteStandardOutput(fmt::format(
      "inconclusive so far: {} is missing; let the program write it, then repeat this command\n",
      waits_for));
  return kExitInconclusive;
}

int TellAsked(Rounds& rounds, std::span<const DrawJob> jobs) {
  const std::size_t number = rounds.Write(jobs);
  io::WriteStandardOutput(fmt::format(
      "inconclusive so far: round {} has {} requests in {}; let the program write its answers to "
      "{}, then repeat this command\n",
      number, jobs.size(), rounds.PathOf(number, "requests"), rounds.PathOf(number, "answers")));
  return kExitInconclusive;
}

// Goes on with the engine's works by the answers in the folder. Returns the exit status if they do
// not suffice.
std::optional<int> GoOn(Rounds& rounds, props::PulledEngine& engine) {
  if (rounds.waits_for()) return TellWaiting(*rounds.waits_for());
  const std::vector<DrawJob>& jobs = engine.Next();
  return jobs.empty() ? std::nullopt : std::optional(TellAsked(rounds, jobs));
}

template <class Verb>
int UnlessChanged(const Verb& verb) {
  try {
    return verb();
  } catch (const ChangedAnswer& changed) {
    io::WriteStandardOutput(fmt::format("inconclusive: {}\n", changed.what()));
    return kExitInconclusive;
  }
}

void RequireShrinkable(const ReplayOptions& options, const LoadedCase& loaded) {
  if (options.shrink.empty()) {
    throw InputError(options.choice.subject, "one case is no reason for rounds",
                     "give --shrink FILE, or judge one case where the program runs");
  }
  RequireTakes(*loaded.subject, loaded.value.scene, "case");
  RequireDrawsSamples(*loaded.subject, loaded.value.profile, "case");
  const props::Property& property = PropertyOf(loaded);
  if (!property.is_about_sequence) return;
  throw InputError(fmt::format("property {}", property.name),
                   "it needs a sequence of calls, and a file of requests is one call",
                   "shrink it where the program runs: replay --shrink --exec");
}

}  // namespace

int ShrinkInRounds(const ReplayOptions& options) {
  const Described described(options.choice.subject, options.choice.profile);
  props::PulledEngine engine = EngineOf(described.Info(), kOfShrinking);
  LoadedCase loaded = LoadCase(options.choice, "replay",
                               [&] { return std::make_unique<DrawnByAnswers>(engine.answers()); });
  RequireShrinkable(options, loaded);
  const props::Property& property = PropertyOf(loaded);
  RoundsTask task{{"verb", "shrink"},
                  {"description or profile", StatementsOf(described.Info())},
                  {"case", HashText(io::CaseToJson({loaded.value, "", ""}))},
                  {"property", std::string(property.name)},
                  {"number of evaluations", std::to_string(options.evaluations)}};
  return UnlessChanged([&] {
    Rounds rounds(FolderOf(options.choice.subject), std::move(task), engine);
    const props::PulledShrink& shrink = engine.Add(std::make_unique<props::PulledShrink>(
        property, loaded.value, ShrinkingBy(*loaded.subject, options.evaluations)));
    if (const std::optional<int> status = GoOn(rounds, engine)) return *status;
    const Counterexample& found = shrink.result();
    if (found.outcome == Outcome::kViolated) {  // the picture asks, too
      Verdict verdict = found.verdict;
      SeeIfItCan(*loaded.subject, found.value, verdict);
    }
    const std::vector<DrawJob> jobs = engine.answers().TakeWanted();
    return jobs.empty() ? Replay(options, std::move(loaded)) : TellAsked(rounds, jobs);
  });
}

int InferInRounds(const InferOptions& options) {
  const Described described(options.subject, options.profile);
  const SubjectInfo& info = described.Info();
  RequireSamples(info);
  props::PulledEngine engine = EngineOf(info, kOfInferring);
  RoundsTask task{{"verb", "infer"},
                  {"description or profile", StatementsOf(info)},
                  {"seed", std::to_string(options.seed)}};
  return UnlessChanged([&] {
    Rounds rounds(FolderOf(options.subject), std::move(task), engine);
    props::InferOptions choice;
    choice.seed = options.seed;
    const props::PulledInfer& infer = engine.Add(std::make_unique<props::PulledInfer>(choice));
    if (const std::optional<int> status = GoOn(rounds, engine)) return *status;
    return TellInference(infer.result(), info, options.json);
  });
}

}  // namespace rasterproof::tool
