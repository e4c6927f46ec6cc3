#include <cstddef>
#include <string>

#include "fmt/format.h"
#include "io/case_file.h"
#include "io/scene_json.h"
#include "tool/survey/survey.h"

namespace rasterproof::tool {
namespace {

// Joins what `write` gives for each element.
template <class List, class Write>
std::string JsonList(const List& list, Write write) {
  std::string json;
  for (const auto& element : list) json += (json.empty() ? "" : ",\n") + write(element);
  return "[" + json + "]";
}

std::string FitJson(const Fit& fit) {
  return fmt::format(R"({{"profile": {}, "wrong": {}, "samples": {}}})",
                     io::ProfileToJson(fit.model), fit.wrong, fit.samples);
}

std::string CounterexampleJson(const Counterexample& found) {
  return fmt::format(R"({{"fault": "{}", "end": {}, "case": {}}})", FaultName(found.fault),
                     io::JsonString(found.end), io::CaseToJson({found.minimal, "", ""}));
}

std::string TallyJson(const FamilyTally& tally) {
  std::string json = fmt::format(
      R"("scenes": {}, "refused": {}, "triangles": {}, "samples": {}, "wrong": {}, "gaps": {}, )"
      R"("overlaps": {}, "subject_seconds": {:.6f}, "alone_seconds": {:.6f}, "seconds": {:.6f}, )"
      R"("faulty_scenes": {{)",
      tally.scenes, tally.refused, tally.triangles, tally.samples, tally.wrong, tally.gaps,
      tally.overlaps, tally.subject_seconds.at_once, tally.subject_seconds.alone, tally.seconds);
  for (std::size_t k = 0; k < kFaults; ++k) {
    json += fmt::format(R"({}"{}": {})", k == 0 ? "" : ", ", FaultName(static_cast<Fault>(k)),
                        tally.faulty[k]);
  }
  return json + "}";
}

std::string FamilyJson(const FamilySurvey& survey) {
  const Family& family = *survey.family;
  return fmt::format(R"({{"family": "{}", "mesh": {}, "near_limits": {}, "on_lattice": {}, {}, )"
                     R"("counterexamples": {}}})",
                     family.name, family.kind == FamilyKind::kCover,
                     family.place == FamilyPlace::kNearLimits, family.on_lattice,
                     TallyJson(survey.tally), JsonList(survey.counterexamples, CounterexampleJson));
}

// The share of the time that was not the subject's: scenes, oracle, comparison.
std::string OwnShareJson(const Survey& survey) {
  double all = 0;
  double subject = 0;
  for (const FamilySurvey& family : survey.families) {
    all += family.tally.seconds;
    subject += family.tally.subject_seconds.at_once + family.tally.subject_seconds.alone;
  }
  return all > 0 ? fmt::format("{:.4f}", 1 - subject / all) : "null";
}

}  // namespace

std::string_view FaultName(Fault fault) {
  switch (fault) {
    case Fault::kWrong:
      return "wrong";
    case Fault::kGap:
      return "gap";
    case Fault::kTwice:
      return "twice";
    case Fault::kBatch:
      return "batch";
    case Fault::kEnd:
      return "end";
  }
  return "";
}

std::string SurveyToJson(const Survey& survey) {
  return fmt::format(
      R"({{"rasterproof_survey": 1, "subject": {}, "summary": {}, "declared": {}, "trouble": {},
"own_share": {},
"fits": {},
"families": {}}}
)",
      io::JsonString(survey.subject), io::JsonString(survey.summary),
      io::ProfileToJson(survey.declared), io::JsonString(survey.trouble), OwnShareJson(survey),
      JsonList(survey.fits, FitJson), JsonList(survey.families, FamilyJson));
}

}  // namespace rasterproof::tool
