// rasterproof survey: its options.
#include "tool/survey/cmd_survey.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddSurvey(CLI::App* verb, const Invocation& call) {
  static SurveyOptions options;
  options.subject = call.own;
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Draw cases for this profile, not for the subject's own");
  AddCampaign(verb, options.campaign, "domain");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save, "Folder for the worst case of each cell that fails");
  AddJobs(verb, options.jobs, "Domains");
  return [] { return UntilInterrupted(RunSurvey, options); };
}

}  // namespace

extern constinit const Verb kSurveyVerb{
    "survey", VerbGroup::kCampaign, 20,
    "Count how a subject differs from its nearest model, without a verdict", AddSurvey};

}  // namespace rasterproof::tool
