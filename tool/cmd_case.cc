// rasterproof replay, explain, shrink and decode: one case, saved or generated.
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/error.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/image.h"
#include "io/output.h"
#include "props/codec/codec.h"
#include "props/run/campaign.h"
#include "props/shrink/shrink.h"
#include "report/picture.h"
#include "tool/commands.h"
#include "tool/failure.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// Without a property the claim is the plainest one: the counts are the model's.
Verdict CompareWithModel(Subject& subject, const Case& c) {
  const CoverageCounts expected = exact::Coverage(c.scene, c.profile, c.options);
  std::string failure;
  const auto drawn = DrawUnlessItFails(subject, c.scene, c.options, failure);
  if (!drawn) return Verdict::Violated(1, failure, Witness{});
  const CoverageCounts& observed = *drawn;
  const CoverageDifference difference = Compare(observed, expected);
  if (difference.wrong == 0) return Verdict::Held(difference.samples);
  const std::size_t pixel = difference.first_wrong / static_cast<std::size_t>(expected.samples);
  const auto width = static_cast<std::size_t>(expected.width);
  Witness witness;
  witness.x = static_cast<int>(pixel % width);
  witness.y = static_cast<int>(pixel / width);
  witness.sample =
      static_cast<int>(difference.first_wrong % static_cast<std::size_t>(expected.samples));
  witness.observed = fmt::format("{}", observed.Count(difference.first_wrong));
  witness.expected = fmt::format("{}", expected.Count(difference.first_wrong));
  return Verdict::Violated(difference.samples,
                           fmt::format("{} of {} samples differ from the model of profile {}",
                                       difference.wrong, difference.samples, c.profile.name),
                           witness);
}

Verdict Judge(const LoadedCase& loaded) {
  RequireTakes(*loaded.subject, loaded.value.scene, loaded.value.scene.name);
  if (loaded.property == nullptr) return CompareWithModel(*loaded.subject, loaded.value);
  return props::RunCase(*loaded.subject, *loaded.property, loaded.value);
}

std::string PropertyName(const LoadedCase& loaded) {
  return loaded.property != nullptr ? std::string(loaded.property->name) : std::string();
}

}  // namespace

int RunReplay(const ReplayOptions& options) {
  RequireHonestEnvironment();
  const LoadedCase loaded = LoadCase(options.choice, "replay");
  const Verdict verdict = Judge(loaded);
  std::string text = fmt::format("{}: {}, exercised {} times{}{}\n",
                                 loaded.property ? loaded.property->name : "coverage",
                                 OutcomeName(verdict.outcome), verdict.exercised,
                                 verdict.message.empty() ? "" : "; ", verdict.message);
  if (verdict.outcome == Outcome::kViolated) {
    text += FailureText(*loaded.subject, PropertyName(loaded), loaded.value, verdict, loaded.replay,
                        /*colour=*/false);
  }
  io::WriteStandardOutput(text);
  if (verdict.outcome == Outcome::kViolated) return kExitViolated;
  return verdict.outcome == Outcome::kHolds ? kExitHolds : kExitInconclusive;
}

int RunExplain(const ExplainOptions& options) {
  RequireHonestEnvironment();
  const LoadedCase loaded = LoadCase(options.choice, "explain");
  Verdict verdict = Judge(loaded);
  if (options.x >= 0 || options.y >= 0) {
    const Scene& scene = loaded.value.scene;
    if (options.x < 0 || options.y < 0 || options.x >= scene.width || options.y >= scene.height) {
      throw InputError(fmt::format("--pixel {},{}", options.x, options.y),
                       "the pixel lies outside the target",
                       fmt::format("give 0 to {} and 0 to {}", scene.width - 1, scene.height - 1));
    }
    if (!verdict.witness) verdict.witness.emplace();
    verdict.witness->x = options.x;
    verdict.witness->y = options.y;
  }
  report::Explanation explanation = Explain(*loaded.subject, loaded.value, verdict, loaded.replay);
  if (explanation.headline.empty()) {
    explanation.headline =
        fmt::format("{} {}", loaded.subject->Info().name, OutcomeName(verdict.outcome));
  }
  if (!options.svg.empty()) io::WriteFile(options.svg, report::ExplanationToSvg(explanation));
  if (!options.png.empty()) {
    io::WriteFile(options.png, io::EncodePng(report::ExplanationToImage(explanation)));
  }
  io::WriteStandardOutput(FailureLine(PropertyName(loaded), loaded.value, verdict) + "\n" +
                          report::ExplanationToText(explanation, options.colour));
  return verdict.outcome == Outcome::kViolated ? kExitViolated : kExitHolds;
}

int RunShrink(const ShrinkOptions& options) {
  RequireHonestEnvironment();
  const LoadedCase loaded = LoadCase(options.choice, "shrink");
  if (Judge(loaded).outcome != Outcome::kViolated) {
    throw InputError("case", "it does not fail, so there is nothing to shrink",
                     "give a case that 'rasterproof replay' reports as violated");
  }
  const auto fails = [&](const Case& candidate) {
    if (!Takes(loaded.subject->Info(), candidate.scene)) return false;
    const Verdict verdict = loaded.property != nullptr
                                ? props::RunCase(*loaded.subject, *loaded.property, candidate)
                                : CompareWithModel(*loaded.subject, candidate);
    return verdict.outcome == Outcome::kViolated;
  };
  const props::Shrunk shrunk = props::Shrink(loaded.value, fails, options.budget);
  const std::string text =
      io::CaseToJson({shrunk.minimal, loaded.subject->Info().name, PropertyName(loaded)});
  WriteOutput(options.output, text);
  Tell(fmt::format("{} triangles in {}x{}, after {} evaluations (from {} in {}x{})\n",
                   shrunk.minimal.scene.triangles.size(), shrunk.minimal.scene.width,
                   shrunk.minimal.scene.height, shrunk.evaluations,
                   loaded.value.scene.triangles.size(), loaded.value.scene.width,
                   loaded.value.scene.height));
  return kExitHolds;
}

int RunDecode(const DecodeOptions& options) {
  const std::unique_ptr<Subject> subject = MakeSubject(options.subject);
  if (!options.property.empty()) RequireProperty(options.property);
  const std::string bytes = io::ReadFile(options.input);
  const std::span data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const Case c = props::DecodeCase(data, subject->Info());
  const std::string text = io::CaseToJson({c, options.subject, options.property});
  WriteOutput(options.output, text);
  return kExitHolds;
}

}  // namespace rasterproof::tool
