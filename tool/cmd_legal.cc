// rasterproof legal: whether one legal model of a profile explains a drawing.
//
// How many samples are open is counted only of a drawing that is not legal: one family of models
// explains a legal one, while the count looks at all of them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "core/tie_rule.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/counts_file.h"
#include "io/output.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "model/target_profile.h"
#include "props/judging/witness.h"
#include "report/grounds.h"
#include "report/json_writer.h"
#include "tool/commands.h"
#include "tool/legality.h"
#include "tool/resolve.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

std::string GridText(const Snap& grid) {
  return grid.IsNone() ? "no grid" : fmt::format("{} subpixel bits", grid.bits);
}

std::string FamilyText(const legal::Family& family, const Profile& profile) {
  std::string text = GridText(family.grid);
  const TieOwnership ties = profile.freedom.ties;
  if (ties == TieOwnership::kStated || ties == TieOwnership::kAxisAligned)
    text += ", tie rule " + TieRuleName(family.rule);
  return text;
}

std::string LegalityName(legal::Legality legality) {
  switch (legality) {
    case legal::Legality::kLegal:
      return "legal";
    case legal::Legality::kNotLegal:
      return "not legal";
    case legal::Legality::kNotJudged:
      break;
  }
  return "not judged";
}

std::string Text(const legal::JointVerdict& verdict, std::optional<std::uint64_t> open,
                 const Profile& profile, const Scene& scene) {
  std::string text = fmt::format("{}: profile {}; ", LegalityName(verdict.legality), profile.name);
  const std::string family = FamilyText(verdict.family, profile);
  if (verdict.legality == legal::Legality::kLegal) {
    text += fmt::format("one model with {} explains all {} samples\n", family, verdict.samples);
  } else if (verdict.legality == legal::Legality::kNotJudged) {
    text += fmt::format("a component of {} triangles is too large to be judged\n",
                        verdict.largest_given_up);
  } else {
    text += fmt::format("no model explains the image; {} tried\n",
                        verdict.families == 1
                            ? "one grid and tie rule was"
                            : fmt::format("{} grids and tie rules were", verdict.families));
  }
  if (open)
    text += fmt::format("{} samples are open: legal models cover them differently often\n", *open);
  if (verdict.components != 0) {
    text += fmt::format(
        "with {}: {} components, the largest of {} triangles; {} samples are not judged\n", family,
        verdict.components, verdict.largest_component, verdict.not_judged);
  }
  if (verdict.core)
    text += CoreText(*verdict.core, scene, static_cast<std::size_t>(profile.pattern.samples()));
  return text;
}

std::string ToJson(const legal::JointVerdict& verdict, std::optional<std::uint64_t> open,
                   const Profile& profile, const LegalOptions& options) {
  report::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_legal").Integer(1);
  json.Key("verdict").Text(LegalityName(verdict.legality));
  json.Key("profile").Value(io::ProfileToJson(profile));
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
    for (const legal::Requirement& seen : verdict.core->requirements) {
      json.BeginObject();
      json.Key("index").Integer(seen.sample);
      json.Key("x").Exact(seen.at.x);
      json.Key("y").Exact(seen.at.y);
      json.Key("least").Integer(seen.least);
      json.Key("most").Integer(seen.most);
      if (seen.visible) json.Key("visible").Integer(*seen.visible);
      json.Key("legal_least").Integer(seen.legal_least);
      json.Key("legal_most").Integer(seen.legal_most);
      json.Key("triangles").BeginArray();
      for (const std::size_t t : seen.triangles) json.Integer(t);
      json.EndArray();
      json.EndObject();
    }
    json.EndArray();
    json.Key("vertices").BeginArray();
    for (const std::size_t v : verdict.core->vertices) json.Integer(v);
    json.EndArray();
    json.EndObject();
  }
  json.EndObject();
  return json.Finish();
}

// The scene with the triangles of the core alone.
Scene CoreScene(const Scene& scene, const legal::Core& core) {
  std::vector<std::size_t> triangles;
  for (const legal::Requirement& seen : core.requirements)
    triangles.insert(triangles.end(), seen.triangles.begin(), seen.triangles.end());
  std::ranges::sort(triangles);
  const auto repeated = std::ranges::unique(triangles);
  triangles.erase(repeated.begin(), repeated.end());
  Scene part = scene;
  part.triangles.clear();
  for (const std::size_t t : triangles) part.triangles.push_back(scene.triangles[t]);
  return part;
}

