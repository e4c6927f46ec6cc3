// rasterproof check: the properties, on generated cases, given scenes or cases by their names.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/contract_evidence.h"
#include "props/run/property_domains.h"
#include "props/run/tally.h"
#include "report/text.h"
#include "tool/commands.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

std::vector<const props::Property*> ChosenProperties(const CheckOptions& options) {
  std::vector<const props::Property*> chosen;
  for (const std::string& name : options.properties) chosen.push_back(&RequireProperty(name));
  if (!chosen.empty()) return chosen;
  for (const props::Property& property : props::Catalog()) chosen.push_back(&property);
  return chosen;
}

// What a whole run comes to: one violation outweighs all, then a claim that could not be judged;
// nothing exercised is no pass.
class Tally {
 public:
  void Count(Outcome outcome, std::uint64_t cases) {
    ++counts_[static_cast<std::size_t>(outcome)];
    cases_ += cases;
  }
  std::uint64_t Of(Outcome outcome) const { return counts_[static_cast<std::size_t>(outcome)]; }
  int ExitStatus() const {
    if (Of(Outcome::kViolated) != 0) return kExitViolated;
    if (Of(Outcome::kInconclusive) != 0 || RefusesTooMuch()) return kExitInconclusive;
    return Of(Outcome::kHolds) != 0 ? kExitHolds : kExitInconclusive;
  }
  std::string Line(const std::string& subject) const {
    std::string line = fmt::format("{}: {} hold, {} violated, {} not exercised, {} not applicable",
                                   subject, Of(Outcome::kHolds), Of(Outcome::kViolated),
                                   Of(Outcome::kNotExercised), Of(Outcome::kNotApplicable));
    for (const Outcome outcome : {Outcome::kRefused, Outcome::kInconclusive}) {
      if (Of(outcome) != 0) line += fmt::format(", {} {}", Of(outcome), OutcomeName(outcome));
    }
    return line + fmt::format("; {} cases\n", cases_);
  }

 private:
  // Of claims on given scenes. A campaign has counted the refusals of its cases itself.
  bool RefusesTooMuch() const {
    const auto refused = static_cast<double>(Of(Outcome::kRefused));
    const auto holds = static_cast<double>(Of(Outcome::kHolds));
    return refused > props::kMostRefusedShare * (refused + holds);
  }

  std::array<std::uint64_t, 6> counts_{};  // by Outcome
  std::uint64_t cases_ = 0;
};

// What was not asked of a subject: one line for each reason, with the properties that share it.
class NotAsked {
 public:
  void Add(const std::string& reason, std::string_view property) {
    const auto same = std::ranges::find(reasons_, reason, &Reason::text);
    Reason& entry = same != reasons_.end() ? *same : reasons_.emplace_back(Reason{reason, {}});
    entry.properties.emplace_back(property);
  }
  /// `of` names the scene in front of each reason, or is empty.
  std::string Lines(const std::string& subject, const std::string& of) const {
    std::string lines;
    for (const Reason& reason : reasons_) {
      lines += fmt::format("{:<16} {:<10} {}{}: {}\n", OutcomeName(Outcome::kNotApplicable),
                           subject, of, reason.text, fmt::join(reason.properties, ", "));
    }
    return lines;
  }

 private:
  struct Reason {
    std::string text;
    std::vector<std::string> properties;
  };
  std::vector<Reason> reasons_;
};

std::string NotJudgedText(std::uint64_t samples) {
  return samples == 0
             ? ""
             : fmt::format(", {} samples not judged: a legal choice could turn the triangle",
                           samples);
}

std::string ResultLine(const PropertyResult& result) {
  std::string line = fmt::format("{:<16} {:<10} {:<50} {} cases, exercised {} times in {}",
                                 OutcomeName(result.outcome), result.subject, result.property,
                                 result.cases, result.exercised, result.cases_exercised);
  if (result.cases_refused != 0) line += fmt::format(", {} refused", result.cases_refused);
  line += NotJudgedText(result.not_judged);
  if (result.worst_ratio != 0) line += fmt::format(", error/bound {:.3f}", result.worst_ratio);
  if (!result.message.empty()) line += "; " + report::CleanText(result.message);
  return line + "\n";
}

void SaveCounterexample(const std::string& folder, const PropertyResult& result) {
  io::MakeFolder(folder);
  io::WriteFile(fmt::format("{}/{}-{}.json", folder, FileNameOf(result.subject), result.property),
                io::CaseToJson({*result.counterexample, result.subject, result.property}));
}

// One property on generated cases, its progress told.
PropertyResult Campaign(Subject& subject, const props::Property& property,
                        const CheckOptions& options, Progress& progress, props::Pace& pace) {
  const std::string stage = fmt::format("{} {}", subject.Info().name, property.name);
  progress.Stage(stage, options.campaign.cases);
  props::CampaignOptions campaign;
  campaign.seed = options.campaign.seed;
  campaign.cases = options.campaign.cases;
  campaign.seconds = options.campaign.seconds;
  campaign.time_limit = TimeLimitOf(subject);
  campaign.progress = [&](std::uint64_t done) { progress.Done(done); };
  campaign.shrinking = [&](std::uint64_t evaluations) {
    if (evaluations == 0) progress.Stage(stage + ": shrinking what failed", campaign.shrink_budget);
    progress.Done(evaluations);
  };
  campaign.stop = Interrupted;
  campaign.pace = &pace;
  return props::RunCampaign(subject, property, campaign);
}

