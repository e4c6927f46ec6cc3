// rasterproof pipe ask and pipe judge: a program that draws, on a pipe laid by hand.
//
// Both make the same cases and put the property to the test on a subject that has no pixels of its
// own: ask's writes down what it is asked to draw, judge's answers with what the program said.
#include "tool/pipe/cmd_pipe.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/question.h"
#include "core/quoted.h"
#include "core/result.h"
#include "core/subject.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/campaign.h"
#include "props/run/conclude.h"
#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/submit.h"
#include "subjects/process/protocol.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/resolve_case.h"
#include "tool/session.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

SubjectInfo InfoOf(const PipeOptions& options) {
  SubjectInfo info = InfoOfProgram(options.description);
  if (!options.profile.empty()) info.profile = io::ReadProfile(options.profile);
  return info;
}

// A rasterizer at the far end of a pipe that is laid by hand.
class FarEnd : public Subject {
 public:
  explicit FarEnd(const SubjectInfo& info) : info_(info) {}
  const SubjectInfo& OwnInfo() const override { return info_; }

 protected:
  const SubjectInfo& info() const { return info_; }

 private:
  SubjectInfo info_;
};

// What is asked is written down, and nothing is covered.
class Asking final : public FarEnd {
 public:
  using FarEnd::FarEnd;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    asked_.insert(asked_.end(), jobs.begin(), jobs.end());
    std::vector<DrawOutcome> outcomes(jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      Drawing& drawing = outcomes[k].drawing;
      drawing.counts = CoverageCounts(jobs[k].scene->width, jobs[k].scene->height, jobs[k].samples);
      if (!ShowsPrimitiveIds(info())) continue;
      drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
      drawing.barycentrics.resize(drawing.counts.size());
      drawing.depths.resize(drawing.counts.size());
      if (jobs[k].wants.centroids) drawing.centroids.resize(drawing.counts.size());
    }
    return outcomes;
  }
  std::vector<DrawJob> Asked() { return std::exchange(asked_, {}); }

 private:
  std::vector<DrawJob> asked_;
};

// What a program answered, line by line. Behind a bad answer the next one begins where a line says
// so, however many lines the bad one has.
class AnswerLines {
 public:
  std::string_view Next() {
    if (!Peek()) {
      line_.clear();
      is_short_ = true;
    }
    is_held_ = false;
    return line_;
  }
  // After a line that announces an array.
  std::string_view NextBytes(std::size_t count) {
    bytes_.resize(count);
    std::cin.read(bytes_.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(std::cin.gcount()) < count) {
      is_short_ = true;
      BreakDown("what it said ends within an array");
    }
    return bytes_;
  }
  void RequireEndOfAnswer() {
    if (!Peek() || subjects::AnsweredRequest(line_) != 0) return;
    BreakDown("it said more than its answer: " + Quoted(line_, 60));
  }
  // The answer to request `id` was a bad one.
  void PassOver(std::uint64_t id) {
    if (is_short_) return;
    is_held_ = true;  // what was read last may be the next one's head
    for (; Peek(); is_held_ = false) {
      if (subjects::AnsweredRequest(line_) > id) return;
    }
    is_lost_ = true;
  }
  void RequireAll() const {
    if (is_lost_ || !is_short_) return;
    throw InputError("standard input", "it ends before every request was answered",
                     "give judge the same options as ask, and flush what the program says");
  }
  // Behind the last answer: more was answered than was asked.
  void RequireEnd() {
    if (!Peek()) return;
    throw InputError(fmt::format("standard input: line {}", number_),
                     "it goes on after the last answer: " + Quoted(line_, 60),
                     "give judge the same options as ask, and one answer to each request");
  }

 private:
  // Whether there is a line to be read next.
  bool Peek() {
    if (is_held_) return true;
    is_held_ = static_cast<bool>(std::getline(std::cin, line_));
    if (is_held_) ++number_;
    return is_held_;
  }

  std::string line_;
  std::string bytes_;
  std::uint64_t number_ = 0;  // of the line, from 1
  bool is_held_ = false;      // the line is to be read, again or for the first time
  bool is_short_ = false;     // there was none where one was needed
  bool is_lost_ = false;      // no line after a bad answer began another one
};

