// rasterproof check: the properties, on generated cases, given scenes or cases by their names.
#include "tool/check/cmd_check.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/authority.h"
#include "core/counters.h"
#include "core/error.h"
#include "core/quoted.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "props/domains/width_inputs.h"
#include "props/engine/known_answers.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/conclude.h"
#include "props/run/contract_evidence.h"
#include "props/run/not_asked.h"
#include "props/run/property_domains.h"
#include "report/certificate.h"
#include "report/grounds.h"
#include "tool/case_choice.h"
#include "tool/certify/evidence.h"
#include "tool/check/causes.h"
#include "tool/check/check_json.h"
#include "tool/check/findings.h"
#include "tool/check/pulled_runs.h"
#include "tool/check/resolve_check.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/known_failures.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"
#include "tool/rounds/far_program.h"
#include "tool/session.h"
#include "tool/subject_kinds.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using Properties = std::vector<const props::Property*>;

// Keeps the files saved before: the next run asks them first. Returns the new one's path.
// The file is named by the name that the subject gives itself, if it does: a build's path is
// another one elsewhere.
std::string SaveCounterexample(const std::string& folder, const std::string& stated_name,
                               const PropertyResult& result) {
  io::MakeFolder(folder);
  const std::string& name = stated_name.empty() ? result.subject : stated_name;
  const std::string stem = fmt::format("{}/{}-{}", folder, FileNameOf(name), result.property);
  std::string path = stem + ".json";
  for (int n = 2; std::filesystem::exists(path); ++n) path = fmt::format("{}-{}.json", stem, n);
  const auto& found = *result.counterexample;
  io::WriteFile(
      path, io::CaseToJson({found.value, result.subject, result.property, found.verdict.drawn}));
  return path;
}

// Ends the run with the first violation, if that is asked for. Several threads look at once.
class FailFast {
 public:
  FailFast(const CheckOptions& options, const std::vector<KnownFailure>& known,
           const std::string& subject)
      : is_on_(options.fail_fast), fail_on_(options.fail_on), known_(known), subject_(subject) {}
  bool HasFailed() const { return has_failed_; }
  void Look(const PropertyResult& result) {
    if (!is_on_) return;
    if (IsFailure(result, fail_on_) && !IsKnown(known_, Today(), subject_, result.property))
      has_failed_ = true;
  }

 private:
  bool is_on_;
  FailOn fail_on_;
  const std::vector<KnownFailure>& known_;
  const std::string& subject_;
  std::atomic<bool> has_failed_ = false;
};

using Ask = std::function<Finding(std::size_t worker, const props::Property& property)>;

// The members of the crew share the properties; what they find is added in their order. An error is
// thrown again after what was found up to there.
void AskAll(const Crew& crew, const Properties& properties, const Ask& ask, FailFast& fail_fast,
            Findings& found) {
  std::vector<std::optional<Finding>> findings(properties.size());
  const int jobs = static_cast<int>(crew.size());
  const std::vector<std::size_t> order = OrderOfWork(
      jobs, properties.size(), [&](std::size_t k) { return properties[k]->takes_long; });
  std::exception_ptr error;
  try {
    ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
      if (Interrupted() || fail_fast.HasFailed()) return;
      findings[k] = ask(worker, *properties[k]);
      fail_fast.Look(findings[k]->result);
    });
  } catch (...) {
    error = std::current_exception();
  }
  for (std::optional<Finding>& finding : findings) {
    if (finding) {
      found.all.push_back(*std::move(finding));
    } else if (error) {
      break;
    } else if (fail_fast.HasFailed()) {
      ++found.not_asked;
    }
  }
  if (error) std::rethrow_exception(error);
}

// Options for one property. Adds lines to `cases` where they are asked for.
props::CampaignOptions CampaignFor(Subject& subject, const SubjectFactory& asked,
                                   const props::Property& property, const CheckOptions& options,
                                   props::Pace& pace, std::string& cases) {
  props::CampaignOptions campaign =
      CampaignOn(subject, options.campaign, [&asked] { return asked.Make(); });
  campaign.pace = &pace;
  if (!options.cases_json.empty()) {
    campaign.judged = [&](const Case& c, const Verdict& verdict) {
      cases += CaseLine(subject.Info(), property, c, verdict);
    };
  }
  return campaign;
}

