// rasterproof legal: whether one legal model of a profile explains a drawing.
//
// How many samples are open is counted only of a drawing that is not legal: one family of models
// explains a legal one, while the count looks at all of them.
#include "tool/legal/cmd_legal.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "core/tie_rule.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "props/judging/witness.h"
#include "report/grounds.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/legal/broken_rules.h"
#include "tool/legal/legal_hints.h"
#include "tool/legal/legality.h"
#include "tool/legal/saved_core.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

std::string Text(const Judgement& judgement, std::optional<std::uint64_t> open,
                 const JudgedScene& judged, const std::vector<std::string>& hints) {
  const auto& [scene, profile, saved] = judged;
  const legal::JointVerdict& verdict = judgement.verdict;
  std::string text = fmt::format("{}: profile {}; {}\n", LegalityName(verdict.legality),
                                 profile.name, SearchText(verdict, profile));
  text += "compared: " + judgement.compared + "\n";
  if (open)
    text += fmt::format("{} samples are open: legal models differ in how often they cover them\n",
                        *open);
  if (verdict.components != 0) {
    text += fmt::format(
        "with {}: {} components, the largest of {} triangles; {} samples are not judged\n",
        FamilyText(verdict.family, profile), verdict.components, verdict.largest_component,
        verdict.not_judged);
  }
  if (verdict.core) text += CoreText(*verdict.core, scene, profile.pattern.samples());
  text += BrokenRuleLines(judgement.broken, profile);
  for (const std::string& hint : hints) text += "hint: " + hint + "\n";
  return text;
}

void WriteRange(io::JsonWriter& json, std::string_view key, legal::CountRange range) {
  json.Key(key).BeginArray().Integer(range.least).Integer(range.most).EndArray();
}

void WriteRequirement(io::JsonWriter& json, const legal::Requirement& seen) {
  json.BeginObject();
  json.Key("index").Integer(seen.sample);
  json.Key("x").Exact(seen.at.x);
  json.Key("y").Exact(seen.at.y);
  json.Key("least").Integer(seen.least);
  json.Key("most").Integer(seen.most);
  if (seen.by_side) {
    json.Key("front").Integer((*seen.by_side)[0]);
    json.Key("back").Integer((*seen.by_side)[1]);
  }
  if (seen.visible) json.Key("visible").Integer(*seen.visible);
  if (seen.wrong_front) json.Key("shown_side").Text(*seen.wrong_front ? "front" : "back");
  json.Key("legal_least").Integer(seen.legal_least);
  json.Key("legal_most").Integer(seen.legal_most);
  if (seen.legal_by_side) {
    WriteRange(json, "legal_front", (*seen.legal_by_side)[0]);
    WriteRange(json, "legal_back", (*seen.legal_by_side)[1]);
  }
  if (seen.visible) {
    json.Key("legal_visible").BeginArray();
    for (const std::size_t t : seen.legal_visible) json.Integer(t);
    json.EndArray();
  }
  json.Key("triangles").BeginArray();
  for (const std::size_t t : seen.triangles) json.Integer(t);
  json.EndArray();
  json.EndObject();
}

// As `check --json` has them; what no clause requires is the stated model's.
void WriteRules(io::JsonWriter& json, const std::vector<BrokenRule>& rules,
                const Profile& profile) {
  json.Key("why").Text(BrokenRuleText(rules, profile));
  json.Key("required_by").BeginArrayLine();
  for (const Clause* clause : ClausesOf(rules, profile)) json.Text(clause->id);
  json.EndArray();
}