// judge's: every job is answered by what the program said, in the same order.
class Answering final : public FarEnd {
 public:
  using FarEnd::FarEnd;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    std::vector<DrawOutcome> outcomes(jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      auto& [drawing, end] = outcomes[k];
      Drawing& drawn = drawing;
      end = EndOf([&] {
        drawn = subjects::ReadAnswer(
            ++id_, jobs[k], info(), [this](std::size_t /*most_bytes*/) { return lines_.Next(); },
            [this](std::size_t count) { return lines_.NextBytes(count); });
        if (jobs[k].onto != nullptr) drawn.counts += *jobs[k].onto;
        lines_.RequireEndOfAnswer();
      });
      if (IsBreakdown(end.stop)) lines_.PassOver(id_);
    }
    return outcomes;
  }
  // Reads the answers to jobs that were asked for and are not looked at.
  void Skip(std::span<const DrawJob> jobs) {
    for (const DrawJob& job : jobs) DrawMany({&job, 1});
  }
  std::uint64_t answered() const { return id_; }
  void RequireAll() const { lines_.RequireAll(); }
  void RequireEnd() { lines_.RequireEnd(); }

 private:
  std::uint64_t id_ = 0;
  AnswerLines lines_;
};

// The answers to all that is asked about a case: to every check, whatever comes of those before it,
// and to the draw of the whole case, which the picture of a failure shows.
struct AllAnswers {
  std::vector<Answers> of_checks;  ///< those of their bases not among them
  Answers of_picture;
};

// Submits one check's questions.
using SubmitOne = std::function<Answers(const props::Request&)>;

Answers SubmitTo(Subject& subject, const props::Request& request) {
  return std::move(props::Submit(subject, {&request, 1}).front());
}

// Passes over the remaining answers after a fault or a refusal. A check that ends early does not
// draw the rest, but here it was already requested; its answers would be taken for later ones.
Answers SubmitInStep(Answering& answering, Asking& asking, const props::Request& request) {
  SubmitTo(asking, request);
  const std::vector<DrawJob> asked = asking.Asked();
  const std::uint64_t before = answering.answered();
  Answers answers = SubmitTo(answering, request);
  answering.Skip(std::span(asked).subspan(answering.answered() - before));
  return answers;
}

AllAnswers SubmitAll(const SubmitOne& submit_one, const props::CaseJudge& hand) {
  AllAnswers all;
  const auto submit = [&](const Questions& questions) {
    const props::Check check{questions, {}};
    return submit_one({&hand.Placed(), &check, nullptr});
  };
  if (hand.IsDone()) return all;
  for (const props::Check& check : hand.AllChecks())
    all.of_checks.push_back(submit(check.questions));
  const props::PlacedCase& c = hand.Placed();
  Questions picture;
  picture.draws.push_back(props::CountsOf(c.scene, c.profile, c.options));
  all.of_picture = submit(picture);
  return all;
}

bool IsAnyRefused(const AllAnswers& all) {
  const auto is_refused = [](const Answers& answers) { return answers.end.stop == Stop::kRefused; };
  return is_refused(all.of_picture) || std::ranges::any_of(all.of_checks, is_refused);
}

// Judges the checks by their answers, up to the first violated one.
const Verdict& JudgeAll(props::CaseJudge& hand, AllAnswers& all) {
  std::vector<std::shared_ptr<const Drawing>> drawn;
  for (std::size_t k = 0; !hand.IsDone(); ++k) {
    Answers& answers = all.of_checks[k];
    const std::vector<std::shared_ptr<const Drawing>> own = answers.draws;
    std::vector<std::shared_ptr<const Drawing>> draws;
    for (const std::size_t base : hand.AllChecks()[k].bases) draws.push_back(drawn[base]);
    draws.insert(draws.end(), own.begin(), own.end());
    drawn.insert(drawn.end(), own.begin(), own.end());
    answers.draws = std::move(draws);
    hand.Take(answers);
  }
  return hand.Result().verdict;
}

// Shrinks the case with a program that is reached by files alone.
std::string ShrinkLine(const PipeOptions& options, const std::string& case_name) {
  std::string line = fmt::format(
      "to shrink it by files, where the program can't be started from here:\n"
      "  rasterproof pipe shrink --case {} --property {}",
      ShellWord(case_name), options.property);
  if (!options.description.empty()) line += " --description " + ShellWord(options.description);
  if (!options.profile.empty()) line += " --profile " + ShellWord(options.profile);
  return line + " --rounds shrinking --output small.json\n";
}

// Of a run that asked for no drawing at all.
void ReportNotExercised(const props::Property& property, std::uint64_t cases,
                        const std::string& why_not) {
  std::cerr << fmt::format("{}: none of {} cases asks for a drawing: {}\n", property.name, cases,
                           why_not.empty() ? "it was never put to the test" : why_not);
}

