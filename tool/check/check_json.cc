#include "tool/check/check_json.h"

#include <algorithm>
#include <string_view>

#include "io/case_file.h"
#include "io/json_writer.h"
#include "report/grounds.h"
#include "report/text.h"
#include "tool/check/causes.h"
#include "tool/failure.h"

namespace rasterproof::tool {
namespace {

using io::JsonWriter;

void AddPlace(JsonWriter& json, const Witness& witness) {
  if (witness.triangle >= 0) json.Key("triangle").Integer(witness.triangle);
  if (witness.edge >= 0) {
    json.Key("edge").BeginArrayLine();
    json.Integer((witness.edge + 1) % 3).Integer((witness.edge + 2) % 3).EndArray();
  }
  if (witness.x >= 0) {
    json.Key("pixel").BeginArrayLine().Integer(witness.x).Integer(witness.y).EndArray();
    json.Key("sample").Integer(witness.sample);
  }
}

void AddFailure(JsonWriter& json, const Findings& found, const Finding& finding) {
  const Counterexample& failure = *finding.result.counterexample;
  const Witness witness =
      WithCountsAsGiven(failure.verdict, found.info).witness.value_or(Witness());
  json.BeginObject().Key("property").Text(finding.result.property);
  json.Key("outcome").Text(OutcomeName(finding.result.outcome));
  json.Key("clause").Text(finding.result.clause);
  json.Key("required_by").BeginArrayLine();
  for (const std::string& id : finding.result.required_by) json.Text(id);
  json.EndArray().Key("fails").Bool(FailsTheRun(found, finding));
  json.Key("known").Bool(finding.is_known);
  if (finding.cause) {
    json.Key("cause").Text(NameOfCause(found.causes.all[*finding.cause]));
  } else {
    json.Key("cause").Null();
  }
  json.Key("message").Text(report::CleanText(failure.verdict.message));
  AddPlace(json, witness);
  json.Key("expected").Text(TextOfValue(witness.expected));
  json.Key("actual").Text(TextOfValue(witness.observed));
  json.Key("drawn_as").Text(failure.failing_case);
  const io::CaseFile file{failure.value, found.subject, finding.result.property,
                          failure.verdict.drawn};
  json.Key("case").Value(InOneLine(io::CaseToJson(file)));
  json.Key("next").Text(finding.replay).EndObject();
}

void AddProperty(JsonWriter& json, const Findings& found, const Finding& finding) {
  const PropertyResult& result = finding.result;
  json.BeginObjectLine().Key("property").Text(result.property);
  if (!finding.place.empty()) json.Key("scene").Text(finding.place);
  json.Key("outcome").Text(OutcomeName(result.outcome));
  json.Key("fails").Bool(FailsTheRun(found, finding)).Key("known").Bool(finding.is_known);
  json.Key("cases").Integer(result.cases).Key("exercised").Integer(result.exercised);
  json.Key("refused").Integer(result.cases_refused);
  json.Key("message").Text(report::CleanText(result.message)).EndObject();
}

void AddCause(JsonWriter& json, const Findings& found, const props::Cause& cause) {
  json.BeginObject().Key("cause").Text(NameOfCause(cause));
  json.Key("text").Text(CauseText(cause, found.causes));
  json.Key("wrong_scenes").Integer(cause.wrong_scenes);
  json.Key("too_few").Bool(cause.rests_on_few);
  json.Key("properties").BeginArrayLine();
  for (const std::size_t k : cause.properties) json.Text(found.all[k].result.property);
  json.EndArray().EndObject();
}

}  // namespace

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
      if (finding.result.counterexample) AddFailure(json, found, finding);
    }
    json.EndArray().Key("causes").BeginArray();
    for (const props::Cause& cause : found.causes.all) AddCause(json, found, cause);
    json.EndArray().Key("properties").BeginArray();
    for (const Finding& finding : found.all) AddProperty(json, found, finding);
    json.EndArray().EndObject();
  }
  return json.EndArray().EndObject().Finish();
}

}  // namespace rasterproof::tool
