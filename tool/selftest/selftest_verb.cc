// rasterproof selftest: do the properties find planted bugs, and let legal variants pass?
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
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
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

struct SelftestOptions {
  std::vector<std::string> only;  ///< names; empty: every mutant and legal variant
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  ///< most cases a property
  std::string json;
  int jobs = 1;         ///< mutants and variants at once
  bool causes = false;  ///< also explain each mutant's violation
};

using Clock = std::chrono::steady_clock;

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

// Runs the hunts on `jobs` threads and hands each result, with its number, to `found` there.
void ShareHunts(const std::vector<lab::HuntTask>& tasks, int jobs,
                const std::function<void(std::size_t, lab::HuntResult)>& found) {
  Progress progress(static_cast<std::size_t>(jobs));
  // A variant runs to its end, which takes longer than to find a bug.
  const std::vector<std::size_t> order =
      OrderOfWork(jobs, tasks.size(), [&](std::size_t k) { return tasks[k].mutant.legal; });
  ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
    progress.Stage(fmt::format("{}, seed {}, cases", tasks[k].mutant.name, tasks[k].seed), 0,
                   worker);
    lab::HuntResult result =
        lab::RunHunt(tasks[k], [&](std::uint64_t done) { progress.Done(done, worker); });
    progress.Stage("", 0, worker);
    found(k, std::move(result));
  });
}

// Hunts each mutant and explains what was found. Nothing that it prints fails the run.
int SelftestCauses(std::vector<subjects::MutantInfo> mutants, const SelftestOptions& options) {
  std::erase_if(mutants, [](const subjects::MutantInfo& mutant) { return mutant.legal; });
  std::vector<lab::CauseFound> causes(mutants.size());
  ShareHunts(
      lab::HuntTasks(mutants, options.seed, options.cases), options.jobs,
      [&](std::size_t k, const lab::HuntResult& hunted) { causes[k] = lab::FindCauseOf(hunted); });
  io::WriteStandardOutput(lab::CausesTable(causes));
  return kExitHolds;
}

int RunSelftest(const SelftestOptions& options) {
  RequireHonestEnvironment();
  const std::vector<subjects::MutantInfo> chosen = Chosen(options.only);
  if (options.causes) return SelftestCauses(chosen, options);
  const Clock::time_point start = Clock::now();
  const std::vector<lab::HuntTask> tasks = lab::HuntTasks(chosen, options.seed, options.cases);
  std::vector<lab::HuntResult> results(tasks.size());
  ShareHunts(tasks, options.jobs,
             [&](std::size_t k, lab::HuntResult result) { results[k] = std::move(result); });
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  io::WriteStandardOutput(lab::SelftestText(results, options.cases, seconds));
  if (!options.json.empty()) io::WriteFile(options.json, lab::SelftestJson(results));
  return std::ranges::all_of(results, &lab::HuntResult::AsItShould) ? kExitHolds : kExitViolated;
}

Run AddSelftest(CLI::App* verb, const Invocation& /*call*/) {
  static SelftestOptions options;
  AddSeed(verb, options.seed, "generators (legal variants take the next two as well)");
  verb->add_option("--cases", options.cases,
                   "Maximum cases per property; legal variants get a tenth")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--only", options.only, "Mutants and legal variants (default: all)");
  verb->add_option("--json", options.json, "Result as JSON");
  verb->add_flag("--causes", options.causes,
                 "Explain each mutant's violation and compare with its planted bug");
  AddJobs(verb, options.jobs, "Mutants or legal variants");
  return [] { return RunSelftest(options); };
}

}  // namespace

extern constinit const Verb kSelftestVerb{
    "selftest", VerbGroup::kDevelopment, 20,
    "Check that planted bugs are found and legal variants pass", AddSelftest};

}  // namespace rasterproof::tool
