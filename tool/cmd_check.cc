// rasterproof check: the properties, on generated cases or on given scenes.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tool/commands.h"
#include "tool/failure.h"
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
  void Count(Outcome outcome) {
    violated_ = violated_ || outcome == Outcome::kViolated;
    held_ = held_ || outcome == Outcome::kHolds;
  }
  int ExitStatus() const {
    if (violated_) return kExitViolated;
    return held_ ? kExitHolds : kExitInconclusive;
  }

 private:
  bool violated_ = false;
  bool held_ = false;
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
  for (const props::Property* property : ChosenProperties(options)) {
    progress.Stage(fmt::format("{} {}", name, property->name), options.campaign.cases);
    props::CampaignOptions campaign;
    campaign.seed = options.campaign.seed;
    campaign.cases = options.campaign.cases;
    campaign.seconds = options.campaign.seconds;
    campaign.progress = [&](std::uint64_t done) { progress.Done(done); };
    const PropertyResult result = props::RunCampaign(subject, *property, campaign);
    tally.Count(result.outcome);
    text += ResultLine(result);
    if (!result.counterexample || !result.verdict) continue;
    const std::string replay =
        fmt::format("rasterproof replay --subject {} --property {} --seed {} --case {}", name,
                    property->name, options.campaign.seed, result.failing_case);
    text += FailureText(subject, result.property, *result.counterexample, *result.verdict, replay,
                        /*colour=*/false);
    if (!options.save.empty()) SaveCounterexample(options.save, result);
  }
}

void CheckGiven(Subject& subject, const CheckOptions& options, Progress& progress,
                std::string& text, Tally& tally) {
  const std::string& name = subject.Info().name;
  for (const std::string& path : options.scenes) {
    Case given = io::ReadCase(path).value;
    given.profile = subject.Info().profile;
    RequireTakes(subject, given.scene, path);
    for (const props::Property* property : ChosenProperties(options)) {
      progress.Stage(fmt::format("{} {} on {}", name, property->name, path));
      const Verdict verdict = props::RunCase(subject, *property, given);
      tally.Count(verdict.outcome);
      text += fmt::format("{:<16} {:<10} {:<50} {}: exercised {} times{}{}\n",
                          OutcomeName(verdict.outcome), name, property->name, path,
                          verdict.exercised, verdict.message.empty() ? "" : "; ", verdict.message);
      if (verdict.outcome != Outcome::kViolated) continue;
      text += FailureText(subject, std::string(property->name), given, verdict,
                          fmt::format("rasterproof replay {} --subject {} --property {}", path,
                                      name, property->name),
                          /*colour=*/false);
    }
  }
}

}  // namespace

int RunCheck(const CheckOptions& options) {
  RequireHonestEnvironment();
  ChosenProperties(options);  // a misspelt name is found before anything is run
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const std::string& name : options.subjects) {
    subjects.push_back(MakeSubject(name, options.profile));
  }
  Tally tally;
  for (const std::unique_ptr<Subject>& subject : subjects) {
    std::string text;
    {
      Progress progress;
      if (options.scenes.empty()) {
        CheckGenerated(*subject, options, progress, text, tally);
      } else {
        CheckGiven(*subject, options, progress, text, tally);
      }
    }
    io::WriteStandardOutput(text);
  }
  return tally.ExitStatus();
}

}  // namespace rasterproof::tool
