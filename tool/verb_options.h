// What verbs' options share. Seen by the verbs' files NAME_verb.cc, and by none else: CLI11 costs
// about ten seconds a file.
#ifndef RASTERPROOF_TOOL_VERB_OPTIONS_H_
#define RASTERPROOF_TOOL_VERB_OPTIONS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "CLI/CLI.hpp"
#include "core/authority.h"
#include "props/run/campaign_options.h"
#include "subjects/process/groups.h"
#include "tool/interrupt.h"
#include "tool/verb.h"

namespace rasterproof::tool {

/// A number above 0.
CLI::Validator Positive();

/// Adds an option of a number from 1 to `most`.
void AddCount(CLI::App* app, const std::string& option, const std::string& help, int most,
              const std::function<void(int)>& take, int usual);

/// Adds --jobs, for as many of `what` at once.
void AddJobs(CLI::App* app, int& jobs, const std::string& what);

/// Adds --subject, --plugin and --exec, and what the last two may cost.
void AddSubject(CLI::App* app, std::string& subject, const std::string& help = "Subject");

/// The same for several subjects; without one it is `own`, which the verb sees to.
void AddSubjects(CLI::App* app, std::vector<std::string>& subjects, const std::string& own);

/// Adds --seed.
void AddSeed(CLI::App* app, std::uint64_t& seed, const std::string& of = "generators");

/// Adds --seconds.
void AddSeconds(CLI::App* app, props::CampaignOptions& campaign, const std::string& of);

/// Adds --seed, --cases and --seconds.
void AddCampaign(CLI::App* app, props::CampaignOptions& campaign,
                 const std::string& of = "property");

/// Adds --list-length.
void AddListLength(CLI::App* app, std::size_t& length);

/// Adds --fail-on.
void AddFailOn(CLI::App* app, FailOn& fail_on);

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

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_VERB_OPTIONS_H_
