// rasterproof climb: the case in which a result is as wrong as a search can make it.
#include <cstdint>
#include <optional>
#include <string>

#include "core/case.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "lab/climb/climb.h"
#include "report/text.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"
#include "tool/shared_files.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

// A search for the largest error over its bound.
struct ClimbOptions {
  std::string subject = "f32-direct";
  std::string property = "EdgeErrorStaysWithinItsBound";
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 20'000;
  std::string from;    ///< a case file to start from as well; empty: only drawn cases
  std::string output;  ///< file; empty: none
};

std::optional<Case> CaseToSetOutFrom(const std::string& path, const Subject& subject) {
  if (path.empty()) return std::nullopt;
  Case from = io::ReadCase(Located(path)).value;
  if (!Takes(subject.Info(), from.scene) || !WithinLimits(from.scene, from.profile)) {
    throw InputError("--from " + path, "the subject does not take this scene",
                     "give a case of its precision and size");
  }
  return from;
}

int RunClimb(const ClimbOptions& options) {
  RequireHonestEnvironment();
  const auto subject = MakeSubject(options.subject);
  const props::Property& property = RequireProperty(options.property);
  lab::Climbed found;
  {
    Progress progress;
    progress.Stage("climb", options.evaluations);
    found = lab::ClimbRatio(*subject, property,
                            {.seed = options.seed,
                             .evaluations = options.evaluations,
                             .from = CaseToSetOutFrom(options.from, *subject),
                             .progress = [&](std::uint64_t done) { progress.Done(done); },
                             .stop = Interrupted});
  }
  if (!found.best) {
    io::WriteStandardOutput(report::CleanText(
        fmt::format("{} of {}: no case had an error to compare with a bound, of {} evaluated\n",
                    property.name, options.subject, found.evaluations)));
    return kExitInconclusive;
  }
  if (!options.output.empty()) {
    io::WriteOutput(options.output,
                    io::CaseToJson({*found.best, options.subject, std::string(property.name)}));
  }
  const bool is_violated = found.verdict.outcome == Outcome::kViolated;
  if (options.output == "-") return is_violated ? kExitViolated : kExitHolds;
  const std::string result =
      is_violated ? "violated: " + found.verdict.message
                  : fmt::format("largest error / bound {:.6g} ({:.6g} of drawn cases)",
                                found.verdict.worst_ratio, found.drawn_ratio);
  io::WriteStandardOutput(
      report::CleanText(fmt::format("{} of {}: {}, after {} evaluations of seed {}\nfrom {}\n{}\n",
                                    property.name, options.subject, result, found.evaluations,
                                    options.seed, found.best->origin, SceneLine(*found.best))));
  return is_violated ? kExitViolated : kExitHolds;
}

Run AddClimb(CLI::App* verb, const Invocation& /*call*/) {
  static ClimbOptions options;
  AddSubject(verb, options.subject);
  verb->add_option("--property", options.property, "Property with a bound")->capture_default_str();
  AddSeed(verb, options.seed, "search");
  verb->add_option("--evaluations", options.evaluations, "Cases to judge")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--from", options.from, "Case file to start from, besides generated cases");
  verb->add_option("-o,--output", options.output, "Case file (- for standard output)");
  return [] { return UntilInterrupted(RunClimb, options); };
}

}  // namespace

extern constinit const Verb kClimbVerb{"climb", VerbGroup::kCampaign, 40,
                                       "Search for the case with the largest error over its bound",
                                       AddClimb};

}  // namespace rasterproof::tool
