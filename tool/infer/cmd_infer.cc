// rasterproof infer: which model a subject follows, found by experiment.
#include "tool/infer/cmd_infer.h"

#include <memory>
#include <string>

#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "props/engine/pulled_infer.h"
#include "props/infer/infer.h"
#include "props/infer/stated_keys.h"
#include "tool/case_choice.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/infer/infer_text.h"
#include "tool/interrupt.h"
#include "tool/resolve.h"
#include "tool/rounds/far_program.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

std::string_view FacingText(props::FacingReport facing) {
  switch (facing) {
    case props::FacingReport::kAsOnScreen:
      return "front is counter-clockwise on screen";
    case props::FacingReport::kReversed:
      return "front is clockwise on screen";
    case props::FacingReport::kNotTold:
      break;
  }
  return "facings are not distinguished";
}

std::string FittingText(const props::Inference& inference) {
  std::string text =
      inference.remaining.size() == 1
          ? "one model explains every draw\n"
          : fmt::format(
                "{} models explain every draw; no triangle was found that tells them apart\n",
                inference.remaining.size());
  for (const Profile& profile : inference.remaining)
    text += "  " + props::ModelText(profile) + "\n";
  text += fmt::format("facings          {}\n",
                      inference.message.empty() ? FacingText(inference.facing) : inference.message);
  for (const props::StatementVerdict& verdict : inference.statements) {
    text += fmt::format("{:<16} {:<16} stated {}{}\n", verdict.statement,
                        verdict.agrees ? "agrees" : "CONTRADICTED", verdict.stated,
                        verdict.found == verdict.stated ? "" : ", found " + verdict.found);
  }
  return text;
}

// "(0x1p+0, 0x1p-1) ...": the vertices of a scene.
std::string VerticesText(const Scene& scene) {
  std::string text;
  for (const Vertex& v : scene.vertices)
    text += fmt::format("{}({:a}, {:a})", text.empty() ? "" : " ", v.x, v.y);
  return text;
}

std::string LastRefutedText(const props::Inference& inference) {
  if (!inference.last_refuted) return "";
  const Case& last = *inference.last_refuted;
  return fmt::format("last refuted     {}, by the draw of {} on {}x{}\n",
                     props::ModelText(last.profile), VerticesText(last.scene), last.scene.width,
                     last.scene.height);
}

std::string NoFitText(const props::Inference& inference) {
  if (inference.is_inconclusive) return fmt::format("inconclusive: {}\n", inference.message);
  std::string text;
  if (const auto& nearest = inference.nearest) {
    text +=
        fmt::format("differs in       {} of {} samples, {} of {} draws{}\n", nearest->wrong_samples,
                    nearest->samples, nearest->wrong_experiments, nearest->experiments,
                    nearest->wrong_samples == 0 && inference.witness
                        ? ", drawn at random; in an aimed one, below"
                        : "");
  }
  return text + fmt::format("no model fits    {}\n", inference.message) +
         LastRefutedText(inference);
}

std::string PlacesText(const props::Inference& inference) {
  std::string text;
  if (!inference.sample_places) return text;
  for (const std::string& line : props::PlacesText(*inference.sample_places))
    text += fmt::format("{:<16} {}\n", text.empty() ? "places" : "", line);
  return text;
}

std::string CaseText(const std::string& what, const Case& c, const std::string& subject) {
  return what + "\n" + io::CaseToJson({c, subject, "CoverageEqualsTheModel"}) +
         "replay: save it as case.json, then: rasterproof replay case.json " +
         SubjectOption(subject) + "\n";
}

