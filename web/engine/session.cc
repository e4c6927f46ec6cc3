#include "web/engine/session.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include "core/authority.h"
#include "io/case_file.h"
#include "io/check_json.h"
#include "io/json_writer.h"
#include "props/domains/width_inputs.h"
#include "props/engine/known_answers.h"
#include "props/run/conclude.h"
#include "props/run/contract_evidence.h"
#include "props/run/not_asked.h"
#include "web/engine/packed.h"

namespace rasterproof::web {
namespace {

// A round small enough that a page stays awake, and its answers fit into memory.
constexpr props::RoundSize kRound{.requests = 2000, .samples = std::size_t{1} << 22};

std::uint64_t CountOf(std::span<const PropertyResult> results, Outcome outcome) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(results, [&](const PropertyResult& result) {
        return result.outcome == outcome && !IsLackOfQuality(result, FailOn::kStated);
      }));
}

}  // namespace

Session::Session(Opened opened) : opened_(std::move(opened)), engine_(opened_.info, kRound) {
  for (const props::Property* property : opened_.properties) {
    const bool has_widths = props::IsPutToWidthInputs(property->name, opened_.info);
    runs_.push_back(
        {Add(*property, nullptr), has_widths ? Add(*property, &props::WidthInputs()) : nullptr});
  }
}

const props::PulledCheck* Session::Add(const props::Property& property, const props::World* world) {
  props::CampaignOptions campaign = opened_.campaign;
  campaign.world = world;
  if (world != nullptr) campaign.cases = world->cases;
  return &engine_.Add(std::make_unique<props::PulledCheck>(property, std::move(campaign)));
}

std::string Session::Next() { return PackedJobs(engine_.Next()); }

bool Session::Answer(std::string_view bytes) {
  return engine_.Answer(OutcomesFrom(bytes, engine_.Next(), engine_.answers().Info()));
}

std::string Session::Progress() const {
  const props::PulledProgress progress = engine_.progress();
  io::JsonWriter json;
  json.BeginObjectLine().Key("done").Integer(progress.done).Key("of").Integer(progress.of);
  return json.EndObject().Finish();
}

std::vector<PropertyResult> Session::Results() const {
  std::vector<PropertyResult> results;
  for (const Run& run : runs_) {
    results.push_back(run.cases->result());
    const Outcome outcome = results.back().outcome;
    if (outcome == Outcome::kViolated || run.widths == nullptr) continue;
    const PropertyResult& widths = run.widths->result();
    if (widths.outcome == Outcome::kViolated ||
        (widths.outcome == Outcome::kInconclusive && outcome == Outcome::kHolds))
      results.back() = widths;
  }
  return results;
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
  std::vector<io::CheckedProperty> checked;
  for (const PropertyResult& result : results) {
    const auto& failure = result.counterexample;
    checked.push_back({result, result.message, failure ? failure->verdict.message : "", "",
                       IsFailure(result, FailOn::kStated)});
  }
  const int status = StatusOf(results);
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_check").Integer(1);
  json.Key("version").Text(RASTERPROOF_VERSION).Key("status").Integer(status);
  json.Key("subjects").BeginArray().BeginObject().Key("subject").Text(opened_.info.name);
  json.Key("profile").Text(io::ProfileName(opened_.info.profile));
  json.Key("status").Integer(status).Key("not_asked").Integer(0);
  json.Key("unasked").BeginArray();
  if (opened_.is_whole_catalogue) {
    // It shows coverage alone.
    for (const props::NotAskedOf& one : props::NotAsked(opened_.info, {}, results)) {
      json.BeginObjectLine().Key("what").Text(one.what).Key("why").Text(one.why).EndObject();
    }
  }
  json.EndArray().Key("failures").BeginArray();
  for (const io::CheckedProperty& one : checked) {
    if (one.result.counterexample) WriteFailure(json, opened_.info.name, opened_.info, one);
  }
  json.EndArray().Key("causes").BeginArray().EndArray().Key("properties").BeginArray();
  for (const io::CheckedProperty& one : checked) WriteProperty(json, one);
  return json.EndArray().EndObject().EndArray().EndObject().Finish();
}

}  // namespace rasterproof::web