// One property on generated cases, of `world` if there is one; shows its progress.
PropertyResult Campaign(Subject& subject, const props::Property& property,
                        props::CampaignOptions campaign, const props::World* world,
                        Progress& progress, std::size_t worker) {
  const std::string stage = fmt::format("{} {}", subject.Info().name, property.name);
  progress.Stage(stage, campaign.cases, worker);
  campaign.progress = [&](std::uint64_t done) { progress.Done(done, worker); };
  campaign.shrinking = [&](std::uint64_t evaluations) {
    if (evaluations == 0) {
      progress.Stage(stage + ": shrinking what failed", campaign.shrink_budget, worker);
    }
    progress.Done(evaluations, worker);
  };
  campaign.world = world;
  if (world != nullptr) campaign.cases = world->cases;
  PropertyResult result = props::RunCampaign(subject, property, campaign);
  progress.Stage("", 0, worker);
  return result;
}

bool WasNotAsked(const PropertyResult& result) {
  return result.outcome == Outcome::kNotApplicable && !result.counterexample;
}

// The shrunk case as one word of a command, if it is short and drawn the plain way; else "".
std::string InlineCase(const Case& c) {
  constexpr std::size_t kMost = 2000;  // characters
  if (c.options != DrawOptions()) return "";
  const std::string text = InOneLine(io::SceneToJson(c.scene));
  return text.size() <= kMost ? text : "";
}

std::string Exercised(const PropertyResult& result) {
  return fmt::format("{} cases, exercised {} times in {}", result.cases, result.exercised,
                     result.cases_exercised);
}

// Completes a finding with a case that failed, for all outputs; `choice` runs the case again.
void AddFailure(Subject& subject, CaseChoice choice, const CheckOptions& options,
                Finding& finding) {
  Counterexample& found = *finding.result.counterexample;
  SeeIfItCan(subject, found.value, found.verdict);
  choice.subject = subject.Info().name;
  choice.property = finding.result.property;
  choice.profile = options.profile;
  choice.list_length = options.list_length;
  finding.replay = CommandFor("replay", choice);
}

// The result of a property on generated cases.
Finding FindingOf(Subject& subject, PropertyResult result, const CheckOptions& options) {
  Finding finding{std::move(result)};
  if (WasNotAsked(finding.result)) return finding;
  finding.line = OutcomeLine(finding.result, options.fail_on, Exercised(finding.result));
  if (!finding.result.counterexample) return finding;
  const Counterexample& found = *finding.result.counterexample;
  CaseChoice choice;
  choice.path = options.save.empty()
                    ? InlineCase(found.value)
                    : SaveCounterexample(options.save, subject.Info().stated_name, finding.result);
  if (choice.path.empty()) choice.name = found.failing_case;
  AddFailure(subject, std::move(choice), options, finding);
  return finding;
}

// A run in which no property of the contract was put to the test is no pass, whatever else holds.
void AddContract(const SubjectInfo& subject, Findings& found) {
  std::vector<PropertyResult> results;
  for (const Finding& finding : found.all) results.push_back(finding.result);
  const props::ContractEvidence evidence = props::EvidenceOfContract(subject, results);
  if (!evidence.is_exercised) {
    found.is_contract_untested = true;
    found.notes += fmt::format("{:<16} {:<10} its contract was not put to the test: {}\n",
                               OutcomeName(Outcome::kInconclusive), subject.name, evidence.why);
  } else if (!evidence.thin.empty()) {
    found.notes += fmt::format("{:<16} {:<10} {}\n", OutcomeName(Outcome::kHolds), subject.name,
                               evidence.thin);
  }
}

// Of generated cases; who gives cases knows what they have.
void AddUnasked(const Subject& subject, Findings& found) {
  std::vector<PropertyResult> results;
  for (const Finding& finding : found.all) results.push_back(finding.result);
  found.unasked = UnaskedOf(subject.Info(), props::OutputsOf(subject), results);
}

// One property on one given case.
Finding AskOfGiven(Subject& subject, const props::Property& property, const GivenCase& given,
                   const Case& c, const CheckOptions& options) {
  const Verdict verdict = props::RunCase(subject, property, c);
  Finding finding{props::NothingRun(subject.Info(), property, options.campaign.seed)};
  PropertyResult& result = finding.result;
  result.outcome = verdict.outcome;
  result.AddCase(verdict);
  result.message = verdict.message;
  finding.place = given.place;
  if (WasNotAsked(result)) return finding;
  finding.line = OutcomeLine(result, options.fail_on,
                             fmt::format("{}: exercised {} times", given.place, verdict.exercised));
  if (verdict.outcome != Outcome::kViolated) return finding;
  CaseChoice choice;
  (given.name ? choice.name : choice.path) = given.place;
  result.counterexample = {c, verdict, verdict.outcome, verdict.message};
  AddFailure(subject, std::move(choice), options, finding);
  return finding;
}

