// rasterproof climb: its options.
#include "tool/climb/cmd_climb.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddClimb(CLI::App* verb, const Invocation& /*call*/) {
  static ClimbOptions options;
  AddSubject(verb, options.subject);
  verb->add_option("--property", options.property, "Property with a bound")->capture_default_str();
  AddSeed(verb, options.seed, "search");
  verb->add_option("--evaluations", options.evaluations, "Cases to judge")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--from", options.from, "Case file to start from, besides generated cases");
  verb->add_option("-o,--output", options.output, "Case file (- for standard output)");
  return [] { return UntilInterrupted(RunClimb, options); };
}

}  // namespace

extern constinit const Verb kClimbVerb{"climb", VerbGroup::kCampaign, 40,
                                       "Search for the case with the largest error over its bound",
                                       AddClimb};

}  // namespace rasterproof::tool
