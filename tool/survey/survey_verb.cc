// rasterproof survey: which model comes nearest to a subject, and what each domain shows beside it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/comparison.h"
#include "core/subject_info.h"
#include "fmt/format.h"
#include "io/output.h"
#include "props/compare/survey.h"
#include "props/infer/infer.h"
#include "props/infer/stated_keys.h"
#include "props/run/campaign_options.h"
#include "report/comparison.h"
#include "tool/compare/comparison.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

struct SurveyOptions {
  std::string subject = "spans-exact";
  std::string profile;  ///< used instead of the subject's own
  props::CampaignOptions campaign{.cases = 2000};
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the worst case of each cell that fails
  int jobs = 1;      ///< domains at once
};

// What the drawings are compared with, and how near it comes to the experiments that led to it.
struct SurveyModel {
  Profile profile;
  std::string fit;
};

SurveyModel NearestTo(Subject& subject, std::uint64_t seed) {
  props::InferOptions options;
  options.seed = seed;
  const props::Inference inference = props::Infer(subject, options);
  SurveyModel model;
  if (inference.Fits()) {
    model = {inference.remaining.front(),
             fmt::format("this model explains all {} draws of infer", inference.experiments)};
  } else if (const auto& nearest = inference.nearest) {
    model = {nearest->profile,
             fmt::format("no model fits; the nearest is wrong about {} of {} samples in {} draws",
                         nearest->wrong_samples, nearest->samples, nearest->experiments)};
  } else {
    model = {subject.Info().profile,
             "this model is the stated one, for none was found: " + inference.message};
  }
  // One model, held to every sample.
  Profile& profile = model.profile;
  profile.contract = Contract::kSampleExact;
  profile.freedom = {};
  profile.shares_edge_samples = false;
  profile.name = "nearest to " + subject.Info().name;
  return model;
}

// Of kSurveyYardsticks. A saved case holds the model, by which a replay judges it.
std::vector<Column> SurveyColumns() {
  constexpr std::array<const char*, 4> kFiles{"wrong", "gap", "overlap", "batch"};
  std::vector<Column> columns;
  for (std::size_t y = 0; y < kFiles.size(); ++y) {
    columns.push_back({.name = std::string(props::kSurveyYardsticks[y]),
                       .file = kFiles[y],
                       .property = y == 3 ? "OneCallDrawsLikeItsTriangles" : ""});
  }
  return columns;
}

ComparisonTable SurveyTable(const SurveyOptions& options, const std::vector<Column>& columns) {
  ComparisonTable table{.what = "domains",
                        .one = "domain",
                        .seed = options.campaign.seed,
                        .cases = options.campaign.cases,
                        .yardsticks = {},
                        .rows = {},
                        .subjects = {}};
  for (const Column& column : columns) table.yardsticks.push_back(column.name);
  for (const props::SurveyedDomain& domain : props::SurveyedDomains()) {
    table.rows.push_back({std::string(domain.name), "",
                          domain.near_limits ? "near its limits" : "in range",
                          domain.near_limits ? "Vertices reach out to the stated limit."
                                             : "Vertices lie near the target."});
  }
  return table;
}

std::vector<std::vector<Cell>> SurveyAll(Crew& crew, const SurveyOptions& options,
                                         const Profile& model) {
  const std::span<const props::SurveyedDomain> domains = props::SurveyedDomains();
  std::vector<std::vector<Cell>> cells(domains.size(),
                                       std::vector<Cell>(props::kSurveyYardsticks.size()));
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
    cells[k] = props::SurveyDomain(crew.Of(worker), domains[k].name, plan);
    progress.Stage("", 0, worker);
  });
  return cells;
}

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
  const std::vector<Column> columns = SurveyColumns();
  ComparisonTable table = SurveyTable(options, columns);
  table.subjects.push_back(
      {info.name,
       SurveyAll(crew, options, model.profile),
       {{"nearest model", props::ModelText(model.profile)}, {"fit", model.fit}}});
  TellNewest(table, columns, options.json, options.save);
  if (!options.json.empty()) io::WriteOutput(options.json, report::ComparisonToJson(table));
  const auto has_ended = [](const std::vector<Cell>& row) { return row.front().ended != 0; };
  return std::ranges::any_of(table.subjects.back().cells, has_ended) ? kExitViolated : kExitHolds;
}

Run AddSurvey(CLI::App* verb, const Invocation& call) {
  static SurveyOptions options;
  options.subject = call.own;
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Draw cases for this profile, not for the subject's own");
  AddCampaign(verb, options.campaign, "domain");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save, "Folder for the worst case of each cell that fails");
  AddJobs(verb, options.jobs, "Domains");
  return [] { return UntilInterrupted(RunSurvey, options); };
}

}  // namespace

extern constinit const Verb kSurveyVerb{
    "survey", VerbGroup::kCampaign, 20,
    "Count how a subject differs from its nearest model, without a verdict", AddSurvey};

}  // namespace rasterproof::tool
