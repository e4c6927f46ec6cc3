// The options of check, compare and certify: the verbs that put subjects to the test.
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "CLI/CLI.hpp"
#include "core/authority.h"
#include "fmt/format.h"
#include "tool/certify/cmd_certify.h"
#include "tool/certify/passport.h"
#include "tool/certify/shard.h"
#include "tool/check/cmd_check.h"
#include "tool/compare/cmd_compare.h"
#include "tool/typed_number.h"
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

void AddSubjects(CLI::App* app, std::vector<std::string>& subjects, const std::string& own) {
  app->add_option("--subject", subjects, "Subjects")->default_str(own);
  AddOutside(app, [&subjects](const std::string& name) { subjects.push_back(name); });
}

void AddFailOn(CLI::App* verb, FailOn& fail_on) {
  verb->add_option("--fail-on", fail_on, "Violations that fail: of what is stated, or of quality")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, FailOn>{{"stated", FailOn::kStated},
                                                                {"quality", FailOn::kQuality}})
              .description("{stated,quality}"))
      ->default_str("stated");
}

}  // namespace

void AddCount(CLI::App* app, const std::string& option, const std::string& help, int most,
              const std::function<void(int)>& take, int usual) {
  const auto parse = [=](const std::string& text) { take(ParseCount(option, text, most)); };
  app->add_option_function<std::string>(option, parse, help)
      ->type_name("COUNT")
      ->default_str(std::to_string(usual));
}

void AddJobs(CLI::App* app, int& jobs, const std::string& what) {
  jobs = DefaultJobs();
  AddCount(
      app, "--jobs", what + " at once (default: one per core)", kMostJobs,
      [&jobs](int count) { jobs = count; }, jobs);
}

void AddCheck(CLI::App& app, Run& run, const std::string& own) {
  static CheckOptions options;
  CLI::App* verb =
      app.add_subcommand("check", "Test properties on generated cases or on your scenes");
  CLI::App* const given = verb->add_option_group("Given cases");
  given->add_option("scenes", options.scenes, "Scene or case files (default: generated cases)");
  given->add_option("--case", options.named, std::string(kCaseHelp))->allow_extra_args(false);
  AddSubjects(verb, options.subjects, own);
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
  verb->callback([&run, own] {
    if (options.subjects.empty()) options.subjects = {own};
    run = [] { return UntilInterrupted(RunCheck, options); };
  });
}

void AddCompare(CLI::App& app, Run& run, const std::string& own) {
  static CompareOptions options;
  CLI::App* verb = app.add_subcommand(
      "compare", "Compare a subject on families of stiff cases with models, subjects or itself");
  CLI::App* const by_models = verb->add_option_group("Cases by yardsticks");
  by_models->add_option("scenes", options.scenes, "Scene files or meshes (default: all families)");
  by_models
      ->add_option("--families", options.families,
                   "Families of cases, domains and small worlds, beside the scenes (default: all)")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->allow_extra_args(false);
  by_models
      ->add_option("--by", options.by,
                   "Yardsticks: own (the model it is judged by), real (real geometry), or other "
                   "subjects")
      ->delimiter(',')
      ->type_name("own,real,SUBJECT")
      ->default_str("own,real")
      ->allow_extra_args(false);
  by_models->excludes(
      verb->add_option("--mode", options.modes,
                       "Compare it with itself in these floating-point modes of its caller, on the "
                       "cases of EnvironmentKeepsCoverage")
          ->delimiter(',')
          ->type_name("ftz,daz,up,down,zero,trap")
          ->allow_extra_args(false));
  AddSubjects(verb, options.subjects, own);
  verb->add_option("--profile", options.profile, "Judge by this profile, not by the subject's own");
  verb->add_flag("--device", options.device, "As in check");
  AddCampaign(verb, options.campaign, "family");
  AddListLength(verb, options.list_length);
  verb->add_option("--save", options.save, "Folder for the worst case of each cell that fails");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  AddFailOn(verb, options.fail_on);
  AddJobs(verb, options.jobs, "Families");
  verb->callback([&run, own] {
    if (options.subjects.empty()) options.subjects = {own};
    run = [] { return UntilInterrupted(RunCompare, options); };
  });
}

void AddCertify(CLI::App& app, Run& run, const std::string& own) {
  static CertifyOptions options;
  options.campaign.cases = 100;
  CLI::App* verb =
      app.add_subcommand("certify", "Test everything: certificate, JUnit file and report page");
  AddSubjects(verb, options.subjects, own);
  CLI::App* const of_a_run = verb->add_option_group("Cases to run");
  CLI::Option* const all = of_a_run->add_flag(
      "--all", options.all,
      "Every built-in subject; the exit status then covers only those that claim to be exact");
  verb->add_option("--profile", options.profile, "Judge by this profile, not by the subject's own")
      ->excludes(all);
  verb->add_option("--scenes", options.scene_set, "Scene set to measure")
      ->default_str("scenes/certify.json beside the command");
  verb->add_option("-o,--out", options.output, "Folder")->capture_default_str();
  verb->add_option("--bench", options.bench,
                   "File of bench --json: begins the page with error against run time");
  verb->add_option("--survey", options.survey, "Folder of survey --json files to show on the page");
  verb->add_flag("--catalogue", options.catalogue,
                 "Add the families of stiff cases: a matrix, a page per family, catalogue.json");
  verb->add_option("--browser", options.browser,
                   "Address of the browser's page, in which failures open")
      ->default_str("a copy beside the report, if the page is installed");
  AddSeed(of_a_run, options.campaign.seed);
  of_a_run
      ->add_option_function<std::string>(
          "--cases", [](const std::string& text) { ParseCases(text, options); },
          "Cases per property; A..B: only cases A to B - 1, as a part for --merge")
      ->default_str("100");
  AddSeconds(of_a_run, options.campaign, "property");
  of_a_run->add_option("--shard", options.shard,
                       "Run only this shard, as a part for --merge: I/N, or auto (read the "
                       "variables of GoogleTest, Slurm arrays or Open MPI)");
  of_a_run
      ->add_option("--exhaustive", options.worlds,
                   "Also run every case of this small world ('list worlds' names them)")
      ->allow_extra_args(false);
  AddJobs(verb, options.jobs, "Properties, worlds or scenes");
  AddFailOn(verb, options.fail_on);
  of_a_run->excludes(verb->add_option("--merge", options.parts,
                                      "Merge these files of --shard or --cases A..B into the "
                                      "campaign's certificate"));
  of_a_run->excludes(verb->add_option("PASSPORT", options.passport,
                                      "Certificate of a page that judged a GPU: derive its verdict "
                                      "again from the answers in it"));
  verb->callback([&run, own] {
    if (!options.passport.empty()) {
      run = [] { return RunPassport(options.passport); };
      return;
    }
    if (options.subjects.empty() && options.parts.empty()) options.subjects = {own};
    run = [] { return UntilInterrupted(options.parts.empty() ? RunCertify : RunMerge, options); };
  });
}

}  // namespace rasterproof::tool
