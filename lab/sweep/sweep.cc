#include "lab/sweep/sweep.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/call_end.h"
#include "fmt/format.h"
#include "lab/sweep/sweep_delta.h"
#include "lab/sweep/sweep_model.h"
#include "props/compare/compare.h"

namespace rasterproof::lab {
namespace {

// The cases by which files and functions are told apart.
constexpr std::size_t kMostCasesOfBlame = 20;
constexpr const char* kNotReached = "the command was interrupted before";

}  // namespace

std::string SweepRow::Note() const {
  std::string text = note.empty() ? outcome.failure : note;
  const auto is_emulated = [](const Choice& c) { return c.value == "aarch64"; };
  if (!std::ranges::any_of(build.choices, is_emulated)) return text;
  return text.empty() ? "emulated" : "emulated: " + text;
}

Sweep::Sweep(SweepRunner& runner, SweepWork work) : runner_(runner), work_(std::move(work)) {}

void Sweep::Run(const std::vector<SweepBuild>& builds) {
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

void Sweep::InParallel(std::size_t first, std::size_t count, const std::string& what,
                       const std::function<void(std::size_t)>& work) {
  work_.share(what, first, count, [&](std::size_t i) {
    try {
      if (!work_.stop()) work(i);
    } catch (const SubjectStop&) {
      if (!work_.stop()) throw;
    }
  });
}

void Sweep::Add(const std::vector<SweepBuild>& builds) {
  const std::size_t first = rows_.size();
  for (const SweepBuild& build : builds) rows_.push_back({build, {}, kNotReached});
  InParallel(first, builds.size(), fmt::format("{} builds", builds.size()), [&](std::size_t i) {
    SweepRow& row = rows_[i];
    std::string missing = WhatIsMissing(row.build.choices, runner_.has_cxx());
    if (missing.empty()) row.outcome = runner_.OutcomeOf(row.build.choices);
    if (work_.stop()) return;
    row.note = std::move(missing);
    AddWhereToFind(row);
  });
}

// Headers and libraries of 32 bits are packages of their own.
void Sweep::AddWhereToFind(SweepRow& row) const {
  SweepOutcome& outcome = row.outcome;
  const auto is_i386 = [](const Choice& c) { return c.value == "i386"; };
  if (!row.note.empty() || outcome.HasDrawn() || outcome.is_breakdown) return;
  outcome.failure = "not built: " + outcome.failure;
  if (std::ranges::any_of(row.build.choices, is_i386)) {
    outcome.failure += runner_.has_cxx()
                           ? "; package g++-multilib has what builds for 32 bits need"
                           : "; packages libc6-dev-i386 and lib32gcc-12-dev have what builds for "
                             "32 bits need";
  }
}

void Sweep::Group() {
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

void Sweep::FindDistances() {
  const std::size_t cases = runner_.cases().size();
  std::vector<props::Judging> models(cases, {kNotReached});
  InParallel(0, cases, "the model of each case",
             [&](std::size_t k) { models[k] = ModelOfCase(runner_.info(), runner_.cases()[k]); });
  for (const std::size_t row : first_rows_) {
    distances_.push_back(DistanceFromModel(runner_, rows_[row].outcome, models));
  }
}

// Differing builds, of those that change the same axes and draw alike the first alone.
std::vector<SweepBuild> Sweep::Representatives() const {
  std::vector<SweepBuild> builds;
  std::set<std::pair<std::vector<std::string>, std::size_t>> seen;
  for (const SweepRow& row : rows_) {
    if (!row.IsDrawn() || !row.Differs()) continue;
    if (seen.emplace(row.build.axes, row.group).second) builds.push_back(row.build);
  }
  return builds;
}

Choices Sweep::MinimalOf(const Choices& choices) {
  const std::function<bool(const Choices&)> changes = [this](const Choices& part) {
    return !part.empty() && !runner_.OutcomeOf(part).changes.empty();
  };
  for (const Choices& finer : FinerChoices(choices)) {
    if (changes(finer)) return MinimalPart(finer, changes);
  }
  return choices;
}

void Sweep::FindDifferences() {
  std::vector<std::size_t> differing;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].IsDrawn() && rows_[i].Differs()) differing.push_back(i);
  }
  std::vector<Choices> minimal(differing.size());
  InParallel(0, differing.size(), "flags of each difference",
             [&](std::size_t i) { minimal[i] = MinimalOf(rows_[differing[i]].build.choices); });
  if (work_.stop()) return;
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

std::vector<std::size_t> Sweep::CasesOf(const Choices& minimal) {
  std::vector<std::size_t> cases;
  for (const ChangedSample& change : runner_.OutcomeOf(minimal).changes) {
    if (!cases.empty() && cases.back() == change.number_of_case) continue;
    if (cases.size() == kMostCasesOfBlame) break;
    cases.push_back(change.number_of_case);
  }
  return cases;
}

std::size_t Sweep::Drawn() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows_, &SweepRow::IsDrawn));
}

std::size_t Sweep::Differing() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      rows_, [](const SweepRow& row) { return row.IsDrawn() && row.Differs(); }));
}

std::size_t Sweep::Stopped() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      rows_, [](const SweepRow& row) { return row.note.empty() && row.outcome.is_breakdown; }));
}

}  // namespace rasterproof::lab
