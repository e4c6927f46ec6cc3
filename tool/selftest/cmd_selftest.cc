// rasterproof selftest: do the properties find planted bugs, and let legal variants pass?
#include "tool/selftest/cmd_selftest.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/output.h"
#include "lab/selftest/selftest.h"
#include "subjects/mutants/mutants.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

// A legal variant passes only by running to the end, three times over: a mutant seldom does.
constexpr std::uint64_t kLegalSeeds = 3;
constexpr std::uint64_t kLegalShare = 10;

std::vector<subjects::MutantInfo> Chosen(const std::vector<std::string>& only) {
  std::vector<subjects::MutantInfo> chosen;
  for (const std::string& name : only) {
    const auto found = std::ranges::find(subjects::Mutants(), name, &subjects::MutantInfo::name);
    if (found == subjects::Mutants().end()) {
      std::vector<std::string> names;
      for (const subjects::MutantInfo& one : subjects::Mutants()) names.emplace_back(one.name);
      throw InputError("--only " + name, "there is no such mutant or legal variant",
                       Suggestion(name, names) + "rasterproof list mutants names them");
    }
    chosen.push_back(*found);
  }
  return only.empty() ? subjects::Mutants() : chosen;
}

// One hunt, a subject's own.
struct Task {
  const subjects::MutantInfo& mutant;
  std::uint64_t seed;
  std::uint64_t cases;
};

std::vector<Task> TasksOf(const std::vector<subjects::MutantInfo>& chosen,
                          const SelftestOptions& options, std::uint64_t legal_cases) {
  std::vector<Task> tasks;
  for (const subjects::MutantInfo& mutant : chosen) {
    if (!mutant.legal) {
      tasks.push_back({mutant, options.seed, options.cases});
      continue;
    }
    for (std::uint64_t k = 0; k < kLegalSeeds; ++k) {
      tasks.push_back({mutant, options.seed + k, legal_cases});
    }
  }
  return tasks;
}

lab::HuntResult HuntOne(const Task& task, Progress& progress, std::size_t worker) {
  progress.Stage(fmt::format("{}, seed {}, cases", task.mutant.name, task.seed), 0, worker);
  props::CampaignOptions options;
  options.seed = task.seed;
  options.cases = task.cases;
  options.progress = [&](std::uint64_t done) { progress.Done(done, worker); };
  const std::unique_ptr<Subject> subject = MakeSubject(task.mutant.name);
  lab::HuntResult result{task.mutant, task.seed, lab::HuntBug(*subject, options)};
  progress.Stage("", 0, worker);
  return result;
}

// Hunts each mutant and explains what was found. Nothing that it prints fails the run.
int SelftestCauses(std::vector<subjects::MutantInfo> mutants, const SelftestOptions& options) {
  std::erase_if(mutants, [](const subjects::MutantInfo& mutant) { return mutant.legal; });
  std::vector<lab::CauseFound> causes(mutants.size());
  {
    Progress progress(static_cast<std::size_t>(options.jobs));
    const std::vector<std::size_t> order =
        OrderOfWork(options.jobs, mutants.size(), [](std::size_t) { return false; });
    ShareWork(options.jobs, order, [&](std::size_t worker, std::size_t k) {
      const lab::HuntResult hunted =
          HuntOne({mutants[k], options.seed, options.cases}, progress, worker);
      causes[k] = lab::FindCauseOf(hunted, [&] { return MakeSubject(mutants[k].name); });
    });
  }
  io::WriteStandardOutput(lab::CausesTable(causes));
  return kExitHolds;
}

}  // namespace

int RunSelftest(const SelftestOptions& options) {
  RequireHonestEnvironment();
  const std::vector<subjects::MutantInfo> chosen = Chosen(options.only);
  const Clock::time_point start = Clock::now();
  if (options.causes) return SelftestCauses(chosen, options);
  const std::uint64_t legal_cases = std::max<std::uint64_t>(1, options.cases / kLegalShare);
  const std::vector<Task> tasks = TasksOf(chosen, options, legal_cases);
  std::vector<lab::HuntResult> results(tasks.size());
  {
    Progress progress(static_cast<std::size_t>(options.jobs));
    // A variant runs to its end, which takes longer than to find a bug.
    const std::vector<std::size_t> order = OrderOfWork(
        options.jobs, tasks.size(), [&](std::size_t k) { return tasks[k].mutant.legal; });
    ShareWork(options.jobs, order, [&](std::size_t worker, std::size_t k) {
      results[k] = HuntOne(tasks[k], progress, worker);
    });
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  io::WriteStandardOutput(lab::SelftestText(results, options.cases, legal_cases, seconds));
  if (!options.json.empty()) io::WriteFile(options.json, lab::SelftestJson(results));
  return std::ranges::all_of(results, &lab::HuntResult::AsItShould) ? kExitHolds : kExitViolated;
}

}  // namespace rasterproof::tool
