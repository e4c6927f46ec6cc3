// rasterproof sweep: which builds of a rasterizer draw other samples, and by which flags, file and
// function.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "core/comparison.h"
#include "core/error.h"
#include "io/output.h"
#include "lab/sweep/sweep.h"
#include "lab/sweep/sweep_builds.h"
#include "lab/sweep/sweep_runner.h"
#include "lab/sweep/sweep_table.h"
#include "report/comparison.h"
#include "report/text.h"
#include "tool/compare/comparison.h"
#include "tool/description.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/shared_files.h"
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

// Builds of a rasterizer by several compilers and flags.
struct SweepOptions {
  std::vector<std::string> sources;
  std::string cflags;               ///< words of a shell, for every build
  std::vector<std::string> builds;  ///< builds to compare with the base; empty: the usual list
  std::string profile;
  std::uint64_t seed = 1;
  std::uint64_t cases = 200;
  double seconds = 30;  ///< of one compilation, or of one answer
  std::string json;     ///< file; empty: none
  int jobs = 1;         ///< builds at once
};

std::string Driver() {
  std::optional<std::string> driver = FindShared("kit/plugin_driver.c");
  if (!driver) {
    throw InputError("kit/plugin_driver.c", "it is missing beside the command",
                     "run the command where it was built");
  }
  return *driver;
}

// On `jobs` threads, with progress.
lab::SweepWork WorkOf(int jobs, Progress& progress) {
  return {.share =
              [jobs, &progress](const std::string& what, std::size_t first, std::size_t count,
                                const std::function<void(std::size_t)>& work) {
                std::vector<std::size_t> order(count);
                std::iota(order.begin(), order.end(), first);
                progress.Stage(what, count);
                std::atomic<std::uint64_t> done = 0;
                ShareWork(jobs, order, [&](std::size_t, std::size_t i) {
                  work(i);
                  progress.Done(++done);
                });
              },
          .stop = Interrupted};
}

int RunSweep(const SweepOptions& options) {
  RequireHonestEnvironment();
  io::RequireFileCanBe(options.json);
  std::vector<lab::SweepBuild> builds;
  for (const std::string& words : options.builds)
    builds.push_back(lab::BuildFrom(words, options.cflags));
  lab::SweepRunner runner({options.sources, options.cflags, options.seconds, Driver(),
                           [](const std::string& text, const std::string& place) {
                             return ParseDescription(text, place).info;
                           }});
  try {
    runner.DrawBase(options.seed, options.cases, options.profile);
  } catch (const lab::BuildFailure& failure) {
    std::cerr << "rasterproof: " << report::CleanText(lab::BuildName({}))
              << ": the base is not built: " << report::CleanText(failure.what())
              << "; correct it, or give --cflags\n";
    return kExitFault;
  }
  Progress progress(static_cast<std::size_t>(options.jobs));
  lab::Sweep sweep(runner, WorkOf(options.jobs, progress));
  sweep.Run(builds);
  const ComparisonTable table = lab::SweepTable(runner, sweep, options.seed);
  TellNewest(table, {}, options.json, "");
  if (!options.json.empty()) io::WriteOutput(options.json, report::ComparisonToJson(table));
  const auto fails = [](const std::vector<Cell>& cells) { return cells.front().Fails(); };
  return std::ranges::any_of(table.subjects.front().cells, fails) ? kExitViolated : kExitHolds;
}

Run AddSweep(CLI::App* verb, const Invocation& /*call*/) {
  static SweepOptions options;
  verb->add_option("sources", options.sources,
                   "C or C++ sources of a plugin (kit/rasterproof_plugin.h)")
      ->required();
  verb->add_option("--cflags", options.cflags,
                   "Flags for every build, in shell syntax: -I, -D, -std, libraries");
  verb->add_option("--build", options.builds,
                   "Compare only this build with the base: \"clang -O3\", \"i386\", \"aarch64 "
                   "-ffp-contract=fast\" (repeatable; default: about 40)")
      ->allow_extra_args(false);
  verb->add_option("--profile", options.profile, "Draw cases for this profile, not for its own");
  AddSeed(verb, options.seed);
  verb->add_option("--cases", options.cases, "Cases that every build draws")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  verb->add_option("--time-limit", options.seconds,
                   "Time limit in seconds for a compilation or an answer")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  AddJobs(verb, options.jobs, "Builds");
  return [] { return UntilInterrupted(RunSweep, options); };
}

}  // namespace

extern constinit const Verb kSweepVerb{
    "sweep", VerbGroup::kCampaign, 50,
    "Find the builds (compilers, flags, targets) that change what your rasterizer covers",
    AddSweep};

}  // namespace rasterproof::tool
