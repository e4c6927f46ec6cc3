// rasterproof infer: its options.
#include "tool/infer/cmd_infer.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddInfer(CLI::App* verb, const Invocation& call) {
  static InferOptions options;
  options.subject = call.own;
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Verify this profile's statements, not the subject's own");
  AddSeed(verb, options.seed, "experiments");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  return [] { return RunInfer(options); };
}

}  // namespace

extern constinit const Verb kInferVerb{"infer", VerbGroup::kEveryDay, 40,
                                       "Find by experiment the model that a subject follows",
                                       AddInfer};

}  // namespace rasterproof::tool
