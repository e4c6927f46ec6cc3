// rasterproof survey: which model comes nearest to a subject, and what each domain shows beside it.
#include "tool/survey/cmd_survey.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/subject_info.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "props/compare/survey.h"
#include "props/infer/infer.h"
#include "props/infer/stated_keys.h"
#include "report/text.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/infer/cmd_infer.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using props::DomainSurvey;
using props::Fault;
using props::FaultyCase;

// What the drawings are compared with, and how near it comes.
struct SurveyModel {
  Profile profile;
  std::uint64_t wrong = 0;  ///< samples of the experiments that led to it
  std::uint64_t samples = 0;
  std::uint64_t experiments = 0;
  std::string remark = {};  ///< empty if the model explains every experiment
};

SurveyModel NearestTo(Subject& subject, std::uint64_t seed) {
  props::InferOptions options;
  options.seed = seed;
  const props::Inference inference = props::Infer(subject, options);
  SurveyModel model{.profile = subject.Info().profile, .experiments = inference.experiments};
  if (inference.Fits()) {
    model.profile = inference.remaining.front();
  } else if (const auto& nearest = inference.nearest) {
    model = {nearest->profile, nearest->wrong_samples, nearest->samples, nearest->experiments,
             fmt::format("no model fits; the nearest is wrong about {} of {} samples in {} draws",
                         nearest->wrong_samples, nearest->samples, nearest->experiments)};
  } else {
    model.remark = "this model is the stated one, for none was found: " + inference.message;
  }
  // One model, held to every sample.
  Profile& profile = model.profile;
  profile.contract = Contract::kSampleExact;
  profile.freedom = {};
  profile.shares_edge_samples = false;
  profile.name = "nearest to " + subject.Info().name;
  return model;
}

std::string ReplayedAs(Fault fault) {
  return fault == Fault::kBatch ? "OneCallDrawsLikeItsTriangles" : "";
}

std::string CaseJson(const FaultyCase& finding, const std::string& subject) {
  return io::CaseToJson({finding.minimal, subject, ReplayedAs(finding.fault)});
}

std::string_view NameOf(Fault fault) { return props::kFaultNames[static_cast<std::size_t>(fault)]; }

void AddDomain(io::JsonWriter& json, const DomainSurvey& survey, bool near_limits,
               const std::string& subject) {
  json.BeginObject().Key("domain").Text(survey.domain);
  json.Key("near_limits").Bool(near_limits);
  json.Key("cases").Integer(survey.cases);
  json.Key("refused").Integer(survey.refused);
  json.Key("unjudged").Integer(survey.unjudged);
  json.Key("meshes").Integer(survey.meshes);
  json.Key("triangles").Integer(survey.triangles);
  json.Key("samples").Integer(survey.samples);
  json.Key("wrong").Integer(survey.wrong);
  json.Key("gaps").Integer(survey.gaps);
  json.Key("overlaps").Integer(survey.overlaps);
  json.Key("subject_seconds").Rounded(survey.subject_seconds);
  json.Key("alone_seconds").Rounded(survey.alone_seconds);
  json.Key("seconds").Rounded(survey.seconds);
  json.Key("faulty_cases").BeginObject();
  for (std::size_t k = 0; k < survey.faulty.size(); ++k) {
    json.Key(props::kFaultNames[k]).Integer(survey.faulty[k]);
  }
  json.EndObject().Key("findings").BeginArray();
  for (const FaultyCase& finding : survey.findings) {
    json.BeginObject().Key("fault").Text(NameOf(finding.fault));
    json.Key("name").Text(finding.name);
    json.Key("end").Text(finding.end);
    json.Key("case").Value(CaseJson(finding, subject)).EndObject();
  }
  json.EndArray().EndObject();
}

std::string SurveyJson(const SubjectInfo& info, const SurveyModel& model, std::uint64_t seed,
                       const std::vector<DomainSurvey>& surveys) {
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_survey").Integer(4);
  json.Key("subject").Text(info.name);
  json.Key("summary").Text(info.summary);
  json.Key("seed").Integer(seed);
  json.Key("stated").Value(io::ProfileToJson(info.profile));
  json.Key("model").BeginObject();
  json.Key("profile").Value(io::ProfileToJson(model.profile));
  json.Key("text").Text(props::ModelText(model.profile));
  json.Key("wrong").Integer(model.wrong);
  json.Key("samples").Integer(model.samples);
  json.Key("experiments").Integer(model.experiments);
  json.Key("remark").Text(model.remark).EndObject();
  json.Key("domains").BeginArray();
  for (std::size_t k = 0; k < surveys.size(); ++k) {
    AddDomain(json, surveys[k], props::SurveyedDomains()[k].near_limits, info.name);
  }
  json.EndArray().EndObject();
  return json.Finish();
}

