// rasterproof sweep: which builds of a rasterizer draw other samples, and by which flags, file and
// function.
#include "tool/sweep/cmd_sweep.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "fmt/format.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "report/text.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/sweep/sweep_blame.h"
#include "tool/sweep/sweep_builds.h"
#include "tool/sweep/sweep_delta.h"
#include "tool/sweep/sweep_model.h"
#include "tool/sweep/sweep_runner.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

// The cases by which files and functions are told apart.
constexpr std::size_t kMostCasesOfBlame = 20;
constexpr const char* kNotReached = "the command was interrupted before";

struct SweepRow {
  SweepBuild build;
  SweepOutcome outcome;
  std::string note;
  std::size_t group = 0;  ///< of builds that draw alike, from 0: the base's; meaningless otherwise

  bool IsDrawn() const { return note.empty() && outcome.HasDrawn(); }
  bool Differs() const { return note.empty() && outcome.Differs(); }
  std::string Note() const {
    std::string text = note.empty() ? outcome.failure : note;
    const auto is_emulated = [](const Choice& c) { return c.value == "aarch64"; };
    if (!std::ranges::any_of(build.choices, is_emulated)) return text;
    return text.empty() ? "emulated" : "emulated: " + text;
  }
};

// What makes some of the rows differ.
struct Difference {
  Choices minimal;
  std::vector<std::size_t> rows;
  SweepBlame blame;
};

class Sweep {
 public:
  Sweep(SweepRunner& runner, int jobs)
      : runner_(runner), jobs_(jobs), progress_(static_cast<std::size_t>(jobs)) {}

  /// Builds the given ones; or the usual list, and pairs of those that differ.
  void Run(const std::vector<SweepBuild>& builds) {
    rows_.push_back({});  // the base
    Add(builds.empty() ? SingleBuilds() : builds);
    Group();
    if (builds.empty()) {
      Add(PairsOf(Representatives()));
      Group();
    }
    FindDistances();
    FindDifferences();
  }

  const std::vector<SweepRow>& rows() const { return rows_; }
  const std::vector<Difference>& differences() const { return differences_; }
  /// Of each group from the model; the base's is the first.
  const std::vector<Cell>& distances() const { return distances_; }

 private:
  void InParallel(std::size_t first, std::size_t count, const std::string& what,
                  const std::function<void(std::size_t)>& work) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), first);
    progress_.Stage(what, count);
    std::atomic<std::uint64_t> done = 0;
    ShareWork(jobs_, order, [&](std::size_t, std::size_t i) {
      try {
        if (!Interrupted()) work(i);
      } catch (const SubjectStop&) {
        if (!Interrupted()) throw;
      }
      progress_.Done(++done);
    });
  }

  void Add(const std::vector<SweepBuild>& builds) {
    const std::size_t first = rows_.size();
    for (const SweepBuild& build : builds) rows_.push_back({build, {}, kNotReached});
    InParallel(first, builds.size(), fmt::format("{} builds", builds.size()), [&](std::size_t i) {
      SweepRow& row = rows_[i];
      std::string missing = WhatIsMissing(row.build.choices, runner_.has_cxx());
      if (missing.empty()) row.outcome = runner_.OutcomeOf(row.build.choices);
      if (Interrupted()) return;
      row.note = std::move(missing);
      AddWhereToFind(row);
    });
  }

  // Headers and libraries of 32 bits are packages of their own.
  void AddWhereToFind(SweepRow& row) const {
    SweepOutcome& outcome = row.outcome;
    const auto is_i386 = [](const Choice& c) { return c.value == "i386"; };
    if (!row.note.empty() || outcome.HasDrawn() || outcome.is_breakdown) return;
    outcome.failure = "not built: " + outcome.failure;
    if (std::ranges::any_of(row.build.choices, is_i386)) {
      outcome.failure +=
          runner_.has_cxx()
              ? "; builds for 32 bits need package g++-multilib"
              : "; builds for 32 bits need packages libc6-dev-i386 and lib32gcc-12-dev";
    }
  }

  void Group() {
    std::vector<std::size_t> first_rows;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!rows_[i].IsDrawn()) continue;
      const auto same = std::ranges::find_if(first_rows, [&](std::size_t k) {
        return rows_[k].outcome.changes == rows_[i].outcome.changes;
      });
      rows_[i].group = static_cast<std::size_t>(same - first_rows.begin());
      if (same == first_rows.end()) first_rows.push_back(i);
    }
    first_rows_ = first_rows;
  }

  void FindDistances() {
    const std::size_t cases = runner_.cases().size();
    std::vector<props::Judging> models(cases, {kNotReached});
    InParallel(0, cases, "the model of each case",
               [&](std::size_t k) { models[k] = ModelOfCase(runner_.info(), runner_.cases()[k]); });
    for (const std::size_t row : first_rows_) {
      distances_.push_back(DistanceFromModel(runner_, rows_[row].outcome, models));
    }
  }

  // Differing builds, of those that change the same axes and draw alike the first alone.
  std::vector<SweepBuild> Representatives() const {
    std::vector<SweepBuild> builds;
    std::set<std::pair<std::vector<std::string>, std::size_t>> seen;
    for (const SweepRow& row : rows_) {
      if (!row.IsDrawn() || !row.Differs()) continue;
      if (seen.emplace(row.build.axes, row.group).second) builds.push_back(row.build);
    }
    return builds;
  }

  Choices MinimalOf(const Choices& choices) {
    const std::function<bool(const Choices&)> changes = [this](const Choices& part) {
      return !part.empty() && !runner_.OutcomeOf(part).changes.empty();
    };
    for (const Choices& finer : FinerChoices(choices)) {
      if (changes(finer)) return MinimalPart(finer, changes);
    }
    return choices;
  }

  void FindDifferences() {
    std::vector<std::size_t> differing;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].IsDrawn() && rows_[i].Differs()) differing.push_back(i);
    }
    std::vector<Choices> minimal(differing.size());
    InParallel(0, differing.size(), "flags of each difference",
               [&](std::size_t i) { minimal[i] = MinimalOf(rows_[differing[i]].build.choices); });
    if (Interrupted()) return;
    std::map<Choices, std::size_t> known;
    for (std::size_t i = 0; i < differing.size(); ++i) {
      const auto [at, is_new] = known.emplace(minimal[i], differences_.size());
      if (is_new) differences_.push_back({minimal[i], {}, {"", "", kNotReached}});
      differences_[at->second].rows.push_back(differing[i]);
    }
    InParallel(0, differences_.size(), "file and function of each difference", [&](std::size_t i) {
      Difference& difference = differences_[i];
      difference.blame = Blame(runner_, difference.minimal, CasesOf(difference.minimal));
    });
  }

  std::vector<std::size_t> CasesOf(const Choices& minimal) {
    std::vector<std::size_t> cases;
    for (const ChangedSample& change : runner_.OutcomeOf(minimal).changes) {
      if (!cases.empty() && cases.back() == change.number_of_case) continue;
      if (cases.size() == kMostCasesOfBlame) break;
      cases.push_back(change.number_of_case);
    }
    return cases;
  }

  SweepRunner& runner_;
  int jobs_;
  Progress progress_;
  std::vector<SweepRow> rows_;
  std::vector<Difference> differences_;
  std::vector<std::size_t> first_rows_;  ///< of each group
  std::vector<Cell> distances_;
};

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

