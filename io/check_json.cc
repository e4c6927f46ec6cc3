#include "io/check_json.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <variant>

#include "core/coverage.h"
#include "core/witness.h"
#include "io/case_file.h"

namespace rasterproof::io {
namespace {

void WritePlace(JsonWriter& json, const Witness& witness) {
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

}  // namespace

Verdict WithCountsAsGiven(Verdict verdict, const SubjectInfo& info) {
  if (!verdict.witness || info.coverage == CoverageKind::kFacingCounts) return verdict;
  const auto facings = [](WitnessValue& value) {
    return value.empty() ? nullptr : std::get_if<FacingCounts>(&value.front());
  };
  const auto sum = [](FacingCounts counts) { return std::int64_t{counts.front} + counts.back; };
  const FacingCounts* const observed = facings(verdict.witness->observed);
  const FacingCounts* const expected = facings(verdict.witness->expected);
  if (!observed || !expected || sum(*observed) == sum(*expected)) return verdict;
  verdict.witness->observed.front() = sum(*observed);
  verdict.witness->expected.front() = sum(*expected);
  return verdict;
}

std::string InOneLine(const std::string& json) {
  std::string line;
  bool is_indent = false;
  for (const char c : json) {
    if (c == '\n' && line.ends_with(',')) line += ' ';
    if (c == '\n') is_indent = true;
    if (is_indent && c != '\n' && c != ' ') is_indent = false;
    if (!is_indent) line += c;
  }
  return line;
}

void WriteFailure(JsonWriter& json, const std::string& subject, const SubjectInfo& info,
                  const CheckedProperty& checked, const std::function<void()>& more) {
  const PropertyResult& result = checked.result;
  const Counterexample& failure = *result.counterexample;
  const Witness witness = WithCountsAsGiven(failure.verdict, info).witness.value_or(Witness());
  json.BeginObject().Key("property").Text(result.property);
  json.Key("outcome").Text(OutcomeName(result.outcome));
  json.Key("clause").Text(result.clause);
  json.Key("required_by").BeginArrayLine();
  for (const std::string& id : result.required_by) json.Text(id);
  json.EndArray().Key("fails").Bool(checked.fails);
  json.Key("known").Bool(checked.is_known);
  json.Key("cause");
  if (checked.cause.empty()) {
    json.Null();
  } else {
    json.Text(checked.cause);
  }
  json.Key("message").Text(checked.failure_message);
  WritePlace(json, witness);
  json.Key("expected").Text(TextOfValue(witness.expected));
  json.Key("actual").Text(TextOfValue(witness.observed));
  json.Key("drawn_as").Text(failure.failing_case);
  const CaseFile file{failure.value, subject, result.property, failure.verdict.drawn};
  json.Key("case").Value(InOneLine(CaseToJson(file)));
  json.Key("next").Text(checked.next);
  if (more) more();
  json.EndObject();
}

void WriteCause(JsonWriter& json, const CheckedCause& cause) {
  json.BeginObject().Key("cause").Text(cause.name).Key("text").Text(cause.text);
  json.Key("wrong_scenes").Integer(cause.wrong_scenes).Key("too_few").Bool(cause.is_too_few);
  json.Key("properties").BeginArrayLine();
  for (const std::string& property : cause.properties) json.Text(property);
  json.EndArray().EndObject();
}

void WriteProperty(JsonWriter& json, const CheckedProperty& checked) {
  const PropertyResult& result = checked.result;
  json.BeginObjectLine().Key("property").Text(result.property);
  if (!checked.scene.empty()) json.Key("scene").Text(checked.scene);
  json.Key("outcome").Text(OutcomeName(result.outcome));
  json.Key("fails").Bool(checked.fails).Key("known").Bool(checked.is_known);
  json.Key("cases").Integer(result.cases).Key("exercised").Integer(result.exercised);
  json.Key("refused").Integer(result.cases_refused);
  json.Key("message").Text(checked.message).EndObject();
}

}  // namespace rasterproof::io
