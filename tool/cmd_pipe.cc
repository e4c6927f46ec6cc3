// rasterproof gen and ver: a program that draws, on a pipe laid by hand.
//
// Both make the same cases and put the claim to the test on a subject that has no pixels of its
// own: gen's writes down what it is asked to draw, ver's answers with what the program said.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/output.h"
#include "props/run/campaign.h"
#include "props/run/facings.h"
#include "subjects/process/protocol.h"
#include "tool/commands.h"
#include "tool/description.h"
#include "tool/failure.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

using subjects::DrawRequest;

struct Answered {
  DrawRequest request;
  CoverageCounts counts;
};

// Draws nothing, and remembers what it was to draw.
class RecordingSubject final : public Subject {
 public:
  RecordingSubject(SubjectInfo info, std::vector<DrawRequest>& requests)
      : info_(std::move(info)), requests_(requests) {}
  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    requests_.push_back({0, scene, counts.samples, options});
  }

 private:
  SubjectInfo info_;
  std::vector<DrawRequest>& requests_;
};

// Draws what a program has drawn.
class AnsweringSubject final : public Subject {
 public:
  AnsweringSubject(SubjectInfo info, const std::vector<Answered>& answers)
      : info_(std::move(info)), answers_(answers) {}
  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const auto found = std::ranges::find_if(answers_, [&](const Answered& a) {
      return a.request.scene == scene && a.request.options == options;
    });
    if (found == answers_.end()) {
      throw InputError("ver", "the program was not asked to draw this",
                       "use check --exec, which can ask again");
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
      counts.front[k] += found->counts.front[k];
      counts.back[k] += found->counts.back[k];
    }
  }

 private:
  SubjectInfo info_;
  const std::vector<Answered>& answers_;
};

SubjectInfo InfoOf(const PipeOptions& options) {
  if (options.description.empty()) return PlainDescription().info;
  return ParseDescription(io::ReadFile(options.description), options.description).info;
}

// What a subject is asked to draw when the claim is put to the test on the case. NaN in a scene is
// equal to nothing, so that each such request is put.
std::vector<DrawRequest> RequestsOf(const SubjectInfo& info, const props::Property& property,
                                    const Case& c) {
  std::vector<DrawRequest> requests;
  const auto recorder = props::WithFacings(std::make_unique<RecordingSubject>(info, requests));
  props::RunCase(*recorder, property, c);
  std::vector<DrawRequest> once;
  for (DrawRequest& r : requests) {
    const bool known = std::ranges::any_of(once, [&](const DrawRequest& other) {
      return other.scene == r.scene && other.options == r.options;
    });
    if (!known) once.push_back(std::move(r));
  }
  return once;
}

std::string NextLine() {
  std::string line;
  if (std::getline(std::cin, line)) return line;
  throw InputError("standard input", "it ends before every request was answered",
                   "give ver the same options as gen, and flush what the program says");
}

CoverageCounts ReadAnswer(const DrawRequest& request, std::uint64_t id, CoverageKind kind) {
  const subjects::AnswerHead head = subjects::ParseAnswerHead(NextLine(), id);
  if (head.kind == subjects::AnswerKind::kFault) throw SubjectFault(head.reason);
  if (head.kind == subjects::AnswerKind::kRefused) {
    throw InputError(fmt::format("request {}", id), "the program refused it: " + head.reason, "");
  }
  CoverageCounts counts(request.scene.width, request.scene.height, request.samples);
  const auto row =
      static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
  const auto read = [&](std::vector<std::uint32_t>& side) {
    for (std::size_t at = 0; at < side.size(); at += row) {
      subjects::ParseCountsRow(NextLine(), row, side.data() + at);
    }
  };
  read(counts.front);
  if (kind == CoverageKind::kFacingCounts) read(counts.back);
  return counts;
}

struct PipeTally {
  std::uint64_t held = 0;
  std::uint64_t refused = 0;
  std::uint64_t idle = 0;  ///< the case did not exercise the claim
  std::uint64_t violated = 0;
};

}  // namespace

int RunGen(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  std::uint64_t id = 0;
  for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
    const Case c = props::DrawCase(info, property, options.campaign.seed, n);
    std::string text;
    for (DrawRequest& request : RequestsOf(info, property, c)) {
      request.id = ++id;
      text += subjects::RequestText(request);
    }
    io::WriteStandardOutput(text);
  }
  return kExitHolds;
}

int RunVer(const PipeOptions& options) {
  RequireHonestEnvironment();
  const SubjectInfo info = InfoOf(options);
  const props::Property& property = RequireProperty(options.property);
  std::uint64_t id = 0;
  PipeTally tally;
  std::string failures;
  {
    Progress progress;
    progress.Stage(fmt::format("ver {}", property.name), options.campaign.cases);
    for (std::uint64_t n = 0; n < options.campaign.cases; ++n) {
      progress.Done(n);
      const Case c = props::DrawCase(info, property, options.campaign.seed, n);
      std::vector<Answered> answers;
      bool refused = false;
      for (DrawRequest& request : RequestsOf(info, property, c)) {
        try {
          CoverageCounts counts = ReadAnswer(request, ++id, info.coverage);
          answers.push_back({std::move(request), std::move(counts)});
        } catch (const InputError&) {
          if (std::cin.eof()) throw;
          refused = true;
        }
      }
      if (refused) {
        ++tally.refused;
        continue;
      }
      const auto subject = props::WithFacings(std::make_unique<AnsweringSubject>(info, answers));
      const Verdict verdict = props::RunCase(*subject, property, c);
      if (verdict.outcome == Outcome::kHolds) ++tally.held;
      if (verdict.outcome == Outcome::kNotExercised) ++tally.idle;
      if (verdict.outcome != Outcome::kViolated) continue;
      if (tally.violated++ == 0) {
        failures = FailureText(*subject, std::string(property.name), c, verdict,
                               fmt::format("rasterproof replay --exec PROGRAM --property {} --seed "
                                           "{} --case {}",
                                           property.name, options.campaign.seed, n),
                               /*colour=*/false);
      }
    }
  }
  io::WriteStandardOutput(
      fmt::format("{}{}: {} cases held, {} violated, {} did not exercise it, {} refused\n",
                  failures, property.name, tally.held, tally.violated, tally.idle, tally.refused));
  if (tally.violated != 0) return kExitViolated;
  return tally.held != 0 ? kExitHolds : kExitInconclusive;
}

}  // namespace rasterproof::tool
