// rasterproof compare: its options.
#include "tool/compare/cmd_compare.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddCompare(CLI::App* verb, const Invocation& call) {
  static CompareOptions options;
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
  AddSubjects(verb, options.subjects, call.own);
  verb->add_option("--profile", options.profile, "Judge by this profile, not by the subject's own");
  verb->add_flag("--device", options.device, "As in check");
  AddCampaign(verb, options.campaign, "family");
  AddListLength(verb, options.list_length);
  verb->add_option("--save", options.save, "Folder for the worst case of each cell that fails");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  AddFailOn(verb, options.fail_on);
  AddJobs(verb, options.jobs, "Families");
  return [own = call.own] {
    if (options.subjects.empty()) options.subjects = {own};
    return UntilInterrupted(RunCompare, options);
  };
}

}  // namespace

extern constinit const Verb kCompareVerb{
    "compare", VerbGroup::kCampaign, 10,
    "Compare a subject on families of stiff cases with models, subjects or itself", AddCompare};

}  // namespace rasterproof::tool
