// rasterproof replay: its options.
#include "tool/case/case_options.h"
#include "tool/case/cmd_case.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddReplay(CLI::App* verb, const Invocation& call) {
  static ReplayOptions options;
  options.choice.typed = call.typed;
  AddCase(verb, options.choice);
  CLI::Option* const shrink =
      verb->add_option("--shrink", options.shrink,
                       "File for the smallest case that still fails (- for standard output)");
  verb->add_option("--evaluations", options.evaluations, "Maximum evaluations while shrinking")
      ->capture_default_str()
      ->needs(shrink);
  AddAs(verb, options.as);
  return [] {
    return options.shrink.empty() ? RunReplay(options) : UntilInterrupted(RunReplay, options);
  };
}

}  // namespace

extern constinit const Verb kReplayVerb{
    "replay", VerbGroup::kEveryDay, 30,
    "Run one case again, or find a smaller one that still fails", AddReplay};

}  // namespace rasterproof::tool
