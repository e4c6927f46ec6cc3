// rasterproof sweep: which builds of a rasterizer draw other samples, and by which flags, file and
// function.
#include "tool/sweep/cmd_sweep.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "io/output.h"
#include "lab/sweep/sweep.h"
#include "lab/sweep/sweep_builds.h"
#include "lab/sweep/sweep_runner.h"
#include "lab/sweep/sweep_text.h"
#include "report/text.h"
#include "tool/description.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/shared_files.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

std::string Driver() {
  std::optional<std::string> driver = FindShared("kit/plugin_driver.c");
  if (!driver) {
    throw InputError("kit/plugin_driver.c", "it does not lie beside the command",
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

}  // namespace

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
              << "; mend that, or give --cflags\n";
    return kExitFault;
  }
  Progress progress(static_cast<std::size_t>(options.jobs));
  lab::Sweep sweep(runner, WorkOf(options.jobs, progress));
  sweep.Run(builds);
  if (options.json != "-")
    io::WriteStandardOutput(report::CleanText(lab::SweepText(runner, sweep, options.seed)));
  if (!options.json.empty())
    io::WriteOutput(options.json, lab::SweepJson(runner, sweep, options.seed));
  return sweep.Differing() + sweep.Stopped() == 0 ? kExitHolds : kExitViolated;
}

}  // namespace rasterproof::tool
