// One subject's certificate.
#include "tool/certify/certify.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/hash_text.h"
#include "core/result.h"
#include "exact/edge.h"
#include "exact/environment.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/domains/width_inputs.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/conclude.h"
#include "props/run/contract_evidence.h"
#include "props/run/not_asked.h"
#include "tool/case_choice.h"
#include "tool/certify/cmd_certify.h"
#include "tool/certify/evidence.h"
#include "tool/certify/part_file.h"
#include "tool/certify/shard.h"
#include "tool/description.h"
#include "tool/interrupt.h"
#include "tool/resolve.h"
#include "tool/session.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

// Returns whether a result remains valid after an interrupt, which ends the subjects outside: only
// failures that were seen and that repeat are known.
bool Stands(const PropertyResult& result) {
  return result.outcome == Outcome::kViolated && result.counterexample &&
         result.counterexample->verdict.outcome == Outcome::kViolated;
}

void Add(report::Certificate& whole, const report::Certificate& part) {
  whole.tested.insert(whole.tested.end(), part.tested.begin(), part.tested.end());
  whole.measured.insert(whole.measured.end(), part.measured.begin(), part.measured.end());
  whole.replay.insert(part.replay.begin(), part.replay.end());
  whole.oracle_tiers += part.oracle_tiers;
}

// Limits that are not the usual ones.
std::string LimitOptions() {
  const subjects::ProcessLimits& limits = OutsideLimits();
  const subjects::ProcessLimits usual;
  std::string text;
  if (limits.seconds != usual.seconds) text += fmt::format(" --time-limit {}", limits.seconds);
  if (limits.bytes != usual.bytes) {
    text += fmt::format(" --memory-limit {}", static_cast<double>(limits.bytes) / 0x1p30);
  }
  return text;
}

std::map<std::string, std::string> DescribeEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  return {{"compiler", environment.compiler},
          {"flags", environment.flags},
          {"rounding", environment.round_to_nearest ? "to nearest" : "directed"},
          {"subnormals", environment.subnormals_kept ? "kept" : "flushed"},
          {"contraction", environment.contraction_off ? "off" : "on"}};
}

// The command that gives the same certificate in one go. What changes nothing is left out.
std::string CommandOf(const CertifyOptions& options) {
  std::string command = "rasterproof certify";
  if (options.all) command += " --all";
  bool is_outside = false;
  for (const std::string& subject : options.subjects) {
    if (!options.all) command += " " + SubjectOption(subject);
    is_outside = is_outside || IsOutside(subject);
  }
  if (!options.profile.empty()) command += " --profile " + ShellWord(options.profile);
  command += fmt::format(" --seed {} --cases {}", options.campaign.seed, options.campaign.cases);
  if (options.campaign.seconds > 0) {
    command += fmt::format(" --seconds {}", options.campaign.seconds);
  }
  if (is_outside) command += LimitOptions();
  for (const std::string& world : options.worlds) command += " --exhaustive " + ShellWord(world);
  if (!options.scene_set.empty()) command += " --scenes " + ShellWord(options.scene_set);
  if (options.fail_on == FailOn::kQuality) command += " --fail-on quality";
  return command + " --out " + ShellWord(options.output);
}

// Every property, those that a fixed-point input is put to besides, then those of each world.
std::vector<Test> TestsOf(const SubjectInfo& info, const std::vector<std::string>& worlds) {
  std::vector<Test> tests;
  for (const props::Property& property : props::Catalog()) tests.push_back({&property, nullptr});
  for (const props::Property& property : props::Catalog()) {
    if (!props::IsPutToWidthInputs(property.name, info)) continue;
    tests.push_back({&property, &props::WidthInputs()});
  }
  for (const std::string& name : worlds) {
    const props::World* world = props::FindWorld(name);
    for (const std::string_view property : world->properties) {
      tests.push_back({props::FindProperty(property), world});
    }
  }
  return tests;
}

}  // namespace

Certification::Certification(const SubjectFactory& subject, const CertifyOptions& options,
                             MeasuredScenes& scenes, const Source& source)
    : subject_(subject), options_(options), scenes_(scenes), source_(source) {
  const std::unique_ptr<Subject> made = subject.Make();
  info_ = made->Info();
  outputs_ = props::OutputsOf(*made);
  tests_ = TestsOf(info_, options.worlds);
  parts_.resize(tests_.size() + scenes.size());
}

bool Certification::TakesLong(std::size_t part) const {
  return part >= tests_.size() || tests_[part].world != nullptr ||
         tests_[part].property->takes_long;
}