std::string Json(const SweepRunner& runner, const Sweep& sweep, const SweepOptions& options) {
  io::JsonWriter json;
  json.BeginObject().Key("sources").BeginArray();
  for (const std::string& source : options.sources) json.Text(source);
  json.EndArray().Key("cflags").Text(options.cflags);
  json.Key("seed").Integer(options.seed).Key("cases").Integer(options.cases);
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

}  // namespace

int RunSweep(const SweepOptions& options) {
  RequireHonestEnvironment();
  io::RequireFileCanBe(options.json);
  std::vector<SweepBuild> builds;
  for (const std::string& words : options.builds)
    builds.push_back(BuildFrom(words, options.cflags));
  SweepRunner runner({options.sources, options.cflags, options.seconds});
  try {
    runner.DrawBase(options.seed, options.cases, options.profile);
  } catch (const BuildFailure& failure) {
    std::cerr << "rasterproof: " << report::CleanText(BuildName({}))
              << ": the base is not built: " << report::CleanText(failure.what())
              << "; correct it, or give --cflags\n";
    return kExitFault;
  }
  Sweep sweep(runner, options.jobs);
  sweep.Run(builds);
  const auto is_drawn = [](const SweepRow& row) { return row.IsDrawn(); };
  const auto is_stopped = [](const SweepRow& row) {
    return row.note.empty() && row.outcome.is_breakdown;
  };
  const auto differs = [](const SweepRow& row) { return row.IsDrawn() && row.Differs(); };
  const auto drawn = std::ranges::count_if(sweep.rows(), is_drawn);
  const auto differing = std::ranges::count_if(sweep.rows(), differs);
  const auto stopped = std::ranges::count_if(sweep.rows(), is_stopped);
  std::string summary =
      fmt::format("{} of {} builds draw different samples than the base in {} cases, seed {}\n",
                  differing, drawn, options.cases, options.seed);
  if (stopped != 0) summary += fmt::format("{} builds do not draw every case\n", stopped);
  if (options.json != "-") {
    io::WriteStandardOutput(report::CleanText(Table(runner, sweep) + "\n" + GroupsText(sweep) +
                                              "\n" + DifferencesText(sweep) + summary));
  }
  if (!options.json.empty()) io::WriteOutput(options.json, Json(runner, sweep, options));
  return differing + stopped == 0 ? kExitHolds : kExitViolated;
}

}  // namespace rasterproof::tool
