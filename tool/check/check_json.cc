#include "tool/check/check_json.h"

#include <string>
#include <utility>
#include <vector>

#include "io/case_file.h"
#include "io/check_json.h"
#include "io/json_writer.h"
#include "props/cause/cause_text.h"
#include "props/run/near_edge.h"
#include "report/grounds.h"
#include "report/text.h"

namespace rasterproof::tool {
namespace {

using io::JsonWriter;

io::CheckedProperty CheckedOf(const Findings& found, const Finding& finding) {
  const auto& failure = finding.result.counterexample;
  return {finding.result,
          report::CleanText(finding.result.message),
          failure ? report::CleanText(failure->verdict.message) : "",
          finding.place,
          FailsTheRun(found, finding),
          finding.is_known,
          finding.cause ? props::NameOfCause(found.causes.all[*finding.cause]) : "",
          finding.replay};
}

void AddCause(JsonWriter& json, const Findings& found, const props::Cause& cause) {
  std::vector<std::string> properties;
  for (const std::size_t k : cause.properties) properties.push_back(found.all[k].result.property);
  io::WriteCause(json, {props::NameOfCause(cause), props::CauseText(cause, found.causes),
                        cause.wrong_scenes, cause.rests_on_few, std::move(properties)});
}

}  // namespace

std::string CaseLine(const SubjectInfo& subject, const props::Property& property, const Case& c,
                     const Verdict& verdict) {
  JsonWriter json;
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

std::string CheckJson(std::span<const Findings> subjects, int status) {
  JsonWriter json;
  json.BeginObject().Key("rasterproof_check").Integer(1);
  json.Key("version").Text(RASTERPROOF_VERSION).Key("status").Integer(status);
  json.Key("subjects").BeginArray();
  for (const Findings& found : subjects) {
    json.BeginObject().Key("subject").Text(found.subject);
    json.Key("profile").Text(io::ProfileName(found.info.profile));
    json.Key("status").Integer(StatusOf(found)).Key("not_asked").Integer(found.not_asked);
    report::WriteEvidence(json, "unasked", found.unasked);
    json.Key("failures").BeginArray();
    for (const Finding& finding : found.all) {
      if (!finding.result.counterexample) continue;
      io::WriteFailure(json, found.subject, found.info, CheckedOf(found, finding));
    }
    json.EndArray().Key("causes").BeginArray();
    for (const props::Cause& cause : found.causes.all) AddCause(json, found, cause);
    json.EndArray().Key("properties").BeginArray();
    for (const Finding& finding : found.all) io::WriteProperty(json, CheckedOf(found, finding));
    json.EndArray().EndObject();
  }
  return json.EndArray().EndObject().Finish();
}

}  // namespace rasterproof::tool
