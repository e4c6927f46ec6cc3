// rasterproof certify: its options.
#include <string>

#include "tool/certify/cmd_certify.h"
#include "tool/certify/passport.h"
#include "tool/certify/shard.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddCertify(CLI::App* verb, const Invocation& call) {
  static CertifyOptions options;
  options.campaign.cases = 100;
  AddSubjects(verb, options.subjects, call.own);
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
  return [own = call.own] {
    if (!options.passport.empty()) return RunPassport(options.passport);
    if (!options.parts.empty()) return UntilInterrupted(RunMerge, options);
    if (options.subjects.empty()) options.subjects = {own};
    return UntilInterrupted(RunCertify, options);
  };
}

}  // namespace

extern constinit const Verb kCertifyVerb{"certify", VerbGroup::kEveryDay, 50,
                                         "Test everything: certificate, JUnit file and report page",
                                         AddCertify};

}  // namespace rasterproof::tool
