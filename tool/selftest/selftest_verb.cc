// rasterproof selftest: its options.
#include "tool/selftest/cmd_selftest.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

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
