#include "report/certificate.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/grids_left.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "report/grounds.h"

namespace rasterproof::report {
namespace {

void WriteSubject(io::JsonWriter& json, const Certificate& certificate) {
  const SubjectInfo& info = certificate.subject;
  json.Key("subject").BeginObject();
  json.Key("name").Text(info.name);
  json.Key("summary").Text(info.summary);
  json.Key("input").Text(info.input == Precision::kFloat32 ? "float32" : "float64");
  json.Key("takes_window").Bool(info.takes_window);
  json.Key("takes_clip").Bool(info.takes_clip);
  json.Key("states_exact").Bool(info.states_exact);
  json.Key("profile").Value(io::ProfileToJson(info.profile));
  json.EndObject();
}

void WriteWitness(io::JsonWriter& json, const Witness& witness) {
  json.Key("witness").BeginObject();
  json.Key("triangle").Integer(witness.triangle);
  json.Key("edge").Integer(witness.edge);
  json.Key("x").Integer(witness.x);
  json.Key("y").Integer(witness.y);
  json.Key("sample").Integer(witness.sample);
  json.Key("observed").Text(TextOfValue(witness.observed));
  json.Key("expected").Text(TextOfValue(witness.expected));
  json.EndObject();
}

void WriteCounterexample(io::JsonWriter& json, const Certificate& certificate,
                         const PropertyResult& result) {
  const Counterexample& found = *result.counterexample;
  json.Key("counterexample").BeginObject();
  json.Key("found_as_case").Text(found.failing_case);
  json.Key("message").Text(found.verdict.message);
  if (found.verdict.witness) WriteWitness(json, *found.verdict.witness);
  json.Key("replay").Text(ReplayCommand(certificate, result));
  std::string file =
      io::CaseToJson({found.value, result.subject, result.property, found.verdict.drawn});
  while (file.ends_with('\n')) file.pop_back();
  json.Key("case").Value(file);
  json.EndObject();
}

// What is left of the grids that the profile allows, by the kind of target.
void WriteGrids(io::JsonWriter& json, const std::vector<GridsOnTarget>& list) {
  json.Key("grids_left").BeginArray();
  for (const GridsOnTarget& grids : list) {
    json.BeginObject();
    json.Key("width").Integer(static_cast<std::uint64_t>(grids.width));
    json.Key("height").Integer(static_cast<std::uint64_t>(grids.height));
    json.Key("samples").Integer(static_cast<std::uint64_t>(grids.samples));
    json.Key("space").Text(grids.clip_space ? "clip" : "window");
    json.Key("cases").Integer(grids.cases);
    json.Key("subpixel_bits").Text(grids.left.Text());
    json.EndObject();
  }
  json.EndArray();
}

void WriteTested(io::JsonWriter& json, const Certificate& certificate,
                 const PropertyResult& result) {
  json.BeginObject();
  json.Key("property").Text(result.property);
  if (!result.world.empty()) json.Key("world").Text(result.world);
  json.Key("clause").Text(result.clause);
  json.Key("authority").Text(AuthorityName(result.authority));
  json.Key("required_by").BeginArray();
  for (const std::string& id : result.required_by) json.Text(id);
  json.EndArray();
  json.Key("tolerance").Text(result.tolerance);
  json.Key("outcome").Text(OutcomeName(result.outcome));
  json.Key("message").Text(result.message);
  json.Key("seed").Text(std::to_string(result.seed));
  json.Key("cases").Integer(result.cases);
  json.Key("cases_exercised").Integer(result.cases_exercised);
  json.Key("exercised").Integer(result.exercised);
  json.Key("cases_refused").Integer(result.cases_refused);
  json.Key("not_judged").Integer(result.not_judged);
  if (result.in_gaps != 0) json.Key("in_gaps").Integer(result.in_gaps);
  json.Key("worst_ratio").Exact(result.worst_ratio);
  json.Key("near_edge").BeginObject().Members(kNearEdgeCounters, result.NearEdge()).EndObject();
  json.Key("cases_with").BeginObject();
  for (std::size_t p = 0; p < kCasePlaces.size(); ++p) {
    json.Key(kCasePlaces[p]).Integer(result.places[p].asked - result.places[p].refused);
  }
  json.EndObject();
  if (!result.grids.empty()) WriteGrids(json, result.grids);
  if (result.counterexample) WriteCounterexample(json, certificate, result);
  json.EndObject();
}

void WriteMeasured(io::JsonWriter& json, const Certificate& certificate,
                   const SceneResult& result) {
  const std::string why = WhyNotJudged(certificate, result);
  json.BeginObject();
  json.Key("scene").Text(result.scene);
  json.Key("profile").Text(result.profile);
  json.Key("judged").Bool(why.empty());
  json.Key("applicable").Bool(result.applicable);
  json.Key("message").Text(result.message.empty() ? why : result.message);
  json.Key("triangles").Integer(result.triangles);
  if (result.applicable) {
    json.Key("as_shown").Bool(result.as_shown);
    json.Key("samples").Integer(result.difference.samples);
    json.Key("covered").Integer(result.difference.covered);
    json.Key("wrong").Integer(result.difference.wrong);
    json.Key("missing").Integer(result.difference.missing);
    json.Key("unexpected").Integer(result.difference.unexpected);
  }
  json.EndObject();
}

}  // namespace

std::string ReplayCommand(const Certificate& certificate, const PropertyResult& result) {
  const auto found = certificate.replay.find(NameOf(result));
  if (found != certificate.replay.end()) return found->second;
  return fmt::format("rasterproof replay {}.json", result.property);
}

std::string CertificateToJson(const Certificate& certificate) {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_certificate").Integer(3);
  json.Key("tool_version").Text(certificate.tool_version);
  json.Key("command").Text(certificate.command);
  const Overall overall = OverallOf(certificate);
  json.Key("verdict").Text(OutcomeName(overall.outcome));
  json.Key("reason").Text(overall.reason);
  json.Key("quality_fails").Bool(certificate.fail_on == FailOn::kQuality);
  WriteEvidence(json, "assumed", AssumptionsUnder(certificate.subject.profile));
  json.Key("interrupted").Bool(certificate.interrupted);
  WriteSubject(json, certificate);
  json.Key("environment").BeginObject();
  for (const auto& [name, value] : certificate.environment) json.Key(name).Text(value);
  json.EndObject();
  json.Key("seed").Text(std::to_string(certificate.seed));
  WriteEvidence(json, "proved", certificate.proved);
  WriteEvidence(json, "exhausted", Exhausted(certificate));
  json.Key("tested").BeginArray();
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome == Outcome::kNotApplicable || IsExhausted(result)) continue;
    WriteTested(json, certificate, result);
  }
  json.EndArray();
  json.Key("measured").BeginArray();
  for (const SceneResult& result : certificate.measured) WriteMeasured(json, certificate, result);
  json.EndArray();
  json.Key("oracle_tiers").BeginObject();
  for (const auto& [name, count] : TiersByName(certificate)) json.Key(name).Integer(count);
  json.EndObject();
  WriteEvidence(json, "not_applicable", NotApplicable(certificate));
  WriteEvidence(json, "not_asked", certificate.not_asked);
  json.EndObject();
  return json.Finish();
}

std::string TimesToJson(const Certificate& certificate) {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_certificate_times").Integer(1);
  json.Key("tested").BeginArray();
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome == Outcome::kNotApplicable) continue;
    json.BeginObject();
    json.Key("property").Text(NameOf(result));
    json.Key("seconds").Rounded(result.seconds);
    json.EndObject();
  }
  json.EndArray();
  json.Key("measured").BeginArray();
  for (const SceneResult& result : certificate.measured) {
    if (!result.applicable) continue;
    json.BeginObject();
    json.Key("scene").Text(result.scene);
    json.Key("profile").Text(result.profile);
    json.Key("seconds").Rounded(result.seconds);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  return json.Finish();
}

}  // namespace rasterproof::report
