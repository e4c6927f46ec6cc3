// rasterproof pipe: its options.
#include <string>
#include <vector>

#include "core/float_mode.h"
#include "tool/outside.h"
#include "tool/subject_kinds.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

void AddFloatMode(CLI::App* app, const std::string& option, FloatModeOfHost::Where where,
                  const std::string& help, FloatModeOfHost& float_mode) {
  app->add_option_function<std::string>(
         option,
         [where, &float_mode](const std::string& name) {
           float_mode = {FindFloatMode(name).value_or(FloatMode::kUsual), where};
         },
         help)
      ->check(
          CLI::IsMember(std::vector<std::string>{kFloatModeNames.begin(), kFloatModeNames.end()}));
}

Run AddPipe(CLI::App* verb, const Invocation& /*call*/) {
  static HostOptions host;
  verb->require_subcommand(1);
  CLI::App* answer = verb->add_subcommand("answer", "Answer requests with a plugin");
  answer->add_option("subject", host.subject, "plugin:PATH")->required();
  answer->add_flag("--describe", host.describe, "Print only its description");
  AddFloatMode(answer, "--fp-env", FloatModeOfHost::Where::kFromTheStart,
               "Floating-point mode in which the plugin is loaded and called", host.float_mode);
  AddFloatMode(answer, "--fp-env-of-workers", FloatModeOfHost::Where::kInOtherThreads,
               "Floating-point mode of the plugin's own threads, before each call",
               host.float_mode);
  return [] { return HostSubject(host); };
}

}  // namespace

extern constinit const Verb kPipeVerb{
    "pipe", VerbGroup::kCampaign, 60,
    "Answer requests on a pipe by a library: pipe answer plugin:PATH", AddPipe};

}  // namespace rasterproof::tool
