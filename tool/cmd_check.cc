// rasterproof check: the properties, on generated cases, given scenes or cases by their names.
#include <algorithm>
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
#include "core/result.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/conclude.h"
#include "props/run/contract_evidence.h"
#include "props/run/near_edge.h"
#include "props/run/property_domains.h"
#include "report/certificate.h"
#include "report/grounds.h"
#include "report/json_writer.h"
#include "report/text.h"
#include "tool/catalogue.h"
#include "tool/causes.h"
#include "tool/commands.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/float_modes.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/session.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using Properties = std::vector<const props::Property*>;

// The results of one subject, and what is printed of them.
struct Report {
  FailOn fail_on = FailOn::kStated;
  Profile profile;
  std::string text = {};
  std::vector<PropertyResult> results = {};
  std::string cases = {};  // for --cases-json
  bool is_contract_untested = false;
  std::vector<props::FailedProperty> failed = {};  // for their causes
};

// Violations that fail nothing are none.
std::uint64_t CountOf(const Report& found, Outcome outcome) {
  const auto count = std::ranges::count_if(found.results, [&](const PropertyResult& result) {
    return result.outcome == outcome && !IsLackOfQuality(result, found.fail_on);
  });
  const bool one_more = outcome == Outcome::kInconclusive && found.is_contract_untested;
  return static_cast<std::uint64_t>(count) + (one_more ? 1 : 0);
}

std::uint64_t QualityOf(const Report& found) {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      found.results,
      [&](const PropertyResult& result) { return IsLackOfQuality(result, found.fail_on); }));
}

// Of properties on given scenes. A campaign has counted the refusals of its cases itself.
bool RefusesTooMuch(const Report& found) {
  const auto refused = static_cast<double>(CountOf(found, Outcome::kRefused));
  const auto holds = static_cast<double>(CountOf(found, Outcome::kHolds));
  return refused > props::kMostRefusedShare * (refused + holds);
}

// One violation outweighs all, then a property that could not be judged; nothing exercised is no
// pass.
int StatusOf(const Report& found) {
  if (CountOf(found, Outcome::kViolated) != 0) return kExitViolated;
  if (CountOf(found, Outcome::kInconclusive) != 0 || RefusesTooMuch(found))
    return kExitInconclusive;
  return CountOf(found, Outcome::kHolds) + QualityOf(found) != 0 ? kExitHolds : kExitInconclusive;
}

std::string LastLine(const Report& found, const std::string& subject) {
  const auto of = [&found](Outcome outcome) { return CountOf(found, outcome); };
  std::string line = fmt::format("{}: {} hold, {} violated, {} not exercised, {} not applicable",
                                 subject, of(Outcome::kHolds), of(Outcome::kViolated),
                                 of(Outcome::kNotExercised), of(Outcome::kNotApplicable));
  for (const Outcome outcome : {Outcome::kRefused, Outcome::kInconclusive}) {
    if (of(outcome) != 0) line += fmt::format(", {} {}", of(outcome), OutcomeName(outcome));
  }
  if (const auto quality = QualityOf(found)) line += fmt::format(", {} short of quality", quality);
  std::uint64_t cases = 0;
  for (const PropertyResult& result : found.results) cases += result.cases;
  return line + fmt::format("; {} cases\n", cases);
}

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

// The outcome, or that it is a violation which fails nothing.
std::string_view OutcomeWord(const PropertyResult& result, FailOn fail_on) {
  return IsLackOfQuality(result, fail_on) ? AuthorityName(Authority::kQuality)
                                          : OutcomeName(result.outcome);
}

std::string NotJudgedText(std::uint64_t samples) {
  return samples == 0
             ? ""
             : fmt::format(", {} samples not judged: a legal choice could turn the triangle",
                           samples);
}

std::string ResultLine(const PropertyResult& result, FailOn fail_on) {
  std::string line = fmt::format("{:<16} {:<10} {:<50} {} cases, exercised {} times in {}",
                                 OutcomeWord(result, fail_on), result.subject, result.property,
                                 result.cases, result.exercised, result.cases_exercised);
  if (result.cases_refused != 0) line += fmt::format(", {} refused", result.cases_refused);
  line += NotJudgedText(result.not_judged);
  if (result.worst_ratio != 0) line += fmt::format(", error/bound {:.3f}", result.worst_ratio);
  if (!result.message.empty()) line += "; " + report::CleanText(result.message);
  return line + "; " + report::AuthorityText(result) + "\n";
}

