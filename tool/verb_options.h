// What verbs' options share. Seen by the three files that parse, and by none else: CLI11 costs
// about ten seconds a file.
#ifndef RASTERPROOF_TOOL_VERB_OPTIONS_H_
#define RASTERPROOF_TOOL_VERB_OPTIONS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "CLI/CLI.hpp"
#include "props/run/campaign_options.h"
#include "subjects/process/groups.h"
#include "tool/interrupt.h"

namespace rasterproof::tool {

/// Runs the command after its options are parsed.
using Run = std::function<int()>;

/// A number above 0.
CLI::Validator Positive();

/// Adds --plugin and --exec, two more ways to name subjects, and what those may cost.
void AddOutside(CLI::App* app, const std::function<void(const std::string&)>& add);

/// Adds --subject, --plugin and --exec.
void AddSubject(CLI::App* app, std::string& subject, const std::string& help = "Subject");

/// Adds --seed.
void AddSeed(CLI::App* app, std::uint64_t& seed, const std::string& of = "generators");

/// Adds --seconds.
void AddSeconds(CLI::App* app, props::CampaignOptions& campaign, const std::string& of);

/// Adds --seed, --cases and --seconds.
void AddCampaign(CLI::App* app, props::CampaignOptions& campaign,
                 const std::string& of = "property");

/// Adds --list-length.
void AddListLength(CLI::App* app, std::size_t& length);

/// Adds an option of a number from 1 to `most`.
void AddCount(CLI::App* app, const std::string& option, const std::string& help, int most,
              const std::function<void(int)>& take, int usual);

/// Adds --jobs, for as many of `what` at once.
void AddJobs(CLI::App* app, int& jobs, const std::string& what);

inline constexpr std::string_view kCaseHelp =
    "Drawn case, by its name DOMAIN:INDEX@SEED (near-edge:17@1)";

/// Runs a verb that prints its results so far when interrupted. Other verbs end at once,
/// as programs do.
template <typename Options>
int UntilInterrupted(int (*verb)(const Options&), const Options& options) {
  CatchInterrupts(subjects::Interrupt);
  const int status = verb(options);
  return Interrupted() ? InterruptStatus() : status;
}

/// Adds check, whose subject is `own` unless one is named.
void AddCheck(CLI::App& app, Run& run, const std::string& own);

/// Adds compare, whose subject is `own` unless one is named.
void AddCompare(CLI::App& app, Run& run, const std::string& own);

/// Adds certify, whose subject is `own` unless one is named.
void AddCertify(CLI::App& app, Run& run, const std::string& own);

/// Adds pipe answer.
void AddPipeVerb(CLI::App& app, Run& run);

/// Adds vectors generate and verify.
void AddVectorsVerb(CLI::App& app, Run& run);

/// Adds widths.
void AddWidthsVerb(CLI::App& app, Run& run);

/// Adds the verbs that take one scene: coverage, legal, plan.
void AddSceneVerbs(CLI::App& app, Run& run);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_VERB_OPTIONS_H_