// A subject is judged again. A picture can't be drawn again: its case shows what the canonical
// model has there, and its origin says what was seen.
void Save(const LegalOptions& options, const Scene& scene, const Profile& profile,
          const legal::Core& core) {
  const bool is_drawn = !options.subject.empty();
  const std::string origin =
      "core of " + options.scene.path +
      (is_drawn ? ""
                : " as " + options.image + " shows it; " +
                      CoreText(core, scene, static_cast<std::size_t>(profile.pattern.samples())));
  const Case part{CoreScene(scene, core), profile, {}, origin};
  io::WriteFile(options.save, io::CaseToJson({part, is_drawn ? options.subject : "exact",
                                              is_drawn ? "OneLegalModelExplainsTheMesh" : ""}));
}

OneCall Read(const LegalOptions& options, const Scene& scene, const Profile& profile) {
  io::CountsFile file = io::ReadCounts(
      options.image, {.width = scene.width,
                      .height = scene.height,
                      .samples = TargetProfile(profile, scene).pattern.samples(),
                      .background = options.background,
                      .holds = options.counts ? io::FileHolds::kCounts : io::FileHolds::kDrawing,
                      .triangles = scene.triangles.size()});
  OneCall drawn;
  drawn.drawing.counts = std::move(file.counts);
  drawn.is_mask = file.is_mask;
  return drawn;
}

}  // namespace

Profile WithAssumptions(Profile profile, const LegalOptions& options) {
  if (!options.transform_error) return profile;
  if (profile.freedom.transform_error) {
    throw InputError("--assume-transform-error",
                     fmt::format("profile {} states the error of its transform", profile.name),
                     "leave it out: an assumption is for a profile that states none");
  }
  profile.freedom.transform_error = options.transform_error;
  return profile;
}

std::string AssumedErrorLine(const LegalOptions& options) {
  if (!options.transform_error) return "";
  return fmt::format(
      "assumed, for no specification states it: the transform from clip space puts x and y off by "
      "at most {} x 2^-24 of their size before they are snapped\n",
      *options.transform_error);
}

int RunLegal(const LegalOptions& options) {
  RequireHonestEnvironment();
  const int drawings = (options.image.empty() ? 0 : 1) + (options.subject.empty() ? 0 : 1);
  if (options.decided && drawings != 0) {
    throw InputError("--decided", "it judges no drawing",
                     "leave out --decided, or the image and the subject");
  }
  if (!options.decided && drawings != 1) {
    throw InputError("legal", "it judges one drawing",
                     "give the file of an image, or --subject, --plugin or --exec, not both; "
                     "--decided says what legal models leave open");
  }
  if (options.subject.empty() && options.profile.empty()) {
    throw InputError("legal", "the profile whose models are legal is not known",
                     "give --profile: vulkan, gl, d3d11, webgpu or a file");
  }
  if (options.decided) return TellDecided(options);
  const Scene scene = LoadScene(options.scene);
  std::unique_ptr<Subject> subject;
  if (!options.subject.empty()) {
    subject = MakeSubject(options.subject, options.profile);
    RequireTakes(*subject, scene, options.scene.path);
  }
  const Profile profile = WithAssumptions(
      subject ? subject->Info().profile : io::ReadProfile(options.profile), options);
  if (const auto why = legal::WhyNotJoint(scene, {profile, scene})) {
    throw InputError("profile " + profile.name, *why,
                     "give a profile whose models state single samples of this scene");
  }
  const OneCall drawn = subject ? DrawInOneCall(*subject, scene) : Read(options, scene, profile);
  const legal::JointVerdict verdict =
      legal::JudgeJointly(scene, {profile, scene}, drawn.Observed());
  std::optional<std::uint64_t> open;
  if (verdict.legality != legal::Legality::kLegal)
    open = legal::DecidedSamples(scene, {profile, scene}).NumberOpen();
  if (!options.json.empty()) WriteOutput(options.json, ToJson(verdict, open, profile, options));
  if (!options.save.empty() && verdict.core) Save(options, scene, profile, *verdict.core);
  if (options.json != "-") {
    io::WriteStandardOutput(Text(verdict, open, profile, scene) + report::AssumptionLines(profile) +
                            AssumedErrorLine(options));
  }
  switch (verdict.legality) {
    case legal::Legality::kLegal:
      return kExitHolds;
    case legal::Legality::kNotLegal:
      return kExitViolated;
    case legal::Legality::kNotJudged:
      break;
  }
  return kExitInconclusive;
}

}  // namespace rasterproof::tool
