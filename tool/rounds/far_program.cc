#include "tool/rounds/far_program.h"

#include <filesystem>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/hash_text.h"
#include "core/subject.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "subjects/process/protocol.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

std::string FolderOf(const std::string& subject) {
  std::string folder = subject.substr(kRoundsPrefix.size());
  if (folder.empty()) throw InputError(subject, "it names no folder", "give rounds:FOLDER");
  return folder;
}

// The file with what the program states; "" if there is none.
std::string DescriptionIn(const std::string& folder) {
  const std::string file = folder + "/program.subject";
  return std::filesystem::exists(file) ? file : "";
}

// The description of the program. It draws nothing.
class Described final : public Subject {
 public:
  explicit Described(const std::string& subject)
      : info_(Kinds().not_at_hand(DescriptionIn(FolderOf(subject)))) {
    info_.name = subject;
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

props::PulledEngine EngineOf(const SubjectInfo& info, props::RoundSize most) {
  return props::PulledEngine(info, most, [info](const DrawJob& job) {
    return subjects::RequestsText(1, {&job, 1}, info);
  });
}

int TellAsked(Rounds& rounds, std::span<const DrawJob> jobs) {
  const std::size_t number = rounds.Write(jobs);
  io::WriteStandardOutput(fmt::format(
      "inconclusive so far: round {} has {} requests in {}; let the program write its answers to "
      "{}, then repeat this command\n",
      number, jobs.size(), rounds.PathOf(number, "requests"), rounds.PathOf(number, "answers")));
  return kExitInconclusive;
}

}  // namespace

FarProgram::FarProgram(std::string subject, const std::string& profile, props::RoundSize most,
                       bool device, std::size_t list_length)
    : folder_(FolderOf(subject)),
      engine_(EngineOf(ResolveSubject(subject, profile, device, list_length,
                                      [subject] { return std::make_unique<Described>(subject); })
                           .Make()
                           ->Info(),
                       most)) {}

SubjectMaker FarProgram::Maker() {
  return [this] { return std::make_unique<DrawnByAnswers>(engine_.answers()); };
}

int FarProgram::GoOn(Rounds& rounds, const std::function<void()>& ask,
                     const std::function<int()>& tell) {
  if (rounds.waits_for()) {
    io::WriteStandardOutput(fmt::format(
        "inconclusive so far: {} is missing; let the program write it, then repeat this command\n",
        *rounds.waits_for()));
    return kExitInconclusive;
  }
  if (const std::vector<DrawJob>& jobs = engine_.Next(); !jobs.empty())
    return TellAsked(rounds, jobs);
  ask();
  if (Interrupted()) return InterruptStatus();
  const std::vector<DrawJob> jobs = engine_.answers().TakeWanted();
  return jobs.empty() ? tell() : TellAsked(rounds, jobs);
}

int FarProgram::Run(const std::function<void()>& ask, const std::function<int()>& tell) {
  const std::string file = DescriptionIn(folder_);
  const std::string stated =
      (file.empty() ? "" : io::ReadFile(file)) + io::ProfileToJson(Info().profile);
  try {
    Rounds rounds(folder_, HashText(stated), engine_);
    return GoOn(rounds, ask, tell);
  } catch (const ChangedAnswer& changed) {
    io::WriteStandardOutput(fmt::format("inconclusive: {}\n", changed.what()));
    return kExitInconclusive;
  }
}

}  // namespace rasterproof::tool
