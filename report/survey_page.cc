// The section on surveys: how rasterizers differ from the model nearest to each.
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/comparison.h"
#include "core/error.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/json_document.h"
#include "io/output.h"
#include "io/scene_json.h"
#include "report/comparison.h"
#include "report/page.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

using io::JsonValue;

// What a survey says of its subject.
constexpr std::array<std::string_view, 2> kFactsOfSubjects{"nearest model", "fit"};

std::uint64_t Count(const JsonValue& object, std::string_view key) {
  return static_cast<std::uint64_t>(object.Get(key).RequireInteger(0, INT64_MAX));
}

std::string Word(const JsonValue& object, std::string_view key) {
  return std::string(object.Get(key).RequireString());
}

Cell ReadCell(const JsonValue& object) {
  Cell cell;
  cell.cases = Count(object, "cases");
  cell.wrong = Count(object, "wrong");
  cell.ended = Count(object, "ended");
  cell.excused = Count(object, "excused");
  cell.why = Word(object, "why");
  if (cell.ended == 0) {
    cell.furthest = io::CoordinateFromJson(object.Get("worst_pixels"), Precision::kFloat64);
  }
  if (std::string name = Word(object, "worst_case"); !name.empty()) {
    (cell.ended == 0 ? cell.worst : cell.ended_on).emplace().origin = std::move(name);
  }
  return cell;
}

// Without subjects.
ComparisonTable ReadHead(const JsonValue& root) {
  const JsonValue version = root.Get("rasterproof_comparison");
  if (version.RequireInteger(0, INT32_MAX) != 1) {
    throw version.Error("version " + std::string(version.text()) + " is unknown",
                        "this program reads version 1: run rasterproof survey again");
  }
  ComparisonTable table;
  table.what = Word(root, "what");
  table.one = Word(root, "one");
  table.seed = Count(root, "seed");
  table.cases = Count(root, "cases");
  for (const JsonValue name : root.Get("yardsticks").RequireArray()) {
    table.yardsticks.emplace_back(name.RequireString());
  }
  for (const JsonValue row : root.Get(table.what).RequireArray()) {
    table.rows.push_back({Word(row, "name"), "", Word(row, "theme"), Word(row, "right")});
  }
  return table;
}

ComparedSubject ReadSubject(const JsonValue& object, const ComparisonTable& table) {
  ComparedSubject subject{Word(object, "subject"), {}};
  for (const std::string_view name : kFactsOfSubjects) {
    if (const auto fact = object.Find(JsonKey(std::string(name)))) {
      subject.facts.emplace_back(name, fact->RequireString());
    }
  }
  const auto cells = object.Get("cells");
  for (const JsonValue row : cells.RequireArray()) {
    std::vector<Cell>& of_row = subject.cells.emplace_back();
    for (const std::string& name : table.yardsticks) {
      of_row.push_back(ReadCell(row.Get(JsonKey(name))));
    }
  }
  if (subject.cells.size() != table.rows.size()) {
    throw cells.Error("it has another number of rows than the table", "write the file again");
  }
  return subject;
}

// The first file says what the rows and yardsticks are.
void AddSurvey(const std::string& path, ComparisonTable& table) {
  const io::JsonDocument document(io::ReadFile(path), path);
  ComparisonTable head = ReadHead(document.root());
  if (table.subjects.empty()) {
    table = std::move(head);
  } else if (head.yardsticks != table.yardsticks || head.seed != table.seed ||
             head.cases != table.cases ||
             !std::ranges::equal(head.rows, table.rows, {}, &ComparedRow::name,
                                 &ComparedRow::name)) {
    throw InputError(path, "its rows, yardsticks, seed or cases are not those of the other files",
                     "run rasterproof survey again, with the same --seed and --cases");
  }
  for (const JsonValue subject : document.root().Get("subjects").RequireArray()) {
    table.subjects.push_back(ReadSubject(subject, table));
  }
}

// A line for each subject: what it was compared with.
std::string FactsHtml(const ComparisonTable& table) {
  std::string html;
  for (const ComparedSubject& subject : table.subjects) {
    html += fmt::format("<p><span class=\"name\">{}</span>", Escaped(subject.name));
    for (const auto& [name, value] : subject.facts) {
      html += fmt::format("; {}: {}", name, Escaped(value));
    }
    html += "</p>\n";
  }
  return html;
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
  ComparisonTable table;
  for (const std::string& path : paths) AddSurvey(path, table);
  std::string rest = FactsHtml(table);
  const std::string absent = folder + "/absent.txt";
  if (std::filesystem::exists(absent)) rest += "<pre>" + Escaped(io::ReadFile(absent)) + "</pre>\n";
  return Section(
      "surveys", "Surveys of rasterizers",
      fmt::format("Each was compared with the exact coverage of the model nearest to it: observed, "
                  "not judged. In a cell, from above: {}. T: tested (seed {}), none wrong; a "
                  "share: wrong cases; –: none was compared. <code>rasterproof replay</code> "
                  "draws a case again by its name.",
                  Escaped(fmt::format("{}", fmt::join(table.yardsticks, ", "))), table.seed),
      ComparisonMatrix(table) + rest);
}

}  // namespace rasterproof::report
