// rasterproof gen and ver: a program that draws, on a pipe laid by hand.
//
// Both make the same cases and put the claim to the test on a subject that has no pixels of its
// own: gen's writes down what it is asked to draw, ver's answers with what the program said.
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "core/subject_errors.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/run/batching.h"
#include "props/run/campaign.h"
#include "props/run/facings.h"
#include "props/run/tally.h"
#include "subjects/process/protocol.h"
#include "tool/commands.h"
#include "tool/description.h"
#include "tool/failure.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

SubjectInfo InfoOf(const PipeOptions& options) {
  SubjectInfo info =
      options.description.empty()
          ? PlainDescription().info
          : ParseDescription(io::ReadFile(options.description), options.description).info;
  if (!options.profile.empty()) info.profile = io::ReadProfile(options.profile);
  return info;
}

// A subject outside without a rasterizer: what it draws is a ledger's.
struct LedgerSubject {
  LedgerSubject(const SubjectInfo& info, props::DrawLedger& ledger, props::OnMiss on_miss) {
    auto batching = std::make_unique<props::BatchingSubject>(info);
    batching->Follow(ledger, on_miss);
    subject = props::WithFacings(std::move(batching));
  }
  std::unique_ptr<Subject> subject;
};

// What a subject is asked to draw when the claim is put to the test on the case; `why_not` is set
// to what stands in the way, where nothing is asked and nothing stood there before.
props::DrawLedger RequestsOf(const SubjectInfo& info, const props::Property& property,
                             const Case& c, std::string& why_not) {
  props::DrawLedger ledger;
  const LedgerSubject recorder(info, ledger, props::OnMiss::kCoverNothing);
  const Verdict verdict = props::RunCase(*recorder.subject, property, c);
  if (ledger.jobs.empty() && why_not.empty()) why_not = verdict.message;
  if (!ledger.jobs.empty()) {
    // The picture of a failure shows the whole case, which the claim need not have asked for.
    CoverageCounts counts(c.scene.width, c.scene.height, c.profile.lattice.samples());
    recorder.subject->Draw(c.scene, c.options, counts);
  }
  return ledger;
}

// Of a run that asked for no drawing at all.
void TellNothingAsked(const props::Property& property, std::uint64_t cases,
                      const std::string& why_not) {
  std::cerr << fmt::format("{}: none of {} cases asks for a drawing: {}\n", property.name, cases,
                           why_not.empty() ? "it was never put to the test" : why_not);
}

std::string_view NextLine(std::size_t /*most_bytes*/) {
  static std::string line;
  if (std::getline(std::cin, line)) return line;
  throw InputError("standard input", "it ends before every request was answered",
                   "give ver the same options as gen, and flush what the program says");
}

// Reads the answers to a ledger's jobs. Returns whether none was refused.
bool ReadAnswers(const SubjectInfo& info, std::uint64_t& id, props::DrawLedger& ledger) {
  bool all = true;
  for (const DrawJob& job : ledger.jobs) {
    DrawOutcome& outcome = ledger.outcomes.emplace_back();
    try {
      outcome.drawing = subjects::ReadAnswer(++id, job, info, NextLine);
    } catch (const InputError&) {
      if (std::cin.eof()) throw;
      all = false;
    } catch (const SubjectFault&) {
      outcome.error = std::current_exception();
    }
  }
  return all;
}

struct PipeTally {
  std::uint64_t held = 0;
  std::uint64_t refused = 0;
  std::uint64_t idle = 0;  ///< the case did not exercise the claim
  std::uint64_t violated = 0;

  int Status() const {
    if (violated != 0) return kExitViolated;
    const auto asked = static_cast<double>(refused + held);
    const bool refuses_too_much = static_cast<double>(refused) > props::kMostRefusedShare * asked;
    return held != 0 && !refuses_too_much ? kExitHolds : kExitInconclusive;
  }
};

}  // namespace

int RunGen(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  std::uint64_t id = 0;
  std::string why_not;
  for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
    const Case c = props::DrawCase(info, property, options.campaign.seed, n);
    const std::vector<DrawJob> jobs = RequestsOf(info, property, c, why_not).jobs;
    io::WriteStandardOutput(subjects::RequestsText(id + 1, jobs, info));
    id += jobs.size();
  }
  if (id != 0) return kExitHolds;
  TellNothingAsked(property, options.campaign.cases, why_not);
  return kExitInconclusive;
}

int RunVer(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  std::uint64_t id = 0;
  PipeTally tally;
  std::string why_not;
  std::string failures;
  {
    Progress progress;
    progress.Stage(fmt::format("ver {}", property.name), options.campaign.cases);
    for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
      progress.Done(n);
      const Case c = props::DrawCase(info, property, options.campaign.seed, n);
      props::DrawLedger ledger = RequestsOf(info, property, c, why_not);
      if (!ReadAnswers(info, id, ledger)) {
        ++tally.refused;
        continue;
      }
      const LedgerSubject answering(info, ledger, props::OnMiss::kRefuse);
      const Verdict verdict = props::RunCase(*answering.subject, property, c);
      if (verdict.outcome == Outcome::kHolds) ++tally.held;
      if (verdict.outcome == Outcome::kNotExercised) ++tally.idle;
      if (verdict.outcome != Outcome::kViolated) continue;
      if (tally.violated++ == 0) {
        CaseChoice choice;
        choice.subject = std::string(kExecPrefix) + "PROGRAM";
        choice.property = property.name;
        choice.profile = options.profile;
        choice.name = c.origin;
        failures = FailureText(*answering.subject, choice.property, c, verdict,
                               CommandFor("replay", choice), /*colour=*/false);
      }
    }
  }
  if (id == 0) TellNothingAsked(property, options.campaign.cases, why_not);
  io::WriteStandardOutput(
      fmt::format("{}{}: {} cases held, {} violated, {} did not exercise it, {} refused\n",
                  failures, property.name, tally.held, tally.violated, tally.idle, tally.refused));
  return tally.Status();
}

}  // namespace rasterproof::tool