// A few properties that ask this subject for drawings.
std::vector<std::string_view> ThoseThatAsk(const SubjectInfo& info,
                                           const props::Description& description) {
  constexpr std::size_t kMostNamed = 6;
  constexpr std::uint64_t kCasesTried = 3;
  std::vector<std::string_view> names;
  for (const props::Property& property : props::Catalog()) {
    bool asks = false;
    for (std::uint64_t n = 0; n < kCasesTried && !asks; ++n) {
      try {
        const Case c = props::DrawCase(info, property, 1, n);
        asks = !props::CaseJudge(property, c, description).IsDone();
      } catch (const InputError&) {  // none of its domains suits the subject
        break;
      }
    }
    if (asks) names.push_back(property.name);
    if (names.size() == kMostNamed) break;
  }
  return names;
}

struct PipeTally {
  std::uint64_t held = 0;
  std::uint64_t refused = 0;
  std::uint64_t idle = 0;  ///< the case did not exercise the property
  std::uint64_t violated = 0;

  int Status() const {
    if (violated != 0) return kExitViolated;
    const auto asked = static_cast<double>(refused + held);
    const bool refuses_too_much = static_cast<double>(refused) > props::kMostRefusedShare * asked;
    return held != 0 && !refuses_too_much ? kExitHolds : kExitInconclusive;
  }
};

}  // namespace

int RunAsk(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  Asking asking(info);
  const props::Description description = props::DescriptionOf(asking);
  std::uint64_t id = 0;
  std::string why_not;
  for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
    const Case c = props::DrawCase(info, property, options.campaign.seed, n);
    const props::CaseJudge hand(property, c, description);
    if (hand.IsDone() && why_not.empty()) why_not = hand.Result().verdict.message;
    SubmitAll([&](const props::Request& request) { return SubmitTo(asking, request); }, hand);
    const std::vector<DrawJob> jobs = asking.Asked();
    io::WriteStandardOutput(subjects::RequestsText(id + 1, jobs, info));
    id += jobs.size();
  }
  if (id != 0) return kExitHolds;
  ReportNotExercised(property, options.campaign.cases, why_not);
  const std::string asking_ones =
      fmt::format("{}", fmt::join(ThoseThatAsk(info, description), ", "));
  if (!asking_ones.empty()) std::cerr << "properties that ask: " << asking_ones << '\n';
  return kExitInconclusive;
}

int RunJudge(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  Answering answering(info);
  Asking asking(info);
  const SubmitOne submit = [&](const props::Request& request) {
    return SubmitInStep(answering, asking, request);
  };
  const props::Description description = props::DescriptionOf(answering);
  PipeTally tally;
  std::string why_not;
  std::string failures;
  {
    Progress progress;
    progress.Stage(fmt::format("judging {}", property.name), options.campaign.cases);
    for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
      progress.Done(n);
      const Case c = props::DrawCase(info, property, options.campaign.seed, n);
      props::CaseJudge hand(property, c, description);
      if (hand.IsDone() && why_not.empty()) why_not = hand.Result().verdict.message;
      AllAnswers all = SubmitAll(submit, hand);
      answering.RequireAll();
      if (IsAnyRefused(all)) {
        ++tally.refused;
        continue;
      }
      const Verdict& verdict = JudgeAll(hand, all);
      if (verdict.outcome == Outcome::kHolds) ++tally.held;
      if (verdict.outcome == Outcome::kNotExercised) ++tally.idle;
      if (verdict.outcome != Outcome::kViolated) continue;
      if (tally.violated++ == 0) {
        CaseChoice choice;
        choice.subject = std::string(kExecPrefix) + "PROGRAM";
        choice.property = property.name;
        choice.profile = options.profile;
        choice.name = c.origin;
        Verdict seen = verdict;
        if (!seen.seen && !all.of_picture.draws.empty()) seen.seen = all.of_picture.draws.front();
        SubjectInfo shown = info;
        shown.coverage = CoverageKind::kFacingCounts;
        failures = FailureText(shown, choice.property, c, seen, CommandFor("replay", choice)) +
                   ShrinkLine(options, c.origin);
      }
    }
  }
  answering.RequireEnd();
  if (answering.answered() == 0) ReportNotExercised(property, options.campaign.cases, why_not);
  io::WriteStandardOutput(
      fmt::format("{}{}: {} cases held, {} violated, {} did not exercise it, {} refused\n",
                  failures, property.name, tally.held, tally.violated, tally.idle, tally.refused));
  return tally.Status();
}

}  // namespace rasterproof::tool