// Keeps the files saved before: the next run asks them first.
void SaveCounterexample(const std::string& folder, const PropertyResult& result) {
  io::MakeFolder(folder);
  const std::string stem =
      fmt::format("{}/{}-{}", folder, FileNameOf(result.subject), result.property);
  std::string path = stem + ".json";
  for (int n = 2; std::filesystem::exists(path); ++n) path = fmt::format("{}-{}.json", stem, n);
  const auto& found = *result.counterexample;
  io::WriteFile(
      path, io::CaseToJson({found.value, result.subject, result.property, found.verdict.drawn}));
}

// The result of one property, and its printed text. Neither of one that was not begun.
struct Share {
  std::optional<PropertyResult> result;
  std::string text;
  std::string cases = {};  // for --cases-json
  bool is_whole = false;
  std::optional<props::FailedProperty> failed = {};
};

using Ask = std::function<void(std::size_t worker, const props::Property& property, Share& share)>;

// The members of the crew share the properties. If one of them throws, `error` is that, and the
// shares end with what it found up to there.
std::vector<Share> ShareOut(const Crew& crew, const Properties& properties, const Ask& ask,
                            std::exception_ptr& error) {
  std::vector<Share> shares(properties.size());
  const int jobs = static_cast<int>(crew.size());
  const std::vector<std::size_t> order = OrderOfWork(
      jobs, properties.size(), [&](std::size_t k) { return properties[k]->takes_long; });
  try {
    ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
      if (!Interrupted()) ask(worker, *properties[k], shares[k]);
      shares[k].is_whole = true;
    });
  } catch (...) {  // thrown again once the results so far are printed
    error = std::current_exception();
    const auto failed = std::ranges::find(shares, false, &Share::is_whole);
    shares.erase(std::next(failed), shares.end());
  }
  return shares;
}

// A case and its outcome, as a line of JSON.
std::string CaseLine(const SubjectInfo& subject, const props::Property& property, const Case& c,
                     const Verdict& verdict) {
  report::JsonWriter json;
  json.BeginObjectLine();
  json.Key("subject").Text(subject.name).Key("property").Text(property.name);
  json.Key("case").Text(c.origin).Key("triangles").Integer(c.scene.triangles.size());
  json.Key("width").Integer(c.scene.width).Key("height").Integer(c.scene.height);
  json.Key("near_edges").BeginObject();
  json.Members(kNearEdgeCounters, props::CountNearEdges(c)).EndObject();
  json.Key("exercised").Integer(verdict.exercised);
  json.Key("outcome").Text(OutcomeName(verdict.outcome));
  return json.EndObject().Finish();
}

// One property on generated cases; shows its progress.
PropertyResult Campaign(Subject& subject, const SubjectFactory& asked,
                        const props::Property& property, const CheckOptions& options,
                        Progress& progress, std::size_t worker, props::Pace& pace,
                        std::string& cases) {
  const std::string stage = fmt::format("{} {}", subject.Info().name, property.name);
  progress.Stage(stage, options.campaign.cases, worker);
  props::CampaignOptions campaign =
      CampaignOn(subject, options.campaign, [&] { return asked.Make(); });
  campaign.progress = [&](std::uint64_t done) { progress.Done(done, worker); };
  campaign.shrinking = [&](std::uint64_t evaluations) {
    if (evaluations == 0) {
      progress.Stage(stage + ": shrinking what failed", campaign.shrink_budget, worker);
    }
    progress.Done(evaluations, worker);
  };
  campaign.pace = &pace;
  if (!options.cases_json.empty()) {
    campaign.judged = [&](const Case& c, const Verdict& verdict) {
      cases += CaseLine(subject.Info(), property, c, verdict);
    };
  }
  PropertyResult result = props::RunCampaign(subject, property, campaign);
  progress.Stage("", 0, worker);
  return result;
}

bool WasNotAsked(const PropertyResult& result) {
  return result.outcome == Outcome::kNotApplicable && !result.counterexample;
}

