// rasterproof check: the properties, on generated cases or on given scenes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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
#include "tool/commands.h"
#include "tool/failure.h"
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

// What a whole run comes to: one violation outweighs all; nothing exercised is no pass.
class Tally {
 public:
  void Count(Outcome outcome, std::uint64_t cases) {
    ++counts_[static_cast<std::size_t>(outcome)];
    cases_ += cases;
  }
  void Add(const Tally& more) {
    for (std::size_t k = 0; k < counts_.size(); ++k) counts_[k] += more.counts_[k];
    cases_ += more.cases_;
  }
  std::uint64_t Of(Outcome outcome) const { return counts_[static_cast<std::size_t>(outcome)]; }
  int ExitStatus() const {
    if (Of(Outcome::kViolated) != 0) return kExitViolated;
    return Of(Outcome::kHolds) != 0 ? kExitHolds : kExitInconclusive;
  }
  std::string Line(const std::string& subject) const {
    return fmt::format("{}: {} hold, {} violated, {} not exercised, {} not applicable; {} cases\n",
                       subject, Of(Outcome::kHolds), Of(Outcome::kViolated),
                       Of(Outcome::kNotExercised), Of(Outcome::kNotApplicable), cases_);
  }

 private:
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

std::string ResultLine(const PropertyResult& result) {
  std::string line = fmt::format("{:<16} {:<10} {:<50} {} cases, exercised {} times in {}",
                                 OutcomeName(result.outcome), result.subject, result.property,
                                 result.cases, result.exercised, result.cases_exercised);
  if (result.worst_ratio != 0) line += fmt::format(", error/bound {:.3f}", result.worst_ratio);
  if (!result.message.empty()) line += "; " + result.message;
  return line + "\n";
}

void SaveCounterexample(const std::string& folder, const PropertyResult& result) {
  io::MakeFolder(folder);
  std::string subject = result.subject;
  for (char& c : subject) {
    if (c == ':' || c == '/') c = '+';
  }
  io::WriteFile(fmt::format("{}/{}-{}.json", folder, subject, result.property),
                io::CaseToJson({*result.counterexample, result.subject, result.property}));
}

void CheckGenerated(Subject& subject, const CheckOptions& options, Progress& progress,
                    std::string& text, Tally& tally) {
  const std::string& name = subject.Info().name;
  NotAsked not_asked;
  for (const props::Property* property : ChosenProperties(options)) {
    progress.Stage(fmt::format("{} {}", name, property->name), options.campaign.cases);
    props::CampaignOptions campaign;
    campaign.seed = options.campaign.seed;
    campaign.cases = options.campaign.cases;
    campaign.seconds = options.campaign.seconds;
    campaign.progress = [&](std::uint64_t done) { progress.Done(done); };
    const PropertyResult result = props::RunCampaign(subject, *property, campaign);
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
    choice.seed = options.campaign.seed;
    choice.index = static_cast<std::int64_t>(result.failing_case);
    text += FailureText(subject, result.property, *result.counterexample, *result.verdict,
                        CommandFor("replay", choice), /*colour=*/false);
    if (!options.save.empty()) SaveCounterexample(options.save, result);
  }
  text += not_asked.Lines(name, "");
}

void CheckGiven(Subject& subject, const CheckOptions& options, Progress& progress,
                std::string& text, Tally& tally) {
  const std::string& name = subject.Info().name;
  for (const std::string& path : options.scenes) {
    NotAsked not_asked;
    Case given = io::ReadCase(path).value;
    given.profile = subject.Info().profile;
    RequireTakes(subject, given.scene, path);
    for (const props::Property* property : ChosenProperties(options)) {
      progress.Stage(fmt::format("{} {} on {}", name, property->name, path));
      const Verdict verdict = props::RunCase(subject, *property, given);
      tally.Count(verdict.outcome, 1);
      if (verdict.outcome == Outcome::kNotApplicable) {
        not_asked.Add(verdict.message, property->name);
        continue;
      }
      text += fmt::format("{:<16} {:<10} {:<50} {}: exercised {} times{}{}\n",
                          OutcomeName(verdict.outcome), name, property->name, path,
                          verdict.exercised, verdict.message.empty() ? "" : "; ", verdict.message);
      if (verdict.outcome != Outcome::kViolated) continue;
      CaseChoice choice;
      choice.path = path;
      choice.subject = name;
      choice.property = property->name;
      choice.profile = options.profile;
      text += FailureText(subject, std::string(property->name), given, verdict,
                          CommandFor("replay", choice), /*colour=*/false);
    }
    text += not_asked.Lines(name, path + ": ");
  }
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
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const std::string& name : options.subjects) {
    subjects.push_back(MakeSubject(name, options.profile));
    SayOfPreset(subjects.back()->Info().profile);
  }
  Tally tally;
  for (const std::unique_ptr<Subject>& subject : subjects) {
    std::string text;
    Tally own;
    {
      Progress progress;
      if (options.scenes.empty()) {
        CheckGenerated(*subject, options, progress, text, own);
      } else {
        CheckGiven(*subject, options, progress, text, own);
      }
    }
    text += own.Line(subject->Info().name) + Hint(*subject, own, options.profile);
    tally.Add(own);
    io::WriteStandardOutput(text);
  }
  return tally.ExitStatus();
}

}  // namespace rasterproof::tool