// The first of the saved failures of the property that the subject still shows.
std::optional<Finding> FailsAsSaved(Subject& subject, const props::Property& property,
                                    const ResolvedCheck& asked, const CheckOptions& options) {
  const auto [first, last] = asked.saved.equal_range(std::string(property.name));
  for (auto saved = first; saved != last; ++saved) {
    Case c = saved->second.value;
    c.profile = subject.Info().profile;
    if (!Takes(subject.Info(), c.scene)) continue;
    Finding finding = AskOfGiven(subject, property, saved->second, c, options);
    if (finding.result.outcome != Outcome::kViolated) continue;
    finding.place.clear();
    return finding;
  }
  return std::nullopt;
}

void CheckGenerated(Crew& crew, const SubjectFactory& subject, const ResolvedCheck& asked,
                    const CheckOptions& options, const PulledRuns* pulled, FailFast& fail_fast,
                    Progress& progress, Findings& found) {
  props::Pace pace;
  const Ask ask = [&](std::size_t worker, const props::Property& property) {
    Subject& own = crew.Of(worker);
    if (auto saved = FailsAsSaved(own, property, asked, options)) return *std::move(saved);
    std::string cases;
    const auto run = [&](const props::World* world) {
      if (pulled != nullptr) return pulled->Result(property, world, cases);
      return Campaign(own, property, CampaignFor(own, subject, property, options, pace, cases),
                      world, progress, worker);
    };
    PropertyResult result = run(nullptr);
    const bool has_failed = result.outcome == Outcome::kViolated;
    if (!has_failed && props::IsPutToWidthInputs(property.name, own.Info())) {
      PropertyResult of_widths = run(&props::WidthInputs());
      if (of_widths.outcome == Outcome::kViolated ||
          (of_widths.outcome == Outcome::kInconclusive && result.outcome == Outcome::kHolds))
        result = std::move(of_widths);
    }
    Finding finding = FindingOf(own, std::move(result), options);
    finding.cases = std::move(cases);
    return finding;
  };
  AskAll(crew, asked.properties, ask, fail_fast, found);
}

// A case is judged by what the subject states, which may be another model than the file's.
void NoteOtherProfile(const SubjectInfo& info, const GivenCase& given,
                      const CheckOptions& options) {
  if (!given.states_profile || !options.profile.empty()) return;
  if (SameModel(given.value.profile, info.profile)) return;
  Tell(fmt::format(
      "note: {}: judged by {}'s profile {}, not by the file's, {}; choose with --profile\n",
      given.place, info.name, Quoted(info.profile.name, 60), Quoted(given.value.profile.name, 60)));
}

void CheckGiven(Crew& crew, const SubjectFactory& subject, const ResolvedCheck& asked,
                const CheckOptions& options, FailFast& fail_fast, Progress& progress,
                Findings& found) {
  for (const GivenCase& given : asked.cases) {
    const Case c = CaseFor(crew.Of(0), given);
    NoteOtherProfile(crew.Of(0).Info(), given, options);
    const Ask ask = [&](std::size_t worker, const props::Property& property) {
      progress.Stage(fmt::format("{} {} on {}", subject.name(), property.name, given.place), 0,
                     worker);
      Finding finding = AskOfGiven(crew.Of(worker), property, given, c, options);
      progress.Stage("", 0, worker);
      return finding;
    };
    AskAll(crew, asked.properties, ask, fail_fast, found);
  }
}

// Looks for what explains the violations. No suspect is made for a subject that passes.
void LookForCauses(const SubjectFactory& subject, const CheckOptions& options, Findings& found) {
  std::vector<props::FailedProperty> failed;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < found.all.size(); ++k) {
    if (!IsFailure(found.all[k].result, options.fail_on)) continue;
    auto one = props::FailedBy(found.all[k].result, found.info);
    if (!one) continue;
    failed.push_back(*std::move(one));
    places.push_back(k);
  }
  if (options.no_cause || failed.empty() || Interrupted()) return;
  found.causes = props::FindCauses([&] { return subject.Make(); }, failed, options.cause_seconds);
  for (std::size_t cause = 0; cause < found.causes.all.size(); ++cause) {
    for (std::size_t& place : found.causes.all[cause].properties) {
      place = places[place];
      found.all[place].cause = cause;
    }
  }
}

// What finds out more about a subject of the user's own that does not draw as it states.
std::string Hint(const std::string& subject, const Findings& found, const std::string& profile) {
  if (!IsOutside(subject) || StatusOf(found) != kExitViolated) return "";
  CaseChoice choice;
  choice.subject = subject;
  choice.profile = profile;
  return fmt::format("to find the profile that it follows: {}\n", CommandFor("infer", choice));
}

// An entry may name the subject as it does itself, which is the same wherever its files lie.
std::vector<KnownFailure> KnownOf(std::vector<KnownFailure> known, const Findings& found) {
  for (KnownFailure& entry : known) {
    if (!entry.subject.empty() && entry.subject == found.info.stated_name)
      entry.subject = found.subject;
  }
  return known;
}