// Prints the result of a property on generated cases.
void TellOf(Subject& subject, const CheckOptions& options, Share& share) {
  const PropertyResult& result = *share.result;
  if (WasNotAsked(result)) return;
  share.text = ResultLine(result, options.fail_on);
  if (!result.counterexample) return;
  if (IsFailure(result, options.fail_on)) share.failed = FailedBy(result, subject.Info());
  const auto& found = *result.counterexample;
  CaseChoice choice;
  choice.subject = result.subject;
  choice.property = result.property;
  choice.profile = options.profile;
  choice.list_length = options.list_length;
  choice.name = found.failing_case;
  share.text += FailureText(subject, result.property, found.value, found.verdict,
                            CommandFor("replay", choice), /*colour=*/false);
  if (!options.save.empty()) SaveCounterexample(options.save, result);
}

// A run in which no property of the contract was put to the test is no pass, whatever else holds.
void AddContract(const SubjectInfo& subject, Report& found) {
  const props::ContractEvidence evidence = props::EvidenceOfContract(subject, found.results);
  if (!evidence.is_exercised) {
    found.is_contract_untested = true;
    found.text += fmt::format("{:<16} {:<10} its contract was not put to the test: {}\n",
                              OutcomeName(Outcome::kInconclusive), subject.name, evidence.why);
  } else if (!evidence.thin.empty()) {
    found.text += fmt::format("{:<16} {:<10} {}\n", OutcomeName(Outcome::kHolds), subject.name,
                              evidence.thin);
  }
}

// Adds the shares, in their order.
void Add(const std::vector<Share>& shares, const std::string& subject, const std::string& of,
         Report& found) {
  NotAsked not_asked;
  for (const Share& share : shares) {
    if (!share.result) continue;  // an interrupt kept it from being begun
    const PropertyResult& result = found.results.emplace_back(*share.result);
    found.text += share.text;
    found.cases += share.cases;
    if (share.failed) found.failed.push_back(*share.failed);
    if (WasNotAsked(result)) not_asked.Add(result.message, result.property);
  }
  found.text += not_asked.Lines(subject, of);
}

// One property on one given case.
void AskOfGiven(Subject& subject, const props::Property& property, const GivenCase& given,
                const Case& c, const CheckOptions& options, Share& share) {
  const std::string& name = subject.Info().name;
  const Verdict verdict = props::RunCase(subject, property, c);
  PropertyResult& result =
      share.result.emplace(props::NothingRun(subject.Info(), property, options.campaign.seed));
  result.outcome = verdict.outcome;
  result.AddCase(verdict);
  result.message = verdict.message;
  if (WasNotAsked(result)) return;
  share.text = fmt::format("{:<16} {:<10} {:<50} {}: exercised {} times{}{}{}; {}\n",
                           OutcomeWord(result, options.fail_on), name, property.name, given.place,
                           verdict.exercised, NotJudgedText(verdict.not_judged),
                           verdict.message.empty() ? "" : "; ", report::CleanText(verdict.message),
                           report::AuthorityText(result));
  if (verdict.outcome != Outcome::kViolated) return;
  if (IsWrong(verdict) && IsFailure(result, options.fail_on)) share.failed = {&property, {c}};
  CaseChoice choice;
  (given.name ? choice.name : choice.path) = given.place;
  choice.subject = name;
  choice.property = property.name;
  choice.profile = options.profile;
  choice.list_length = options.list_length;
  share.text += FailureText(subject, result.property, c, verdict, CommandFor("replay", choice),
                            /*colour=*/false);
}

// The first of the saved failures of the property that the subject still shows.
bool FailsAsSaved(Subject& subject, const props::Property& property, const ResolvedCheck& asked,
                  const CheckOptions& options, Share& share) {
  const auto [first, last] = asked.saved.equal_range(std::string(property.name));
  for (auto saved = first; saved != last; ++saved) {
    Case c = saved->second.value;
    c.profile = subject.Info().profile;
    if (!Takes(subject.Info(), c.scene)) continue;
    AskOfGiven(subject, property, saved->second, c, options, share);
    if (share.result->outcome == Outcome::kViolated) return true;
  }
  share = {};
  return false;
}

