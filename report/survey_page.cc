// The section on surveys: how rasterizers differ from the model nearest to each.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/profile_keys.h"
#include "fmt/format.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/number_text.h"
#include "io/output.h"
#include "io/profile_json.h"
#include "io/scene_json.h"
#include "report/bench_page_parts.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

using io::JsonValue;

// What a domain counts, then its cases by fault: the columns of subjects and domains.
constexpr std::array<std::string_view, 14> kSurveyCounts{
    "cases", "refused",  "unjudged", "meshes", "triangles", "samples", "wrong",
    "gaps",  "overlaps", "wrong",    "gap",    "overlap",   "batch",   "end"};
constexpr std::size_t kTriangles = 4;
constexpr std::size_t kFirstFault = 6;  // from here on they are faults
constexpr std::size_t kFaultyCases = 9;

// Of the subject: a call a case, then a call a triangle; of everything.
constexpr std::array kSurveySeconds{"subject_seconds", "alone_seconds", "seconds"};

struct SurveyCounts {
  std::array<std::uint64_t, kSurveyCounts.size()> of{};
  std::uint64_t wrong_near_limits = 0;
  std::array<double, kSurveySeconds.size()> seconds{};
};

std::uint64_t SurveyCount(const JsonValue& object, std::string_view key) {
  return static_cast<std::uint64_t>(object.Get(key).RequireInteger(0, INT64_MAX));
}

std::string SurveyText(const JsonValue& object, std::string_view key) {
  return Escaped(object.Get(key).RequireString());
}

void AddSurvey(const JsonValue& domain, SurveyCounts& sum) {
  for (std::size_t k = 0; k < kSurveyCounts.size(); ++k) {
    sum.of[k] +=
        SurveyCount(k < kFaultyCases ? domain : domain.Get("faulty_cases"), kSurveyCounts[k]);
  }
  if (io::Boolean(domain.Get("near_limits"))) sum.wrong_near_limits += SurveyCount(domain, "wrong");
  for (std::size_t k = 0; k < kSurveySeconds.size(); ++k) {
    sum.seconds[k] += io::CoordinateFromJson(domain.Get(kSurveySeconds[k]), Precision::kFloat64);
  }
}

std::string CountCells(const SurveyCounts& counts) {
  std::string html;
  for (std::size_t k = 0; k < kSurveyCounts.size(); ++k) {
    html += Number(counts.of[k], k < kFirstFault ? "" : "wrong");
  }
  return html;
}

std::string SurveyTable(std::string_view words, std::string_view rows,
                        std::string_view numbers = "") {
  std::string heads;
  for (std::size_t k = 0; k < kSurveyCounts.size(); ++k) {
    heads += fmt::format("<th class=\"number\">{}{}</th>",
                         k < kFaultyCases ? "" : "cases: ", kSurveyCounts[k]);
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr>{}{}{}</tr></thead><tbody>\n{}"
      "</tbody></table></div>\n",
      words, heads, numbers, rows);
}

std::string StatedProfile(const JsonValue& stated) {
  const Profile profile = io::ProfileFromJson(stated);
  if (stated.kind() == io::JsonKind::kString) return "preset " + profile.name;
  return fmt::format("{}, |x| up to {:.8g}", ContractName(profile.contract),
                     profile.coordinate_limit);
}

// How many samples of the experiments the model gets wrong.
std::string ModelErrors(const JsonValue& model) {
  const std::uint64_t samples = SurveyCount(model, "samples");
  if (samples != 0) {
    return fmt::format("{} of {}", Grouped(SurveyCount(model, "wrong")), Grouped(samples));
  }
  if (!SurveyText(model, "remark").empty()) return "not found";
  return fmt::format("0, in {} draws", Grouped(SurveyCount(model, "experiments")));
}

std::string SurveyRow(const JsonValue& survey, std::string_view anchor) {
  SurveyCounts sum;
  for (const JsonValue domain : survey.Get("domains").RequireArray()) AddSurvey(domain, sum);
  const JsonValue model = survey.Get("model");
  const auto [drawn, alone, all] = sum.seconds;
  return fmt::format(
      "<tr><th scope=\"row\"><a class=\"name\" href=\"#{}\">{}</a></th><td>{}</td><td "
      "class=\"remark\">{}</td>"
      "<td class=\"number\">{}</td>{}{}{}<td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "</tr>\n",
      anchor, SurveyText(survey, "subject"), StatedProfile(survey.Get("stated")),
      SurveyText(model, "text"), ModelErrors(model),
      Number(sum.of[kFirstFault] - sum.wrong_near_limits, "wrong"),
      Number(sum.wrong_near_limits, "wrong"), CountCells(sum),
      NumberText(static_cast<double>(sum.of[kTriangles]) / drawn),
      all > 0 ? fmt::format("{:.0f} %", 100 * (1 - (drawn + alone) / all)) : "–");
}

