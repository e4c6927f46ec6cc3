#include "web/engine/session.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/authority.h"
#include "core/clauses/clauses.h"
#include "io/case_file.h"
#include "io/check_json.h"
#include "io/json_writer.h"
#include "props/cause/cause_text.h"
#include "props/cause/evidence.h"
#include "props/domains/width_inputs.h"
#include "props/engine/known_answers.h"
#include "props/run/conclude.h"
#include "props/run/contract_evidence.h"
#include "props/run/not_asked.h"
#include "web/engine/packed.h"

namespace rasterproof::web {
namespace {

// A round small enough that a page stays awake, and its answers fit into memory: a sample with
// values takes up to a hundred times as much.
props::RoundSize RoundOf(const SubjectInfo& info) {
  const bool is_large = info.coverage == CoverageKind::kFragments;
  return {
      .requests = 2000, .samples = std::size_t{1} << (is_large ? 17 : 22), .of_a_shrinking = 32};
}

std::uint64_t CountOf(std::span<const PropertyResult> results, Outcome outcome) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(results, [&](const PropertyResult& result) {
        return result.outcome == outcome && !IsLackOfQuality(result, FailOn::kStated);
      }));
}

// Whoever has the program at hand asks it by files.
std::string ReplayOf(const SubjectInfo& info, const PropertyResult& result) {
  const Counterexample& failure = *result.counterexample;
  const io::CaseFile file{failure.value, info.name, result.property, failure.verdict.drawn};
  return "rasterproof replay '" + io::InOneLine(io::CaseToJson(file)) + "' --subject rounds:FOLDER";
}

void WriteClauses(io::JsonWriter& json, const PropertyResult& result) {
  json.Key("clauses").BeginArray();
  for (const std::string& id : result.required_by) {
    const Clause* const clause = FindClause(id);
    if (clause == nullptr) continue;
    json.BeginObjectLine().Key("id").Text(id).Key("place").Text(clause->place);
    json.Key("sentence").Text(clause->sentence).Key("reading").Text(clause->reading).EndObject();
  }
  json.EndArray();
}

}  // namespace

Session::Session(Opened opened)
    : opened_(std::move(opened)), engine_(opened_.info, RoundOf(opened_.info)) {
  for (const props::Property* property : opened_.properties) {
    runs_.push_back({Add(*property, nullptr), std::nullopt});
    if (props::IsPutToWidthInputs(property->name, opened_.info))
      runs_.back().widths = Add(*property, &props::WidthInputs());
  }
  for (Run& run : runs_) {
    run.cases.sight = &engine_.Add(std::make_unique<PulledSight>(*run.cases.check));
    if (!run.widths) continue;
    run.widths->sight = &engine_.Add(std::make_unique<PulledSight>(*run.widths->check));
  }
  if (opened_.infers) {
    props::InferOptions options;
    options.seed = opened_.campaign.seed;
    infer_ = &engine_.Add(std::make_unique<props::PulledInfer>(options));
  }
  if (opened_.explains)
    causes_ = &engine_.Add(std::make_unique<props::PulledCauses>([this] { return Failed(); }));
}

Session::Checked Session::Add(const props::Property& property, const props::World* world) {
  props::CampaignOptions campaign = opened_.campaign;
  campaign.world = world;
  if (world != nullptr) campaign.cases = world->cases;
  return {&engine_.Add(std::make_unique<props::PulledCheck>(property, std::move(campaign)))};
}

PropertyResult Session::Checked::Result() const {
  PropertyResult result = check->result();
  if (result.counterexample && sight->seen() != nullptr)
    result.counterexample->verdict.seen = sight->seen();
  return result;
}

std::string Session::Next() { return PackedJobs(engine_.Next(), engine_.answers().Info()); }

bool Session::Answer(std::string_view bytes) {
  return engine_.Answer(OutcomesFrom(bytes, engine_.Next(), engine_.answers().Info()));
}

// Of cases: nobody knows how many draws a model takes.
std::string Session::Progress() const {
  props::PulledProgress sum;
  const auto add = [&](const Checked& checked) {
    const props::PulledProgress one = checked.check->progress();
    sum.done += one.done;
    sum.of += one.of;
  };
  for (const Run& run : runs_) {
    add(run.cases);
    if (run.widths) add(*run.widths);
  }
  io::JsonWriter json;
  json.BeginObjectLine().Key("done").Integer(sum.done).Key("of").Integer(sum.of);
  return json.EndObject().Finish();
}

std::vector<PropertyResult> Session::Results() const {
  std::vector<PropertyResult> results;
  for (const Run& run : runs_) {
    results.push_back(run.cases.Result());
    const Outcome outcome = results.back().outcome;
    if (outcome == Outcome::kViolated || !run.widths) continue;
    PropertyResult widths = run.widths->Result();
    if (widths.outcome == Outcome::kViolated ||
        (widths.outcome == Outcome::kInconclusive && outcome == Outcome::kHolds))
      results.back() = std::move(widths);
  }
  return results;
}

