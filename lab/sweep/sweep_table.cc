#include "lab/sweep/sweep_table.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/drawing.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "lab/sweep/sweep_builds.h"

namespace rasterproof::lab {
namespace {

std::string GroupName(std::size_t group) {
  return group < 26 ? std::string(1, static_cast<char>('A' + group)) : fmt::format("A{}", group);
}

// "near-edge:17@1, pixel (3, 4): 1 in place of 0".
std::string FirstChange(const SweepRunner& runner, const SweepRow& row) {
  if (row.outcome.changes.empty()) return "";
  const ChangedSample& change = row.outcome.changes.front();
  const Case& c = runner.cases()[change.number_of_case];
  const Drawing* const base = runner.BaseDrawing(change.number_of_case);
  if (change.sample == ChangedSample::kWholeCase || base == nullptr) {
    return fmt::format("{}: {}", c.origin,
                       base == nullptr ? "drawn; the base refuses it" : "refused; the base draws");
  }
  const auto samples = static_cast<std::size_t>(base->counts.samples);
  const auto width = static_cast<std::size_t>(base->counts.width);
  const std::size_t pixel = change.sample / samples;
  std::string place = fmt::format("{}, pixel ({}, {})", c.origin, pixel % width, pixel / width);
  if (samples > 1) place += fmt::format(" sample {}", change.sample % samples);
  if (!base->primitive_ids.empty()) {
    return fmt::format("{}: triangle {} in place of {}", place,
                       static_cast<std::int32_t>(change.front), base->primitive_ids[change.sample]);
  }
  return fmt::format("{}: covered {} times in place of {}", place, change.front + change.back,
                     base->counts.front[change.sample] + base->counts.back[change.sample]);
}

// What the build draws beside the base, or why it draws nothing.
Cell CellOf(const SweepRow& row) {
  if (row.IsDrawn()) return row.outcome.cell;
  Cell cell;
  cell.why = row.Note();
  if (row.note.empty() && row.outcome.is_breakdown) {
    cell.cases = cell.wrong = cell.ended = 1;
  } else {
    cell.excused = 1;
  }
  return cell;
}

void AddFact(const std::string& name, const std::string& value, Facts& facts) {
  if (!value.empty()) facts.emplace_back(name, value);
}

Facts FactsOf(const SweepRunner& runner, const Sweep& sweep, std::size_t k) {
  const SweepRow& row = sweep.rows()[k];
  Facts facts;
  if (!row.outcome.is_breakdown) AddFact("note", row.Note(), facts);
  if (!row.IsDrawn()) return facts;
  AddFact("first", FirstChange(runner, row), facts);
  for (const auto& [minimal, rows, blame] : sweep.differences()) {
    if (std::ranges::find(rows, k) == rows.end()) continue;
    AddFact("flags", ChoicesText(minimal), facts);
    AddFact("file", blame.file, facts);
    AddFact("function", blame.function, facts);
    AddFact("remark", blame.remark, facts);
  }
  return facts;
}

}  // namespace

ComparisonTable SweepTable(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed) {
  ComparisonTable table{
      .what = "builds",
      .one = "build",
      .seed = seed,
      .cases = runner.cases().size(),
      .yardsticks = {"base", "model"},
      .rows = {},
      .subjects = {{fmt::format("{}", fmt::join(runner.settings().sources, " ")), {}}}};
  std::vector<std::size_t> order(sweep.rows().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) {
    return std::pair(sweep.rows()[k].IsDrawn() ? sweep.rows()[k].group : order.size(), k);
  });
  for (const std::size_t k : order) {
    const SweepRow& row = sweep.rows()[k];
    const bool is_drawn = row.IsDrawn();
    table.rows.push_back({BuildName(row.build.choices), ChoicesText(row.build.choices),
                          is_drawn ? "group " + GroupName(row.group) : "no group",
                          is_drawn ? "These draw alike." : "These do not draw every case.",
                          FactsOf(runner, sweep, k)});
    table.subjects.front().cells.push_back(
        {CellOf(row),
         is_drawn && row.group < sweep.distances().size() ? sweep.distances()[row.group] : Cell{}});
  }
  table.subjects.front().cells.front().front().cases = table.cases;  // the base by itself
  return table;
}

}  // namespace rasterproof::lab