std::string ToJson(const Judgement& judgement, std::optional<std::uint64_t> open,
                   const Profile& profile, const LegalOptions& options,
                   const std::vector<std::string>& hints, const std::string& again) {
  const legal::JointVerdict& verdict = judgement.verdict;
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_legal").Integer(1);
  json.Key("verdict").Text(LegalityName(verdict.legality));
  json.Key("compared").Text(judgement.compared);
  json.Key("profile").Value(io::ProfileToJson(profile));
  if (verdict.core) WriteRules(json, judgement.broken, profile);
  report::WriteEvidence(json, "assumed", report::AssumptionsUnder(profile));
  if (options.transform_error)
    json.Key("assumed_transform_error").Rounded(*options.transform_error);
  json.Key("model").Text(FamilyText(verdict.family, profile));
  json.Key("models_tried").Integer(verdict.families);
  json.Key("samples").Integer(verdict.samples);
  if (open) json.Key("open").Integer(*open);
  json.Key("not_judged").Integer(verdict.not_judged);
  json.Key("components").Integer(verdict.components);
  json.Key("largest_component").Integer(verdict.largest_component);
  if (verdict.core) {
    json.Key("core").BeginObject();
    json.Key("is_minimal").Bool(verdict.core->is_minimal);
    json.Key("wrong_by_themselves").Integer(verdict.core->wrong_by_themselves);
    json.Key("samples").BeginArray();
    const legal::Core& core = *verdict.core;
    for (const legal::Requirement& seen : core.wrong.empty() ? core.requirements : core.wrong)
      WriteRequirement(json, seen);
    json.EndArray();
    json.Key("vertices").BeginArray();
    for (const std::size_t v : verdict.core->vertices) json.Integer(v);
    json.EndArray();
    json.EndObject();
  }
  if (!again.empty()) json.Key("next").Text(again);
  json.Key("hints").BeginArray();
  for (const std::string& hint : hints) json.Text(hint);
  json.EndArray();
  json.EndObject();
  return json.Finish();
}

}  // namespace

Profile WithAssumptions(Profile profile, const LegalOptions& options) {
  if (!options.transform_error) return profile;
  if (profile.freedom.transform_error) {
    throw InputError("--assume-transform-error",
                     fmt::format("profile {} states the error of its transform", profile.name),
                     "leave the option out");
  }
  profile.freedom.transform_error = options.transform_error;
  return profile;
}

std::string AssumedErrorLine(const LegalOptions& options) {
  if (!options.transform_error) return "";
  return fmt::format(
      "assumed, for no specification states it: the transform from clip space moves x and y by at "
      "most {} x 2^-24 of their size before the snap\n",
      *options.transform_error);
}

int RunLegal(const LegalOptions& options) {
  RequireHonestEnvironment();
  if (!options.list.empty()) return JudgeList(options);
  if (options.scene.path.empty())
    throw InputError("legal", "no scene is given", "give a scene file, or --list FILE");
  const int drawings = (options.image.empty() ? 0 : 1) + (options.subject.empty() ? 0 : 1);
  if (options.decided && drawings != 0) {
    throw InputError("--decided", "--decided judges no drawing",
                     "leave out --decided, or the image and the subject");
  }
  if (drawings > 1) throw NotOneDrawing();
  if (options.decided && options.profile.empty()) {
    throw InputError("legal", "no profile is given",
                     "give --profile: vulkan, gl, d3d11, webgpu or a file");
  }
  if (!options.facings.empty() && options.image.empty()) {
    throw InputError("--facings " + options.facings, "subjects and cases report their own facings",
                     "give an image, or leave --facings out");
  }
  if (options.decided) return TellDecided(options);
  if (options.resolved) return JudgeResolved(options);
  std::unique_ptr<Subject> subject;
  if (!options.subject.empty()) subject = MakeSubject(options.subject, options.profile);
  const JudgedScene judged = LoadJudgedScene(options, subject.get());
  const Scene& scene = judged.scene;
  const Profile& profile = judged.profile;
  const OneCall drawn = subject ? DrawInOneCall(*subject, scene) : ReadDrawing(options, judged);
  const Judgement judgement = JudgeDrawing(judged, drawn);
  const legal::JointVerdict& verdict = judgement.verdict;
  std::optional<std::uint64_t> open;
  if (verdict.legality != legal::Legality::kLegal)
    open = legal::DecidedSamples(scene, {profile, scene}).NumberOpen();
  const std::vector<std::string> hints = HintsOf(options, judged, drawn, verdict);
  std::string again;
  if (!options.save.empty() && verdict.core)
    again = SaveCore(options, judged, drawn, *verdict.core, subject.get());
  if (!options.json.empty())
    io::WriteOutput(options.json, ToJson(judgement, open, profile, options, hints, again));
  if (options.json != "-") {
    io::WriteStandardOutput(Text(judgement, open, judged, hints) +
                            report::AssumptionLines(profile) + AssumedErrorLine(options) +
                            (again.empty() ? "" : "replay: " + again + "\n"));
  }
  return StatusOf(verdict.legality);
}

}  // namespace rasterproof::tool
