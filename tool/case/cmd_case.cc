// rasterproof replay, explain and convert: one case, saved or generated.
#include "tool/case/cmd_case.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/netpbm.h"
#include "io/output.h"
#include "props/codec/codec.h"
#include "props/engine/pulled.h"
#include "props/infer/observer.h"
#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/run/campaign.h"
#include "props/run/counterexample.h"
#include "report/case_code.h"
#include "report/picture.h"
#include "report/text.h"
#include "tool/case/replay.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/interrupt.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legality.h"
#include "tool/load_case.h"
#include "tool/not_stated.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/rounds/far_program.h"
#include "tool/session.h"
#include "tool/shell.h"

namespace rasterproof::tool {
namespace {

// Why a difference from the canonical model says nothing against the subject; empty if it does.
std::string WhyObservedOnly(const SubjectInfo& info, const props::PlacedCase& c) {
  if (!HasOneModel(c.profile) && !info.states_exact)
    return "the profile leaves more than one result";
  const bool is_finite = std::ranges::all_of(c.scene.vertices, IsFinite);
  const bool says_of_infinite = c.profile.infinite_vertex == InfiniteVertex::kNothing;
  return is_finite || !says_of_infinite ? WhyNotStated(c.scene, c.profile) : "";
}

// Without a property the property is the plainest one: the counts are the model's.
Verdict CompareWithModel(const CoverageCounts& observed, const props::Description& subject,
                         const props::PlacedCase& c) {
  CoverageCounts expected = exact::Coverage(c, c.options);
  if (props::IsJudgedAsShown(subject.info, c.scene)) expected = props::AsShown(std::move(expected));
  const CoverageDifference difference = Compare(observed, expected);
  if (difference.wrong == 0) return Verdict::Held(difference.samples);
  if (const std::string why = WhyObservedOnly(subject.info, c); !why.empty()) {
    return Verdict::NotExercised(fmt::format("{} of {} samples differ from the canonical model: {}",
                                             difference.wrong, difference.samples, why));
  }
  const std::size_t pixel = difference.first_wrong / static_cast<std::size_t>(expected.samples);
  const auto width = static_cast<std::size_t>(expected.width);
  Witness witness;
  witness.x = static_cast<int>(pixel % width);
  witness.y = static_cast<int>(pixel / width);
  witness.sample =
      static_cast<int>(difference.first_wrong % static_cast<std::size_t>(expected.samples));
  witness.observed = {observed.Count(difference.first_wrong)};
  witness.expected = {expected.Count(difference.first_wrong)};
  return Verdict::Violated(difference.samples,
                           fmt::format("{} of {} samples differ from the model of profile {}",
                                       difference.wrong, difference.samples, c.profile.name),
                           witness);
}

props::Checks AskForTheModel(const props::PlacedCase& c, const props::Description& subject) {
  Questions questions;
  questions.draws.push_back(props::CountsOf(c.scene, c.profile, c.options));
  return props::OneCheck(std::move(questions), [&c, &subject](const Answers& answers) {
    return CompareWithModel(answers.draws[0]->counts, subject, c);
  });
}

}  // namespace

const props::Property& PropertyOf(const LoadedCase& loaded) {
  static const props::Property plain{.name = "coverage",
                                     .group = "coverage",
                                     .clause = "the counts are those of the model",
                                     .tolerance = "none: exact",
                                     .domains = {},
                                     .gate = {.space = props::Space::kEither,
                                              .contract = props::ContractNeeded::kNone,
                                              .bound_by = props::BoundBy::kNothing,
                                              .asks_oracle = true},
                                     .ask = AskForTheModel};
  return loaded.property != nullptr ? *loaded.property : plain;
}

props::CampaignOptions ShrinkingBy(const Subject& subject, std::uint64_t evaluations) {
  constexpr double kNoLimit = 1e9;  // seconds
  return CampaignOn(subject, {.shrink_budget = evaluations, .shrink_seconds = kNoLimit});
}

namespace {

void RequireDraws(const LoadedCase& loaded) {
  const std::string place = ShownName(loaded.value.scene.name);
  RequireTakes(*loaded.subject, loaded.value.scene, place);
  RequireDrawsSamples(*loaded.subject, loaded.value.profile, place);
}

Verdict Judge(const LoadedCase& loaded) {
  RequireDraws(loaded);
  return props::RunCase(*loaded.subject, PropertyOf(loaded), loaded.value);
}

std::string PropertyName(const LoadedCase& loaded) {
  return loaded.property != nullptr ? std::string(loaded.property->name) : std::string();
}

// The smallest case that fails as the loaded one does takes its place and is written.
Verdict Shrink(const ReplayOptions& options, LoadedCase& loaded) {
  const Scene& given = loaded.value.scene;
  RequireDraws(loaded);
  Progress progress;
  props::CampaignOptions campaign = ShrinkingBy(*loaded.subject, options.evaluations);
  campaign.shrinking = [&](std::uint64_t evaluations) {
    if (evaluations == 0) progress.Stage("shrink", campaign.shrink_budget);
    progress.Done(evaluations);
  };
  Counterexample shrunk =
      props::ShrinkFailing(*loaded.subject, PropertyOf(loaded), loaded.value, campaign);
  if (shrunk.outcome == Outcome::kInconclusive) {
    progress.Say(shrunk.message);
    return Verdict::Inconclusive(shrunk.message);
  }
  if (shrunk.outcome != Outcome::kViolated) {
    throw InputError("case", "it does not fail, so there is nothing to shrink",
                     "give a case that 'rasterproof replay' reports as violated");
  }
  const Scene& scene = shrunk.value.scene;
  CaseChoice again = options.choice;
  again.path = options.shrink;
  again.name.clear();
  again.is_fuzz_input = false;
  again.subject = loaded.subject->Info().name;
  again.property = PropertyName(loaded);
  io::WriteOutput(options.shrink, io::CaseToJson({shrunk.value, again.subject, again.property,
                                                  shrunk.verdict.drawn}));
  progress.Say(fmt::format("{} triangles in {}x{}, after {} evaluations (from {} in {}x{}); {}",
                           scene.triangles.size(), scene.width, scene.height, shrunk.evaluations,
                           given.triangles.size(), given.width, given.height, shrunk.message));
  loaded.value = std::move(shrunk.value);
  loaded.replay = CommandFor("replay", again);
  return shrunk.verdict;
}

void RequirePixel(const ExplainOptions& options, const Scene& scene) {
  if (options.x >= 0 && options.y >= 0 && options.x < scene.width && options.y < scene.height) {
    return;
  }
  throw InputError(fmt::format("--pixel {},{}", options.x, options.y),
                   "the pixel lies outside the target",
                   fmt::format("give 0 to {} and 0 to {}", scene.width - 1, scene.height - 1));
}

// The counts of a pixel's samples, in the order of the sample locations: "2", or "1 0 0 1"; with
// facings "1+1", front before back.
std::string CountsAt(const CoverageCounts& counts, int x, int y, bool facings) {
  std::string text;
  for (int sample = 0; sample < counts.samples; ++sample) {
    const std::size_t k = counts.Index(x, y, sample);
    if (sample != 0) text += " ";
    text += facings ? fmt::format("{}+{}", counts.front[k], counts.back[k])
                    : fmt::format("{}", counts.Count(k));
  }
  return text;
}

std::string PixelLine(const report::Explanation& explanation, int x, int y) {
  const auto counts = [&](bool facings) {
    return std::array{CountsAt(explanation.observed, x, y, facings),
                      CountsAt(explanation.expected, x, y, facings)};
  };
  auto [observed, expected] = counts(false);
  const auto [observed_apart, expected_apart] = counts(true);
  std::string what;
  if (observed == expected && observed_apart != expected_apart) {
    observed = observed_apart;
    expected = expected_apart;
    what = " (front+back)";
  }
  return fmt::format("chosen pixel ({}, {}): observed {}, expected {}{}", x, y, observed, expected,
                     what);
}

// What was drawn, as code, with the verdict in its comments.
std::string CodeOf(std::string_view language, const LoadedCase& loaded, const Verdict& verdict) {
  const std::string line =
      FailureLine(loaded.subject->Info(), PropertyName(loaded), loaded.value, verdict);
  const std::string notes =
      fmt::format("{}: {}\n{}replay: {}", loaded.subject->Info().name, OutcomeName(verdict.outcome),
                  verdict.outcome == Outcome::kViolated ? line + "\n" : "", loaded.replay);
  return report::CaseCode(*report::CodeLanguageNamed(language), AsDrawn(loaded.value, verdict),
                          report::CleanText(notes));
}

}  // namespace

int Replay(const ReplayOptions& options, LoadedCase loaded) {
  Verdict verdict = options.shrink.empty() ? Judge(loaded) : Shrink(options, loaded);
  if (options.shrink == "-") return StatusOf(verdict.outcome);
  if (!options.as.empty()) {
    io::WriteStandardOutput(CodeOf(options.as, loaded, verdict));
    return StatusOf(verdict.outcome);
  }
  std::string text = fmt::format("{}: {}, exercised {} times{}{}\n",
                                 loaded.property ? loaded.property->name : "coverage",
                                 OutcomeName(verdict.outcome), verdict.exercised,
                                 verdict.message.empty() ? "" : "; ", verdict.message);
  if (verdict.outcome == Outcome::kViolated) {
    SeeIfItCan(*loaded.subject, loaded.value, verdict);
    text += FailureText(loaded.subject->Info(), PropertyName(loaded), loaded.value, verdict,
                        loaded.replay);
  }
  io::WriteStandardOutput(report::CleanText(text));
  return StatusOf(verdict.outcome);
}

namespace {

// Each call goes on by the answers of all earlier rounds.
int ReplayInRounds(const ReplayOptions& options) {
  const CaseChoice& choice = options.choice;
  // More of them make rounds fewer, but slowly: what is asked is foreseen by its likelihood.
  constexpr props::RoundSize kOfShrinking{.requests = 1000};
  FarProgram program(choice.subject, choice.profile, kOfShrinking, /*device=*/false,
                     choice.list_length);
  LoadedCase loaded = LoadCase(choice, "replay", program.Maker());
  RequireDraws(loaded);
  const props::Property& property = PropertyOf(loaded);
  if (property.is_about_sequence) {
    throw InputError(fmt::format("property {}", property.name),
                     "it needs a sequence of calls, and a file of requests is one call",
                     "replay it where the program runs: --exec");
  }
  const props::PulledShrink* shrink = nullptr;
  if (!options.shrink.empty()) {
    shrink = &program.Add(std::make_unique<props::PulledShrink>(
        property, loaded.value, ShrinkingBy(*loaded.subject, options.evaluations)));
  }
  const auto ask = [&] {
    Verdict verdict = shrink == nullptr ? Judge(loaded) : shrink->result().verdict;
    if (verdict.outcome != Outcome::kViolated) return;
    SeeIfItCan(*loaded.subject, shrink == nullptr ? loaded.value : shrink->result().value,
               verdict);  // the picture
  };
  return program.Run(ask, [&] { return Replay(options, std::move(loaded)); });
}

}  // namespace

int RunReplay(const ReplayOptions& options) {
  RequireHonestEnvironment();
  if (options.choice.subject.starts_with(kRoundsPrefix)) return ReplayInRounds(options);
  return Replay(options, LoadCase(options.choice, "replay"));
}

namespace {

// The pictures that are asked for, and the text behind its head.
void ShowExplanation(const ExplainOptions& options, const report::Explanation& explanation,
                     const std::string& head) {
  if (!options.svg.empty()) io::WriteFile(options.svg, report::ExplanationToSvg(explanation));
  if (!options.png.empty()) {
    io::WriteFile(options.png, io::EncodeFor(options.png, report::ExplanationToImage(explanation)));
  }
  io::WriteStandardOutput(report::CleanText(head) +
                          report::ExplanationToText(explanation, options.colour));
}

// The drawing that a case holds beside the canonical model's, at the first sample that no legal
// model explains.
int ExplainDrawing(const ExplainOptions& options, io::CaseFile file) {
  LegalOptions asked;
  asked.scene.path = options.choice.path;
  asked.profile = options.choice.profile;
  const JudgedScene judged = JudgedSceneOf(asked, std::move(file), nullptr);
  const OneCall drawn = ReadDrawing(asked, judged);
  const legal::JointVerdict found = JudgeDrawing(judged, drawn).verdict;
  const Case c{judged.scene, judged.profile, {}, options.choice.path};
  CoverageCounts observed = drawn.drawing.counts;
  if (!drawn.has_counts) {
    observed = CoverageCounts(c.scene.width, c.scene.height, c.profile.pattern.samples());
    for (std::size_t k = 0; k < observed.size(); ++k)
      observed.front[k] = drawn.drawing.primitive_ids[k] == kNoPrimitive ? 0 : 1;
  }
  CoverageCounts expected = exact::Coverage(props::PlacedCase(c), c.options);
  if (drawn.is_mask || !drawn.has_counts) expected = props::AsShown(std::move(expected));
  if (!drawn.has_facings) props::JoinFacings(expected);
  Verdict verdict;
  verdict.message = LegalityName(found.legality) + ": profile " + c.profile.name;
  if (found.core) {
    verdict.message += "; " + CoreLine(*found.core, c.scene, observed.samples);
    verdict.witness = props::WitnessAtIndex(observed, found.core->requirements.front().sample);
  }
  std::string again = "rasterproof explain " + ShellWord(options.choice.path);
  if (options.x >= 0 || options.y >= 0) {
    RequirePixel(options, c.scene);
    verdict.witness.emplace();
    verdict.witness->x = options.x;
    verdict.witness->y = options.y;
    again += fmt::format(" --pixel {},{}", options.x, options.y);
  }
  verdict.compared = std::make_shared<ComparedCounts>(observed, expected);
  const report::Explanation explanation =
      Explain(MakeOracle("exact", c.profile)->Info(), c, verdict, again);
  ShowExplanation(
      options, explanation,
      "expected: the canonical model of the profile; a legal drawing may differ from it\n");
  return StatusOf(found.legality);
}

}  // namespace

int RunExplain(const ExplainOptions& options) {
  RequireHonestEnvironment();
  LoadedCase loaded = options.as.empty() ? LoadCaseOrDrawing(options.choice, "explain")
                                         : LoadCase(options.choice, "explain");
  if (loaded.drawing) return ExplainDrawing(options, *std::move(loaded.drawing));
  const bool chosen = options.x >= 0 || options.y >= 0;
  const Verdict verdict = Judge(loaded);
  if (!options.as.empty()) {
    io::WriteStandardOutput(CodeOf(options.as, loaded, verdict));
    return StatusOf(verdict.outcome);
  }
  if (chosen) RequirePixel(options, AsDrawn(loaded.value, verdict).scene);
  Verdict shown = verdict;
  if (chosen) {
    shown.witness.emplace();  // what was said of the failing place is not so of this one
    shown.witness->x = options.x;
    shown.witness->y = options.y;
  }
  std::string again = loaded.replay;
  if (chosen) again += fmt::format(" --pixel {},{}", options.x, options.y);
  // There is nothing to see of what was not drawn.
  if (verdict.outcome == Outcome::kRefused || verdict.outcome == Outcome::kInconclusive) {
    io::WriteStandardOutput(
        report::CleanText(
            FailureLine(loaded.subject->Info(), PropertyName(loaded), loaded.value, verdict)) +
        "\n" + SceneLine(loaded.value) + "\n" + DrawnLine(loaded.value, verdict));
    return StatusOf(verdict.outcome);
  }
  See(*loaded.subject, loaded.value, shown);
  report::Explanation explanation = Explain(loaded.subject->Info(), loaded.value, shown, again);
  if (explanation.headline.empty()) {
    explanation.headline =
        fmt::format("{} {}", loaded.subject->Info().name, OutcomeName(verdict.outcome));
  }
  std::string text =
      FailureLine(loaded.subject->Info(), PropertyName(loaded), loaded.value, verdict) + "\n" +
      DrawnLine(loaded.value, verdict);
  if (chosen) text += PixelLine(explanation, options.x, options.y) + "\n";
  ShowExplanation(options, explanation, text);
  return StatusOf(verdict.outcome);
}

int RunConvert(const ConvertOptions& options) {
  const LoadedCase loaded = LoadCase(options.choice, "convert");
  const SubjectInfo& info = loaded.subject->Info();
  if (options.to == "case") {
    io::WriteOutput(options.output,
                    io::CaseToJson({loaded.value, info.name, PropertyName(loaded)}));
    return kExitHolds;
  }
  RequireTakes(*loaded.subject, loaded.value.scene, options.choice.path);
  Case c = loaded.value;
  // A fuzz input is judged by the subject's profile, and bytes for names would be wasted on it.
  c.profile = info.profile;
  c.scene.name.clear();
  c.origin.clear();
  const std::vector<std::uint8_t> bytes = props::EncodeCase(c, info);
  if (!props::SameCase(props::DecodeCase(bytes, info), c)) {
    throw InputError(
        options.choice.path, "it does not fit a fuzz input",
        "give at most 65536 vertices and triangles, and only options that the subject takes");
  }
  io::WriteOutput(options.output, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return kExitHolds;
}

}  // namespace rasterproof::tool