// A run in which no claim of the contract was put to the test is no pass, whatever else holds.
std::string ContractText(const Subject& subject, std::span<const PropertyResult> results,
                         Tally& tally) {
  const props::ContractEvidence evidence = props::EvidenceOfContract(subject.Info(), results);
  if (evidence.is_exercised) return "";
  tally.Count(Outcome::kInconclusive, 0);
  return fmt::format("{:<16} {:<10} its contract was not put to the test: {}\n",
                     OutcomeName(Outcome::kInconclusive), subject.Info().name, evidence.why);
}

void CheckGenerated(Subject& subject, const CheckOptions& options, Progress& progress,
                    std::string& text, Tally& tally) {
  const std::string& name = subject.Info().name;
  NotAsked not_asked;
  props::Pace pace;
  std::vector<PropertyResult> results;
  for (const props::Property* property : ChosenProperties(options)) {
    if (Interrupted()) break;
    const PropertyResult& result =
        results.emplace_back(Campaign(subject, *property, options, progress, pace));
    tally.Count(result.outcome, result.cases);
    if (result.outcome == Outcome::kNotApplicable && !result.counterexample) {
      not_asked.Add(result.message, property->name);
      continue;
    }
    text += ResultLine(result);
    if (!result.counterexample || !result.verdict) continue;
    CaseChoice choice;
    choice.subject = name;
    choice.property = property->name;
    choice.profile = options.profile;
    choice.name = result.failing_case;
    text += FailureText(subject, result.property, *result.counterexample, *result.verdict,
                        CommandFor("replay", choice), /*colour=*/false);
    if (!options.save.empty()) SaveCounterexample(options.save, result);
  }
  text += not_asked.Lines(name, "");
  if (options.properties.empty() && !Interrupted()) text += ContractText(subject, results, tally);
}

// The cases that the user names, by files or by their own names.
std::vector<CaseChoice> GivenCases(const CheckOptions& options) {
  std::vector<CaseChoice> all;
  for (const std::string& path : options.scenes) all.emplace_back().path = path;
  for (const std::string& name : options.named) all.emplace_back().name = name;
  return all;
}

Case LoadGiven(const Subject& subject, const CaseChoice& choice) {
  if (choice.path.empty()) return props::DrawCase(subject.Info(), RequireCaseName(choice.name));
  Case given = io::ReadCase(choice.path).value;
  given.profile = subject.Info().profile;
  RequireTakes(subject, given.scene, choice.path);
  return given;
}

void CheckGiven(Subject& subject, const CheckOptions& options, Progress& progress,
                std::string& text, Tally& tally) {
  const std::string& name = subject.Info().name;
  std::vector<PropertyResult> results;
  for (CaseChoice choice : GivenCases(options)) {
    NotAsked not_asked;
    const Case given = LoadGiven(subject, choice);
    const std::string of = choice.path.empty() ? choice.name : choice.path;
    for (const props::Property* property : ChosenProperties(options)) {
      if (Interrupted()) break;
      progress.Stage(fmt::format("{} {} on {}", name, property->name, of));
      const Verdict verdict = props::RunCase(subject, *property, given);
      tally.Count(verdict.outcome, 1);
      PropertyResult& result = results.emplace_back();
      result.property = property->name;
      result.outcome = verdict.outcome;
      result.exercised = verdict.exercised;
      result.message = verdict.message;
      if (verdict.outcome == Outcome::kNotApplicable) {
        not_asked.Add(verdict.message, property->name);
        continue;
      }
      text += fmt::format("{:<16} {:<10} {:<50} {}: exercised {} times{}{}{}\n",
                          OutcomeName(verdict.outcome), name, property->name, of, verdict.exercised,
                          NotJudgedText(verdict.not_judged), verdict.message.empty() ? "" : "; ",
                          report::CleanText(verdict.message));
      if (verdict.outcome != Outcome::kViolated) continue;
      choice.subject = name;
      choice.property = property->name;
      choice.profile = options.profile;
      text += FailureText(subject, std::string(property->name), given, verdict,
                          CommandFor("replay", choice), /*colour=*/false);
    }
    text += not_asked.Lines(name, of + ": ");
  }
  if (options.properties.empty() && !Interrupted()) text += ContractText(subject, results, tally);
}

// What finds out more about a subject of the user's own that does not draw as it promises.
std::string Hint(const Subject& subject, const Tally& tally, const std::string& profile) {
  if (tally.Of(Outcome::kViolated) == 0 || !IsOutside(subject.Info().name)) return "";
  CaseChoice choice;
  choice.subject = subject.Info().name;
  choice.profile = profile;
  return fmt::format("what profile it does follow: {}\n", CommandFor("infer", choice));
}

}  // namespace

int RunCheck(const CheckOptions& options) {
  RequireHonestEnvironment();
  ChosenProperties(options);  // a misspelt name is found before anything is run
  for (const std::string& name : options.named) RequireCaseName(name);
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const std::string& name : options.subjects) {
    subjects.push_back(MakeSubject(name, options.profile));
    SayOfPreset(subjects.back()->Info().profile);
  }
  int status = kExitHolds;
  for (const std::unique_ptr<Subject>& subject : subjects) {
    if (Interrupted()) break;
    std::string text;
    Tally own;
    try {
      Progress progress;
      if (options.scenes.empty() && options.named.empty()) {
        CheckGenerated(*subject, options, progress, text, own);
      } else {
        CheckGiven(*subject, options, progress, text, own);
      }
    } catch (...) {
      io::WriteStandardOutput(text);  // what was found before is so all the same
      throw;
    }
    text += own.Line(subject->Info().name) + Hint(*subject, own, options.profile);
    status = WorseStatus(status, own.ExitStatus());
    io::WriteStandardOutput(text);
  }
  if (!Interrupted()) return status;
  io::WriteStandardOutput("interrupted: this is what was found so far\n");
  return WorseStatus(status, kExitInconclusive);
}

}  // namespace rasterproof::tool