std::string ToJson(const props::Inference& inference, const SubjectInfo& info) {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_inference").Integer(2);
  json.Key("subject").Text(info.name);
  json.Key("stated").Value(io::ProfileToJson(info.profile));
  json.Key("fits").Bool(inference.Fits());
  json.Key("agrees").Bool(inference.Fits() && inference.Agrees());
  json.Key("models").Integer(inference.models);
  json.Key("experiments").Integer(inference.experiments);
  json.Key("seconds").Rounded(inference.seconds);
  json.Key("facing").Text(FacingText(inference.facing));
  json.Key("remaining").BeginArray();
  for (const Profile& profile : inference.remaining) json.Value(io::ProfileToJson(profile));
  json.EndArray();
  json.Key("statements").BeginArray();
  for (const props::StatementVerdict& verdict : inference.statements) {
    json.BeginObject();
    json.Key("statement").Text(verdict.statement);
    json.Key("stated").Text(verdict.stated);
    json.Key("found").Text(verdict.found);
    json.Key("agrees").Bool(verdict.agrees);
    json.EndObject();
  }
  json.EndArray();
  json.Key("message").Text(inference.message);
  if (const auto& nearest = inference.nearest) {
    json.Key("nearest").BeginObject();
    json.Key("profile").Value(io::ProfileToJson(nearest->profile));
    json.Key("wrong_samples").Integer(nearest->wrong_samples);
    json.Key("samples").Integer(nearest->samples);
    json.Key("wrong_experiments").Integer(nearest->wrong_experiments);
    json.Key("experiments").Integer(nearest->experiments);
    json.EndObject();
  }
  if (inference.sample_places) {
    json.Key("sample_places").BeginArray();
    for (const std::string& line : props::PlacesText(*inference.sample_places)) json.Text(line);
    json.EndArray();
  }
  const auto& shown = inference.witness ? inference.witness : inference.against_stated;
  if (shown) {
    json.Key("witness").Value(io::CaseToJson({*shown, info.name, "CoverageEqualsTheModel"}));
  }
  json.EndObject();
  return json.Finish();
}

// Each call infers on the answers of all earlier rounds, and foresees the whole course for each
// likely model.
int InferInRounds(const InferOptions& options) {
  constexpr props::RoundSize kOfInferring{.requests = 4000};
  FarProgram program(options.subject, options.profile, kOfInferring);
  RequireSamples(program.Info());
  props::InferOptions choice;
  choice.seed = options.seed;
  const props::PulledInfer& infer = program.Add(std::make_unique<props::PulledInfer>(choice));
  return program.Run([] {},
                     [&] { return TellInference(infer.result(), program.Info(), options.json); });
}

}  // namespace

int RunInfer(const InferOptions& options) {
  RequireHonestEnvironment();
  if (options.subject.starts_with(kRoundsPrefix)) return InferInRounds(options);
  const std::unique_ptr<Subject> subject = MakeSubject(options.subject, options.profile);
  NotePreset(subject->Info().profile);
  RequireSamples(subject->Info());
  props::InferOptions choice;
  choice.seed = options.seed;
  const props::Inference inference = props::Infer(*subject, choice);
  if (Interrupted()) return InterruptStatus();
  return TellInference(inference, subject->Info(), options.json);
}

int TellInference(const props::Inference& inference, const SubjectInfo& info,
                  const std::string& json) {
  std::string text = info.name + ": " + props::InferredText(inference) + "\n";
  text += fmt::format("{} models, {} draws, {:.2f} s\n", inference.models, inference.experiments,
                      inference.seconds);
  text += inference.Fits() ? FittingText(inference) : NoFitText(inference);
  text += PlacesText(inference);
  if (inference.witness) {
    text += CaseText("a case that it draws differently:", *inference.witness, info.name);
  }
  if (inference.against_stated) {
    text += CaseText("a case that the stated profile draws differently:", *inference.against_stated,
                     info.name);
  }
  if (!json.empty()) io::WriteOutput(json, ToJson(inference, info));
  if (json != "-") io::WriteStandardOutput(text);
  if (inference.Fits()) return inference.Agrees() ? kExitHolds : kExitViolated;
  if (inference.is_inconclusive) return kExitInconclusive;
  // Only who states what each sample counts breaks a contract by following no model of it.
  return info.profile.contract == Contract::kSampleExact ? kExitViolated : kExitInconclusive;
}

}  // namespace rasterproof::tool