std::string Row(const DomainSurvey& survey) {
  const double rate = static_cast<double>(survey.triangles) / survey.subject_seconds;
  return fmt::format(
      "{:<21} {:>6} {:>7} {:>8} {:>9} {:>9} {:>8} {:>6} {:>8} {:>6} {:>6} {:>11.0f}\n",
      survey.domain, survey.cases, survey.refused, survey.unjudged, survey.triangles,
      survey.samples, survey.wrong, survey.gaps, survey.overlaps, survey.Faulty(Fault::kBatch),
      survey.Faulty(Fault::kEnd), survey.cases == 0 ? 0.0 : rate);
}

std::string FindingLine(const FaultyCase& finding) {
  const Scene& scene = finding.minimal.scene;
  return fmt::format("{:<8} {}, shrunk to {} triangles in {}x{}{}{}\n", NameOf(finding.fault),
                     finding.name, scene.triangles.size(), scene.width, scene.height,
                     finding.end.empty() ? "" : ": ", finding.end);
}

std::string ToText(const SubjectInfo& info, const SurveyModel& model,
                   const std::vector<DomainSurvey>& surveys) {
  std::string text =
      fmt::format("{}: compared with {}\n{}\n\n", info.name, props::ModelText(model.profile),
                  model.remark.empty()
                      ? fmt::format("this model explains all {} draws of infer", model.experiments)
                      : model.remark);
  text += fmt::format("{:<21} {:>6} {:>7} {:>8} {:>9} {:>9} {:>8} {:>6} {:>8} {:>6} {:>6} {:>11}\n",
                      "domain", "cases", "refused", "unjudged", "triangles", "samples", "wrong",
                      "gaps", "overlaps", "batch", "ended", "triangles/s");
  std::string findings;
  for (const DomainSurvey& survey : surveys) {
    text += Row(survey);
    for (const FaultyCase& finding : survey.findings) findings += FindingLine(finding);
  }
  return text + (findings.empty() ? "" : "\nfirst case of each kind:\n" + findings);
}

void SaveFindings(const std::string& folder, const std::string& subject,
                  const std::vector<DomainSurvey>& surveys) {
  io::MakeFolder(folder);
  for (const DomainSurvey& survey : surveys) {
    for (const FaultyCase& finding : survey.findings) {
      io::WriteFile(fmt::format("{}/{}-{}-{}.json", folder, FileNameOf(subject), survey.domain,
                                NameOf(finding.fault)),
                    CaseJson(finding, subject));
    }
  }
}

std::vector<DomainSurvey> SurveyAll(Crew& crew, const SurveyOptions& options,
                                    const Profile& model) {
  const std::span<const props::SurveyedDomain> domains = props::SurveyedDomains();
  std::vector<DomainSurvey> surveys(domains.size());
  Progress progress(crew.size());
  const auto order = OrderOfWork(1, domains.size(), [](std::size_t) { return false; });
  ShareWork(options.jobs, order, [&](std::size_t worker, std::size_t k) {
    progress.Stage(std::string(domains[k].name), options.campaign.cases, worker);
    props::SurveyPlan plan;
    plan.model = model;
    plan.seed = options.campaign.seed;
    plan.cases = options.campaign.cases;
    plan.limits = {options.campaign.seconds, Interrupted,
                   [&](std::uint64_t done) { progress.Done(done, worker); }};
    surveys[k] = props::SurveyDomain(crew.Of(worker), domains[k].name, plan);
    progress.Stage("", 0, worker);
  });
  return surveys;
}

}  // namespace

int RunSurvey(const SurveyOptions& options) {
  RequireHonestEnvironment();
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  std::unique_ptr<Subject> first = MakeSubject(options.subject, options.profile);
  RequireSamples(first->Info());
  const SubjectInfo info = first->Info();
  const SurveyModel model = NearestTo(*first, options.campaign.seed);
  if (Interrupted()) return InterruptStatus();
  Crew crew(options.jobs,
            [&](std::size_t) { return MakeSubject(options.subject, options.profile); });
  crew.Give(std::move(first));
  const std::vector<DomainSurvey> surveys = SurveyAll(crew, options, model.profile);
  if (!options.json.empty()) {
    io::WriteOutput(options.json, SurveyJson(info, model, options.campaign.seed, surveys));
  }
  if (!options.save.empty()) SaveFindings(options.save, info.name, surveys);
  if (options.json != "-") {
    io::WriteStandardOutput(report::CleanText(ToText(info, model, surveys)));
  }
  for (const DomainSurvey& survey : surveys) {
    if (survey.Faulty(Fault::kEnd) != 0) return kExitViolated;
  }
  return kExitHolds;
}

}  // namespace rasterproof::tool
