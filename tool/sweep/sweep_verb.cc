// rasterproof sweep: its options.
#include "tool/sweep/cmd_sweep.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

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