void CheckGenerated(Crew& crew, const SubjectFactory& subject, const ResolvedCheck& asked,
                    const CheckOptions& options, Progress& progress, Report& found) {
  props::Pace pace;
  std::exception_ptr error;
  const std::vector<Share> shares = ShareOut(
      crew, asked.properties,
      [&](std::size_t worker, const props::Property& property, Share& share) {
        Subject& own = crew.Of(worker);
        if (FailsAsSaved(own, property, asked, options, share)) return;
        share.result =
            Campaign(own, subject, property, options, progress, worker, pace, share.cases);
        TellOf(own, options, share);
      },
      error);
  Add(shares, subject.name(), "", found);
  if (error) std::rethrow_exception(error);
}

void CheckGiven(Crew& crew, const SubjectFactory& subject, const ResolvedCheck& asked,
                const CheckOptions& options, Progress& progress, Report& found) {
  for (const GivenCase& given : asked.cases) {
    const Case c = CaseFor(crew.Of(0), given);
    std::exception_ptr error;
    const std::vector<Share> shares = ShareOut(
        crew, asked.properties,
        [&](std::size_t worker, const props::Property& property, Share& share) {
          progress.Stage(fmt::format("{} {} on {}", subject.name(), property.name, given.place), 0,
                         worker);
          AskOfGiven(crew.Of(worker), property, given, c, options, share);
          progress.Stage("", 0, worker);
        },
        error);
    Add(shares, subject.name(), given.place + ": ", found);
    if (error) std::rethrow_exception(error);
  }
}

// What explains the violations. No suspect is made for a subject that passes.
std::string Causes(const SubjectFactory& subject, const Report& found,
                   const CheckOptions& options) {
  if (options.no_cause || found.failed.empty() || Interrupted()) return "";
  return CausesText(props::Explain([&] { return subject.Make(); }, found.failed), found.failed);
}

// What finds out more about a subject of the user's own that does not draw as it states.
std::string Hint(const std::string& subject, const Report& found, const std::string& profile) {
  if (CountOf(found, Outcome::kViolated) == 0 || !IsOutside(subject)) return "";
  CaseChoice choice;
  choice.subject = subject;
  choice.profile = profile;
  return fmt::format("what profile it does follow: {}\n", CommandFor("infer", choice));
}

// Runs what is asked of one subject. What was found up to an error is printed all the same.
Report Check(const SubjectFactory& subject, const ResolvedCheck& asked,
             const CheckOptions& options) {
  Crew crew(options.jobs, [&](std::size_t) { return subject.Make(); });
  NotePreset(crew.Of(0).Info().profile);
  Report found{options.fail_on, crew.Of(0).Info().profile};
  try {
    Progress progress(crew.size());
    if (asked.cases.empty()) {
      CheckGenerated(crew, subject, asked, options, progress, found);
    } else {
      CheckGiven(crew, subject, asked, options, progress, found);
    }
    if (asked.is_whole_catalogue && !Interrupted()) AddContract(crew.Of(0).Info(), found);
  } catch (...) {
    io::WriteStandardOutput(found.text);
    throw;
  }
  return found;
}

}  // namespace

int RunCheck(const CheckOptions& options) {
  RequireHonestEnvironment();
  if (options.catalogue) return CheckCatalogue(options);
  if (!options.float_modes.empty()) return CheckFloatModes(options);
  const ResolvedCheck asked = ResolveCheck(options);
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  io::RequireFileCanBe(options.cases_json);
  int status = kExitHolds;
  std::string cases;
  for (const SubjectFactory& subject : asked.subjects) {
    if (Interrupted()) break;
    const Report found = Check(subject, asked, options);
    cases += found.cases;
    io::WriteStandardOutput(
        found.text + Causes(subject, found, options) + report::AssumptionLines(found.profile) +
        LastLine(found, subject.name()) + Hint(subject.name(), found, options.profile));
    status = WorseStatus(status, StatusOf(found));
  }
  if (!options.cases_json.empty()) io::WriteFile(options.cases_json, cases);
  if (!Interrupted()) return status;
  io::WriteStandardOutput("interrupted: this is what was found so far\n");
  return WorseStatus(status, kExitInconclusive);
}

}  // namespace rasterproof::tool