// The case as one line a triangle, in numbers that are exact.
std::string FindingHtml(const JsonValue& finding) {
  const Scene scene = io::SceneFromJson(finding.Get("case").Get("scene"));
  std::string text = fmt::format("target {} x {}", scene.width, scene.height);
  for (const auto& triangle : scene.triangles) {
    text += '\n';
    for (const int corner : triangle) {
      const Vertex& v = scene.vertices[static_cast<std::size_t>(corner)];
      text += fmt::format("({}, {})  ", io::ExactText(v.x), io::ExactText(v.y));
    }
  }
  return Folded(SurveyText(finding, "name") + ": " + SurveyText(finding, "fault") + " " +
                    SurveyText(finding, "end"),
                "<pre>" + text + "</pre>\n", false);
}

std::string SurveyDetails(const JsonValue& survey, std::string_view anchor) {
  std::string rows;
  std::string findings;
  for (const JsonValue domain : survey.Get("domains").RequireArray()) {
    SurveyCounts counts;
    AddSurvey(domain, counts);
    rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td>{}</tr>\n",
                        SurveyText(domain, "domain"),
                        io::Boolean(domain.Get("near_limits")) ? "near its limits" : "in range",
                        CountCells(counts));
    for (const JsonValue found : domain.Get("findings").RequireArray()) {
      findings += FindingHtml(found);
    }
  }
  return fmt::format(
      "<div id=\"{}\" class=\"group\">\n{}</div>\n", anchor,
      Folded(fmt::format("<strong>{}</strong> <span class=\"why\">{}</span>",
                         SurveyText(survey, "subject"), SurveyText(survey, "summary")),
             SurveyTable("<th>domain</th><th>place</th>", rows) + "<p>" +
                 SurveyText(survey.Get("model"), "remark") + "</p>\n" + findings,
             false));
}

}  // namespace

std::string SurveySection(const std::string& folder) {
  std::set<std::string> paths;
  std::error_code fault;
  for (const auto& entry : std::filesystem::directory_iterator(folder, fault)) {
    if (entry.path().extension() == ".json") paths.insert(entry.path().string());
  }
  if (paths.empty()) {
    throw InputError(folder, "the folder holds no survey",
                     "write one: rasterproof survey --json " + folder + "/NAME.json");
  }
  std::string rows;
  std::string rest;
  std::size_t count = 0;
  for (const std::string& path : paths) {
    const io::JsonDocument document(io::ReadFile(path), path);
    const JsonValue version = document.root().Get("rasterproof_survey");
    if (version.RequireInteger(0, INT32_MAX) != 4) {
      throw version.Error("version " + std::string(version.text()) + " is unknown",
                          "this program reads version 4: run rasterproof survey again");
    }
    const std::string anchor = "survey-" + std::to_string(count++);
    rows += SurveyRow(document.root(), anchor);
    rest += SurveyDetails(document.root(), anchor);
  }
  const std::string absent = folder + "/absent.txt";
  if (std::filesystem::exists(absent)) rest += "<pre>" + Escaped(io::ReadFile(absent)) + "</pre>\n";
  return Section(
      "surveys", "Surveys of rasterizers",
      "Each drew the cases of the catalogue's domains, and was compared with the exact coverage of "
      "the model nearest to it: observed, not judged. <code>rasterproof replay</code> draws a case "
      "again by its name.",
      SurveyTable(
          "<th>subject</th><th>states</th><th>nearest model</th><th class=\"number\">it gets "
          "wrong</th><th class=\"number\">wrong in range</th><th class=\"number\">wrong near "
          "limits</th>",
          rows, "<th class=\"number\">triangles/s</th><th class=\"number\">ours</th>") +
          ColumnKey({{"it gets wrong", "the nearest model, of the samples that it was chosen by"},
                     {"wrong",
                      "samples that differ from the nearest model; near limits: in domains "
                      "whose vertices reach out to the stated limit"},
                     {"meshes",
                      "cases that cover every sample of their target exactly once, whatever "
                      "the tie rule: their gaps and overlaps are defects of any rasterizer"},
                     {"cases: batch", "one call is not the sum of calls with each triangle"},
                     {"cases: end", "the subject crashed or hung"},
                     {"triangles/s", "of its drawing in one call, with the pipe to its process"},
                     {"ours", "the share of all the time that was not the subject's"}}) +
          rest);
}

}  // namespace rasterproof::report