void Certification::Do(std::size_t part, Subject& subject) {
  Part& mine = parts_[part];
  mine.is_begun = true;
  if (part < tests_.size()) {
    DoTest(subject, part, mine);
  } else {
    const exact::TierScope scope;
    MeasureOne(subject, *scenes_[part - tests_.size()], mine.found, scene_pace_);
    mine.found.oracle_tiers = scope.Counts();
  }
  mine.is_done = true;
}

PropertyResult Certification::RunTest(Subject& subject, const Test& test) {
  const std::uint64_t total = test.world != nullptr ? test.world->cases : options_.campaign.cases;
  CaseRange cases{0, total};
  if (source_.range) cases = *source_.range;
  if (source_.shard) cases = CasesOf(*source_.shard, total);
  props::CampaignOptions campaign =
      CampaignOn(subject, options_.campaign, [&] { return subject_.Make(); });
  campaign.world = test.world;
  campaign.first_case = cases.first;
  campaign.cases = cases.end - cases.first;
  campaign.pace = &pace_;
  return props::RunCampaign(subject, *test.property, campaign);
}

void Certification::DoTest(Subject& subject, std::size_t k, Part& mine) {
  const Test& test = tests_[k];
  if (source_.parts.empty()) {
    mine.result = RunTest(subject, test);
  } else {
    mine.result = props::NothingRun(info_, *test.property, options_.campaign.seed, test.world);
    for (const SubjectPart& part : source_.parts) mine.result += part.tests[k];
    props::Conclude(info_, *test.property, mine.result);
  }
  if (test.world == &props::WidthInputs() && IsExhausted(mine.result)) {
    mine.result.message = props::WidthInputsText(info_);
  }
  mine.found.oracle_tiers = mine.result.tiers;
  mine.found.interrupted = Interrupted();
  if (!mine.found.interrupted || Stands(mine.result)) mine.found.tested.push_back(mine.result);
}

bool Certification::IsBegun() const { return std::ranges::any_of(parts_, &Part::is_begun); }

bool Certification::IsDone() const { return std::ranges::all_of(parts_, &Part::is_done); }

report::Certificate Certification::Result() const {
  report::Certificate certificate;
  certificate.tool_version = RASTERPROOF_VERSION;
  certificate.subject = info_;
  certificate.command = CommandOf(options_);
  certificate.environment = DescribeEnvironment();
  certificate.seed = options_.campaign.seed;
  certificate.fail_on = options_.fail_on;
  certificate.proved = ProvedOf(info_);
  const auto add = [&](const Part& part) {
    certificate.interrupted = certificate.interrupted || part.found.interrupted || !part.is_done;
    Add(certificate, part.found);
  };
  const auto scenes = parts_.begin() + static_cast<std::ptrdiff_t>(tests_.size());
  std::for_each(parts_.begin(), scenes, add);
  if (!certificate.interrupted) {
    const props::ContractEvidence evidence = props::EvidenceOfContract(info_, certificate.tested);
    if (!evidence.is_exercised) certificate.contract_untested = evidence.why;
    certificate.contract_thin = evidence.thin;
    certificate.not_asked = UnaskedOf(info_, outputs_, certificate.tested);
  }
  std::for_each(scenes, parts_.end(), add);
  return certificate;
}

SubjectPart Certification::ToPart() const {
  SubjectPart part = DescribePart(info_, options_.worlds);
  part.seed = options_.campaign.seed;
  part.shard = source_.shard;
  if (source_.range) {
    part.range = *source_.range;
  } else {
    part.cases = options_.campaign.cases;
    part.range = CasesOf(source_.shard.value_or(Shard{}), *part.cases);
  }
  for (std::size_t k = 0; k < tests_.size(); ++k) part.tests[k] = parts_[k].result;
  return part;
}

SubjectPart DescribePart(const SubjectInfo& info, const std::vector<std::string>& worlds) {
  SubjectPart part;
  part.tool_version = RASTERPROOF_VERSION;
  part.environment = DescribeEnvironment();
  part.subject = info.name;
  part.stated = DescriptionText(info, io::ProfileToJson(info.profile));
  if (info.name.starts_with(kPluginPrefix)) {
    const std::string path = info.name.substr(kPluginPrefix.size());
    part.stated += "library " + HashText(io::ReadFile(path)) + "\n";
  }
  if (IsOutside(info.name)) part.options = LimitOptions();
  for (const std::string& world : worlds) part.options += " --exhaustive " + ShellWord(world);
  part.worlds = worlds;
  for (const Test& test : TestsOf(info, worlds)) {
    PropertyResult& result = part.tests.emplace_back();
    result.property = test.property->name;
    if (test.world != nullptr) result.world = test.world->name;
  }
  return part;
}

}  // namespace rasterproof::tool