// The places of violations that causes are looked for.
std::vector<std::size_t> Session::FailedOf(std::span<const PropertyResult> results) const {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (IsFailure(results[k], FailOn::kStated) && props::FailedBy(results[k], opened_.info))
      places.push_back(k);
  }
  return places;
}

// Nothing before all checks are done.
std::optional<std::vector<props::FailedProperty>> Session::Failed() const {
  const auto is_done = [](const Run& run) {
    return run.cases.check->has_result() && (!run.widths || run.widths->check->has_result());
  };
  if (!std::ranges::all_of(runs_, is_done)) return std::nullopt;
  const std::vector<PropertyResult> results = Results();
  std::vector<props::FailedProperty> failed;
  for (const std::size_t k : FailedOf(results))
    failed.push_back(*props::FailedBy(results[k], opened_.info));
  return failed;
}

// Writes into `names` what explains each result.
std::vector<io::CheckedCause> Session::CausesOf(std::span<const PropertyResult> results,
                                                std::vector<std::string>& names) const {
  if (causes_ == nullptr) return {};
  const std::vector<std::size_t> places = FailedOf(results);
  std::vector<io::CheckedCause> causes;
  for (const props::Cause& cause : causes_->result().all) {
    std::vector<std::string> properties;
    for (const std::size_t k : cause.properties) {
      properties.push_back(results[places[k]].property);
      names[places[k]] = props::NameOfCause(cause);
    }
    causes.push_back({props::NameOfCause(cause), props::CauseText(cause, causes_->result()),
                      cause.wrong_scenes, cause.rests_on_few, std::move(properties)});
  }
  return causes;
}

// The status of a command: of one subject 0 holds, 1 violated, 4 inconclusive.
int Session::StatusOf(const std::vector<PropertyResult>& results) const {
  constexpr int kHolds = 0;
  constexpr int kViolated = 1;
  constexpr int kInconclusive = 4;
  if (CountOf(results, Outcome::kViolated) != 0) return kViolated;
  const bool is_tested =
      !opened_.is_whole_catalogue || props::EvidenceOfContract(opened_.info, results).is_exercised;
  if (!is_tested || CountOf(results, Outcome::kInconclusive) != 0) return kInconclusive;
  const std::uint64_t held = CountOf(results, Outcome::kHolds);
  if (props::RefusesTooMuch(CountOf(results, Outcome::kRefused), held)) return kInconclusive;
  const bool lacks_quality = std::ranges::any_of(results, [](const PropertyResult& result) {
    return IsLackOfQuality(result, FailOn::kStated);
  });
  return held != 0 || lacks_quality ? kHolds : kInconclusive;
}

std::string Session::Result() const {
  const std::vector<PropertyResult> results = Results();
  std::vector<std::string> names(results.size());
  const std::vector<io::CheckedCause> causes = CausesOf(results, names);
  std::vector<io::CheckedProperty> checked;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const PropertyResult& result = results[k];
    const auto& failure = result.counterexample;
    checked.push_back({result, result.message, failure ? failure->verdict.message : "", "",
                       IsFailure(result, FailOn::kStated), false, names[k]});
    if (failure) checked.back().next = ReplayOf(opened_.info, result);
  }
  const int status = StatusOf(results);
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_check").Integer(1);
  json.Key("version").Text(RASTERPROOF_VERSION).Key("status").Integer(status);
  if (!opened_.json.empty()) json.Key("opened").Value(opened_.json);
  json.Key("subjects").BeginArray().BeginObject().Key("subject").Text(opened_.info.name);
  json.Key("profile").Text(io::ProfileName(opened_.info.profile));
  json.Key("status").Integer(status).Key("not_asked").Integer(0);
  json.Key("unasked").BeginArray();
  if (opened_.is_whole_catalogue) {
    const std::vector<props::Shows> outputs = props::OutputsOf(engine_.answers());
    for (const props::NotAskedOf& one : props::NotAsked(opened_.info, outputs, results)) {
      json.BeginObjectLine().Key("statement").Text(one.what).Key("by").Text(one.why).EndObject();
    }
  }
  json.EndArray().Key("failures").BeginArray();
  for (const io::CheckedProperty& one : checked) {
    if (!one.result.counterexample) continue;
    WriteFailure(json, opened_.info.name, opened_.info, one, [&] {
      WriteClauses(json, one.result);
      WritePicture(json, opened_.info, *one.result.counterexample);
    });
  }
  json.EndArray().Key("causes").BeginArray();
  for (const io::CheckedCause& cause : causes) io::WriteCause(json, cause);
  json.EndArray().Key("properties").BeginArray();
  for (const io::CheckedProperty& one : checked) WriteProperty(json, one);
  json.EndArray();
  if (infer_ != nullptr) WriteModel(json, infer_->result());
  return json.EndObject().EndArray().EndObject().Finish();
}

}  // namespace rasterproof::web
