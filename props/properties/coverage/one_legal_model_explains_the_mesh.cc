// One legal model explains all triangles of a mesh: a grid, a place for each vertex, owners of
// samples on edges.
//
// One explains every sample of every triangle, each drawn alone, and one all that a call with them
// together shows. Of many triangles the call alone is judged. Where no clause says that equal draws
// are equal, every call may have its own model.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "legal/joint.h"
#include "props/judging/as_shown.h"
#include "props/judging/observed_call.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace one_legal_model_explains_the_mesh {

constexpr std::array kRules{ProfileRule{[](const Profile& p) { return !p.freedom.IsNone(); },
                                        "a grid, grid points or owners left free",
                                        "the profile leaves nothing free: one model is legal"},
                            kCountsTies, kSaysWhatSinglesCover, kStatesSamplePositions};

// Of more, what one call shows is judged.
constexpr std::size_t kMostDrawnAlone = 32;

std::string Names(std::vector<std::size_t> triangles) {
  std::ranges::sort(triangles);
  const auto repeated = std::ranges::unique(triangles);
  triangles.erase(repeated.begin(), repeated.end());
  std::string names;
  for (const std::size_t t : triangles) names += (names.empty() ? "" : ", ") + std::to_string(t);
  return names;
}

std::vector<std::size_t> TrianglesOf(const legal::Core& core) {
  std::vector<std::size_t> triangles;
  for (const legal::Requirement& requirement : core.requirements)
    triangles.insert(triangles.end(), requirement.triangles.begin(), requirement.triangles.end());
  return triangles;
}

// "triangle 3 covers (0x1.8p+0, 0x1p-1)", "triangles 3, 4 cover it 2 times".
std::string SeenText(const legal::Requirement& requirement) {
  const std::string place = HexText(requirement.at);
  if (requirement.triangles.empty()) return place + " as no legal model of any triangle has it";
  const std::string names = Names(requirement.triangles);
  if (requirement.visible) {
    return "of triangles " + names + " " +
           (*requirement.visible == kNoPrimitive
                ? "none"
                : "number " + std::to_string(*requirement.visible)) +
           " is visible at " + place;
  }
  if (requirement.triangles.size() == 1) {
    const std::string triangle = "triangle " + names;
    if (requirement.least > 1) {
      return triangle + " covers " + place + " " + std::to_string(requirement.least) + " times";
    }
    return triangle + (requirement.most == 0 ? " does not cover " : " covers ") + place;
  }
  return "triangles " + names + " cover " + place + " " + std::to_string(requirement.least) +
         (requirement.least == requirement.most ? "" : " or more") + " times together";
}

std::string SeenText(const PlacedCase& c, const legal::Core& core) {
  constexpr std::size_t kMostTold = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(core.requirements.size(), kMostTold); ++k)
    text += (text.empty() ? "" : "; ") + SeenText(core.requirements[k]);
  if (core.requirements.size() > kMostTold)
    text += "; and " + std::to_string(core.requirements.size() - kMostTold) + " more";
  for (std::size_t k = 0; k < std::min(core.vertices.size(), kMostTold); ++k) {
    text += (k == 0 ? "; decided by where these vertices lie: " : " ") +
            HexText(WindowPoint(c.scene.vertices[core.vertices[k]]));
  }
  return text;
}

Verdict NoModel(const PlacedCase& c, const CoverageCounts& shape, std::uint64_t exercised,
                const legal::Core& core) {
  const legal::Requirement& first = core.requirements.front();
  Witness witness = WitnessAtIndex(shape, first.sample);
  const std::vector<std::size_t> triangles = TrianglesOf(core);
  if (!triangles.empty()) witness.triangle = static_cast<int>(triangles.front());
  const std::string names = Names(triangles);
  const bool is_one = triangles.empty() || names == std::to_string(triangles.front());
  witness.observed = {SeenText(c, core)};
  witness.expected = {
      "one legal grid, a place for each vertex and owners of samples on edges that explain ",
      is_one ? "it" : "them together"};
  return Verdict::Violated(exercised,
                           triangles.empty() ? "no legal model explains a sample by itself"
                           : is_one ? "no legal model explains triangle " + names + " by itself"
                                    : "no legal model explains triangles " + names + " together",
                           witness);
}

