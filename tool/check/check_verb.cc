// rasterproof check: its options.
#include <cstddef>
#include <string>

#include "fmt/format.h"
#include "tool/check/cmd_check.h"
#include "tool/typed_number.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddCheck(CLI::App* verb, const Invocation& call) {
  static CheckOptions options;
  CLI::App* const given = verb->add_option_group("Given cases");
  given->add_option("scenes", options.scenes, "Scene or case files (default: generated cases)");
  given->add_option("--case", options.named, std::string(kCaseHelp))->allow_extra_args(false);
  AddSubjects(verb, options.subjects, call.own);
  verb->add_option("--property", options.properties, "Properties (default: all)");
  verb->add_option("--profile", options.profile, "Judge by this profile, not by the subject's own");
  verb->add_flag("--device", options.device,
                 "Narrow the legal set of --profile to the subject's subpixel bits, sample "
                 "locations, coordinate limit and guard band");
  verb->add_option("--save", options.save,
                   "Folder for shrunk counterexamples; those already there are replayed first");
  verb->add_flag("--no-cause", options.no_cause, "Don't explain violations (saves a few seconds)");
  verb->add_option_function<std::string>(
          "--cause-seconds",
          [](const std::string& text) {
            options.cause_seconds = ParseSeconds("--cause-seconds", text);
          },
          "Time limit for explaining violations, such as 30s or 2m: a quarter (wall clock) to "
          "draw, the rest (CPU) to compare")
      ->default_str(fmt::format("{}s", options.cause_seconds));
  verb->add_flag("--verbose", options.verbose, "Print every property, and every failure in full");
  verb->add_flag(
      "--fail-fast", options.fail_fast,
      "Stop after the first violation that fails the run; properties already running finish");
  given->excludes(verb->add_option("--cases-json", options.cases_json,
                                   "File with a JSON line per generated case: name, samples on and "
                                   "near edges, outcome"));
  AddCampaign(verb, options.campaign);
  AddListLength(verb, options.list_length);
  verb->add_option("--json", options.json,
                   "Result as JSON (- for standard output, instead of text)");
  verb->add_option("--known", options.known,
                   "Known failures with owner and expiry date; they do not fail the run");
  AddJobs(verb, options.jobs, "Properties");
  AddFailOn(verb, options.fail_on);
  AddCount(
      verb, "--batch", "Cases that share calls of a plugin or program", kMostInABatch,
      [](int count) { options.campaign.batch = static_cast<std::size_t>(count); },
      static_cast<int>(options.campaign.batch));
  return [own = call.own] {
    if (options.subjects.empty()) options.subjects = {own};
    return UntilInterrupted(RunCheck, options);
  };
}

}  // namespace

extern constinit const Verb kCheckVerb{"check", VerbGroup::kEveryDay, 10,
                                       "Test properties on generated cases or on your scenes",
                                       AddCheck};

}  // namespace rasterproof::tool