// Runs what is asked of one subject. What was found up to an error is printed all the same. If
// `pulled` is given, it has the results of generated cases.
Findings Check(const SubjectFactory& subject, const ResolvedCheck& asked,
               const CheckOptions& options, const PulledRuns* pulled = nullptr) {
  Crew crew(options.jobs, [&](std::size_t) { return subject.Make(); });
  NotePreset(crew.Of(0).Info().profile);
  Findings found{subject.name(), options.fail_on, crew.Of(0).Info()};
  const std::vector<KnownFailure> known = KnownOf(asked.known, found);
  FailFast fail_fast(options, known, subject.name());
  try {
    Progress progress(crew.size());
    if (asked.cases.empty()) {
      CheckGenerated(crew, subject, asked, options, pulled, fail_fast, progress, found);
    } else {
      CheckGiven(crew, subject, asked, options, fail_fast, progress, found);
    }
    if (asked.is_whole_catalogue && !Interrupted() && found.not_asked == 0) {
      AddContract(crew.Of(0).Info(), found);
      if (asked.cases.empty()) AddUnasked(crew.Of(0), found);
    }
  } catch (...) {
    io::WriteStandardOutput(FindingsText(found, options.verbose));
    throw;
  }
  return found;
}

void RequireFiles(const CheckOptions& options) {
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  io::RequireFileCanBe(options.cases_json);
  io::RequireFileCanBe(options.json);
}

void Tell(const ResolvedCheck& asked, const CheckOptions& options, Findings& found) {
  ApplyKnownFailures(KnownOf(asked.known, found), Today(), found);
  if (options.json == "-") return;
  io::WriteStandardOutput(FindingsText(found, options.verbose) + CausesText(found) +
                          report::AssumptionLines(found.info.profile) + LastLine(found) +
                          Hint(found.subject, found, options.profile));
}

// Writes the files. Returns the exit status.
int WriteAll(const CheckOptions& options, const std::vector<Findings>& all) {
  int status = kExitHolds;
  std::string cases;
  for (const Findings& found : all) {
    status = WorseStatus(status, StatusOf(found));
    for (const Finding& finding : found.all) cases += finding.cases;
  }
  if (!options.cases_json.empty()) io::WriteFile(options.cases_json, cases);
  if (Interrupted()) status = WorseStatus(status, kExitInconclusive);
  if (!options.json.empty()) io::WriteOutput(options.json, CheckJson(all, status));
  if (!Interrupted()) return status;
  if (options.json != "-") io::WriteStandardOutput("interrupted; results so far:\n");
  return WorseStatus(status, kExitInconclusive);
}

// check of a program that is not at hand. Causes are found by draws that nobody foresees.
int CheckInRounds(CheckOptions options) {
  if (options.subjects.size() != 1 || !options.scenes.empty() || !options.named.empty()) {
    throw InputError(options.subjects.front(), "rounds are about one subject on generated cases",
                     "check the others, and given cases, where they run");
  }
  constexpr props::RoundSize kOfChecking{.requests = 20000};
  FarProgram program(options.subjects.front(), options.profile, kOfChecking, options.device,
                     options.list_length);
  const SubjectFactory subject(std::exchange(options.subjects, {}).front(), program.Maker());
  options.jobs = 1;
  options.no_cause = true;
  const ResolvedCheck asked = ResolveCheck(options);
  RequireFiles(options);
  const PulledRuns runs(program, asked.properties, options);
  std::optional<Findings> found;
  const auto ask = [&] {  // saved failures and pictures; saves nothing yet
    CheckOptions unsaved = options;
    unsaved.save.clear();
    found = Check(subject, asked, unsaved, &runs);
  };
  const auto tell = [&] {
    if (!options.save.empty()) found = Check(subject, asked, options, &runs);
    Tell(asked, options, *found);
    return WriteAll(options, {*found});
  };
  return program.Run(ask, tell);
}

}  // namespace

int RunCheck(const CheckOptions& options) {
  RequireHonestEnvironment();
  const auto is_far = [](const std::string& name) { return name.starts_with(kRoundsPrefix); };
  if (std::ranges::any_of(options.subjects, is_far)) return CheckInRounds(options);
  const ResolvedCheck asked = ResolveCheck(options);
  RequireFiles(options);
  std::vector<Findings> all;
  for (const SubjectFactory& subject : asked.subjects) {
    if (Interrupted()) break;
    Findings found = Check(subject, asked, options);
    LookForCauses(subject, options, found);
    Tell(asked, options, found);
    all.push_back(std::move(found));
  }
  return WriteAll(options, all);
}

}  // namespace rasterproof::tool