Verdict VerdictOf(const PlacedCase& c, const CoverageCounts& shape, std::uint64_t exercised,
                  const legal::JointVerdict& joint) {
  if (joint.legality == legal::Legality::kNotLegal)
    return NoModel(c, shape, exercised, *joint.core);
  Verdict verdict = Verdict::Held(exercised - std::min(exercised, joint.not_judged));
  verdict.not_judged = joint.not_judged;
  if (joint.legality == legal::Legality::kNotJudged) {
    verdict.outcome = Outcome::kNotExercised;
    verdict.message = "a component of " + std::to_string(joint.largest_given_up) +
                      " triangles is too large to be judged";
  }
  return verdict;
}

// Violated if no model explains what was drawn for triangle t alone.
Verdict HasAModel(const PlacedCase& c, std::size_t t, const CoverageCounts& counts) {
  Scene one = c.scene;
  one.triangles = {c.scene.triangles[t]};
  legal::Observed observed;
  observed.alone = {&counts};
  legal::JointVerdict joint = legal::JudgeJointly(one, c.profile, observed);
  if (joint.core) {
    for (legal::Requirement& requirement : joint.core->requirements) {
      for (std::size_t& triangle : requirement.triangles) triangle = t;
    }
  }
  return VerdictOf(c, counts, DecisionsOf(c), joint);
}

// Violated if some triangle, drawn alone, has no model.
Verdict HaveModels(const PlacedCase& c, const Answers& alone) {
  for (std::size_t t = 0; t < alone.draws.size(); ++t) {
    Verdict verdict = HasAModel(c, t, alone.draws[t]->counts);
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(0);  // the other check counts
}

// Violated if no model explains what was drawn for each triangle alone.
Verdict HaveOneModel(const PlacedCase& c, const Answers& alone) {
  legal::Observed observed;
  for (const auto& drawing : alone.draws) observed.alone.push_back(&drawing->counts);
  Verdict verdict = VerdictOf(c, alone.draws[0]->counts, DecisionsOf(c),
                              legal::JudgeJointly(c.scene, c.profile, observed));
  if (verdict.outcome == Outcome::kHolds) verdict = Verdict::Held(0);  // the other check counts
  return verdict;
}

Check OfEachAlone(const PlacedCase& c) {
  const auto scene = std::make_shared<const Scene>(c.scene);
  Check check;
  for (std::size_t t = 0; t < scene->triangles.size(); ++t) {
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
  }
  check.judge = [&c](const Answers& answers) {
    return MayChooseByCall(c.profile) ? HaveModels(c, answers) : HaveOneModel(c, answers);
  };
  return check;
}

// One call with all triangles, by the kind of coverage that it shows.
Check OfOneCall(const PlacedCase& c, const Description& subject) {
  Check check;
  check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, WholeTarget(c)));
  check.judge = [&c, &info = subject.info](const Answers& answers) {
    const Drawing& drawing = *answers.draws[0];
    return VerdictOf(c, drawing.counts, DecisionsOf(c),
                     legal::JudgeJointly(c.scene, c.profile, ObservedOf(drawing, info)));
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (const std::optional<std::string> why = legal::WhyNotJoint(c.scene, c.profile)) {
    Checks asked = NotExercised(*why);
    asked.otherwise.not_judged = DecisionsOf(c);
    return asked;
  }
  Checks asked;
  if (c.scene.triangles.empty()) return NotExercised("the scene has no triangles");
  if (c.scene.triangles.size() <= kMostDrawnAlone) asked.checks.push_back(OfEachAlone(c));
  asked.checks.push_back(OfOneCall(c, subject));
  return asked;
}

}  // namespace one_legal_model_explains_the_mesh

extern constinit const Property kOneLegalModelExplainsTheMesh{
    .name = "OneLegalModelExplainsTheMesh",
    .group = "coverage",
    .clause =
        "A vertex has one position for all triangles that use it, and a sample on an edge the "
        "owner that the profile's tie_ownership asks for: D3D11.3 functional specification 3.2.4.1 "
        "(snapping within 0.6 ulp) and 3.4.2.1, OpenGL 4.6 section 14.6.1, Vulkan 1.3 Basic "
        "Polygon Rasterization (a common edge).",
    .required_by = kLegalModelClauses,
    .tolerance = "the profile's own freedom, jointly for all triangles",
    .domains = kFreeSnaps,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kWatertight,
             .any_model = true,
             .judges_clipped = true,
             .judges_degenerates = true,
             .rules = one_legal_model_explains_the_mesh::kRules,
             .where = "clip space in front of the eye and on a grid"},
    .ask = one_legal_model_explains_the_mesh::Ask,
};

}  // namespace rasterproof::props
