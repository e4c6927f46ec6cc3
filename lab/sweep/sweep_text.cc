#include "lab/sweep/sweep_text.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "core/case.h"
#include "core/drawing.h"
#include "fmt/format.h"
#include "io/json_writer.h"
#include "lab/sweep/sweep_builds.h"
#include "lab/sweep/sweep_model.h"

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

std::string BlameText(const SweepBlame& blame) {
  std::string text = blame.file.empty() ? "" : "file " + blame.file;
  if (!blame.function.empty()) text += ", function " + blame.function;
  if (blame.remark.empty()) return text;
  return blame.function.empty() ? blame.remark : text + "; " + blame.remark;
}

std::string Table(const SweepRunner& runner, const Sweep& sweep) {
  std::string text = fmt::format("{:>8} {:>6} {:<6}build\n", "samples", "cases", "group");
  for (const SweepRow& row : sweep.rows()) {
    const bool is_drawn = row.IsDrawn();
    text += fmt::format("{:>8} {:>6} {:<6}{}",
                        is_drawn ? std::to_string(row.outcome.changes.size()) : "-",
                        is_drawn ? std::to_string(row.outcome.cell.wrong) : "-",
                        is_drawn ? GroupName(row.group) : "-", BuildName(row.build.choices));
    if (const std::string note = row.Note(); !note.empty()) text += "  [" + note + "]";
    if (const std::string first = FirstChange(runner, row); is_drawn && !first.empty()) {
      text += "\n" + std::string(23, ' ') + "first: " + first;
    }
    text += "\n";
  }
  return text;
}

std::string GroupsText(const Sweep& sweep) {
  std::string text;
  for (std::size_t group = 0; group < sweep.distances().size(); ++group) {
    text += fmt::format("{}:", GroupName(group));
    std::string_view before = " ";
    std::size_t builds = 0;
    for (const SweepRow& row : sweep.rows()) {
      if (!row.IsDrawn() || row.group != group) continue;
      ++builds;
      const std::string choices = ChoicesText(row.build.choices);
      text += fmt::format("{}{}", std::exchange(before, ", "), choices.empty() ? "base" : choices);
    }
    text += fmt::format("\n   {} {}: {}\n", builds, builds == 1 ? "build" : "builds",
                        DistanceText(sweep.distances()[group]));
  }
  return text;
}

std::string DifferencesText(const Sweep& sweep) {
  std::string text;
  for (const Difference& difference : sweep.differences()) {
    text += fmt::format("{}\n  changes samples by itself, in {} of the builds above: {}\n",
                        ChoicesText(difference.minimal), difference.rows.size(),
                        BlameText(difference.blame));
  }
  return text;
}

void AddRow(io::JsonWriter& json, const SweepRunner& runner, const SweepRow& row) {
  json.BeginObject().Key("build").Text(BuildName(row.build.choices));
  json.Key("compiler").Text(ToolchainOf(row.build.choices).c);
  json.Key("changes").Text(ChoicesText(row.build.choices));
  json.Key("drawn").Bool(row.IsDrawn());
  if (row.IsDrawn()) {
    json.Key("samples").Integer(row.outcome.changes.size());
    json.Key("cases").Integer(row.outcome.cell.wrong);
    json.Key("group").Text(GroupName(row.group));
    json.Key("first").Text(FirstChange(runner, row));
  }
  json.Key("note").Text(row.Note()).EndObject();
}

void AddGroup(io::JsonWriter& json, std::size_t group, const Cell& distance) {
  json.BeginObject().Key("name").Text(GroupName(group));
  json.Key("samples").Integer(distance.samples).Key("cases").Integer(distance.cases);
  json.Key("samples_away").Integer(distance.wrong_samples);
  json.Key("cases_away").Integer(distance.wrong);
  json.Key("cases_not_judged").Integer(distance.excused);
  json.Key("why_not").Text(distance.why).EndObject();
}

}  // namespace

std::string SweepText(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed) {
  std::string text =
      Table(runner, sweep) + "\n" + GroupsText(sweep) + "\n" + DifferencesText(sweep);
  text += fmt::format("{} of {} builds draw other samples than the base in {} cases, seed {}\n",
                      sweep.Differing(), sweep.Drawn(), runner.cases().size(), seed);
  if (sweep.Stopped() != 0)
    text += fmt::format("{} builds do not draw every case\n", sweep.Stopped());
  return text;
}

std::string SweepJson(const SweepRunner& runner, const Sweep& sweep, std::uint64_t seed) {
  io::JsonWriter json;
  json.BeginObject().Key("sources").BeginArray();
  for (const std::string& source : runner.settings().sources) json.Text(source);
  json.EndArray().Key("cflags").Text(runner.settings().cflags);
  json.Key("seed").Integer(seed).Key("cases").Integer(runner.cases().size());
  json.Key("builds").BeginArray();
  for (const SweepRow& row : sweep.rows()) AddRow(json, runner, row);
  json.EndArray().Key("groups").BeginArray();
  for (std::size_t group = 0; group < sweep.distances().size(); ++group) {
    AddGroup(json, group, sweep.distances()[group]);
  }
  json.EndArray().Key("differences").BeginArray();
  for (const Difference& difference : sweep.differences()) {
    json.BeginObject().Key("flags").Text(ChoicesText(difference.minimal));
    json.Key("file").Text(difference.blame.file);
    json.Key("function").Text(difference.blame.function);
    json.Key("remark").Text(difference.blame.remark);
    json.Key("builds").BeginArray();
    for (const std::size_t row : difference.rows) {
      json.Text(BuildName(sweep.rows()[row].build.choices));
    }
    json.EndArray().EndObject();
  }
  json.EndArray().EndObject();
  return json.Finish();
}

}  // namespace rasterproof::lab
