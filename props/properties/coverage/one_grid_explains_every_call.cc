// One legal grid explains every call on a target, whatever its triangles, their number and their
// order.
//
// Each call may place its vertices by itself; the grid is one. Beside the case's own scene, in one
// of five forms by turns, calls draw a ruler (grid_ruler.h) that tells grids apart: the same scene
// for all cases on targets of one size. So two cases whose grids differ cannot both hold, and what
// the ruler leaves of the grids is counted by target over the run.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/grids_left.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "legal/joint.h"
#include "props/judging/freedom/grid_ruler.h"
#include "props/judging/observed_call.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/property.h"

namespace rasterproof::props {
namespace one_grid_explains_every_call {

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.freedom.least_bits && !p.snap.IsNone(); },
                "a number of subpixel bits left open",
                "the profile states its number of bits, or has no grid"},
    ProfileRule{[](const Profile& p) { return !MayChooseByCall(p); }, "equal draws that are equal",
                "no clause says that equal draws are equal: every call may have a grid of its own"},
    kCountsTies, kSaysWhatSinglesCover, kStatesSamplePositions};

// Of longer lists no other form is drawn.
constexpr std::size_t kMostInAList = 32;
// The scene as it is, in a crowd, last first, with vertices of its own, and one triangle alone.
constexpr std::size_t kForms = 5;
// Small triangles behind the others of a call.
constexpr std::size_t kCrowd = 64;
// In one of so many cases all that the ruler leaves of the grids is worked out.
constexpr std::size_t kCasesOfAMeasurement = 8;

struct Asked {
  Scene scene;
  std::string what;       ///< "triangle 0 alone", for the message
  bool is_ruler = false;  ///< the whole of it, as it is
};

// Triangle t with three vertices and no other.
Scene AloneOf(const Scene& scene, std::size_t t) {
  Scene one = scene;
  one.vertices.clear();
  one.triangles = {{0, 1, 2}};
  for (const std::int32_t index : scene.triangles[t]) {
    one.vertices.push_back(scene.vertices[static_cast<std::size_t>(index)]);
  }
  return one;
}

// Behind a vertex that no triangle uses, so that indices are others.
Scene BehindAVertex(Scene scene) {
  scene.vertices.insert(scene.vertices.begin(), scene.vertices.front());
  for (Triangle& t : scene.triangles) {
    for (std::int32_t& index : t) ++index;
  }
  return scene;
}

Scene UnindexedOf(const Scene& scene) {
  Scene unindexed = scene;
  unindexed.vertices.clear();
  for (Triangle& t : unindexed.triangles) {
    for (std::int32_t& index : t) {
      unindexed.vertices.push_back(scene.vertices[static_cast<std::size_t>(index)]);
      index = static_cast<std::int32_t>(unindexed.vertices.size()) - 1;
    }
  }
  return unindexed;
}

Scene ReversedOf(Scene scene) {
  std::ranges::reverse(scene.triangles);
  return scene;
}

// With small triangles behind the others, all of them one.
Scene CrowdedOf(Scene scene) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2 p : {Point2{0x1p-4, 0x1p-4}, Point2{0x3p-4, 0x1p-4}, Point2{0x1p-4, 0x3p-4}}) {
    scene.vertices.push_back({p.x, p.y, 0, 1});
  }
  scene.triangles.insert(scene.triangles.end(), kCrowd, {first, first + 1, first + 2});
  return scene;
}

std::string Triangles(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
}

// One call with triangles of the scene, in one form of five.
Asked InAForm(const Scene& scene, std::uint64_t form, const std::string& whose, bool takes_others) {
  const std::size_t count = scene.triangles.size();
  const std::string what = Triangles(count) + whose;
  if (count > kMostInAList) return {scene, what};
  switch (form % kForms) {
    case 0:
      if (!takes_others) break;
      return {CrowdedOf(scene),
              what + " and " + std::to_string(kCrowd) + " small ones behind them"};
    case 1:
      return {ReversedOf(scene), what + ", last first"};
    case 2:
      return {UnindexedOf(scene), what + ", each with three vertices of its own"};
    case 3: {
      const auto t = static_cast<std::size_t>(form / kForms % count);
      return {AloneOf(scene, t), "triangle " + std::to_string(t) + whose + ", alone"};
    }
    default:
      break;
  }
  return {scene, what};
}

// A number that the case's own bits decide, so that each form has its turn, in a replay and in the
// WebAssembly module, whose std::size_t has 32 bits, the same.
std::uint64_t TurnOf(const PlacedCase& c) {
  std::uint64_t bits = c.scene.vertices.size();
  const auto mix = [&](std::uint64_t more) {
    bits = (bits ^ more) * 0x9e3779b97f4a7c15U;
    bits ^= bits >> 32;
  };
  for (const Vertex& v : c.scene.vertices) {
    mix(std::bit_cast<std::uint64_t>(v.x));
    mix(std::bit_cast<std::uint64_t>(v.y));
  }
  return bits;
}

// Of a subject with its own transform only the places of the case's vertices can be asked for, and
// in clip space and in fixed point not every place can be.
bool TakesOtherPlaces(const PlacedCase& c) {
  return !c.scene.clip_space && !c.profile.fixed && !c.before;
}

// The ruler's list is the first call, if there is one.
std::vector<Asked> CallsOf(const PlacedCase& c) {
  const std::uint64_t turn = TurnOf(c);
  const bool takes_others = TakesOtherPlaces(c);
  std::vector<Asked> asked;
  if (takes_others) {
    const GridRuler ruler =
        GridRulerOn(c.profile, c.scene.width, c.scene.height, c.scene.precision);
    if (!ruler.seams.triangles.empty()) {
      const std::string whose = " of the grid's ruler";
      asked.push_back({ruler.seams, Triangles(ruler.seams.triangles.size()) + whose, true});
      const Scene& one = ruler.alone[static_cast<std::size_t>(turn % ruler.alone.size())];
      asked.push_back({turn / 4 % 2 == 0 ? one : BehindAVertex(one), "one triangle" + whose});
      if (turn / 8 % 4 == 0) asked.push_back(InAForm(ruler.seams, turn / 32, whose, true));
    }
  }
  if (!c.scene.triangles.empty()) {
    asked.push_back(InAForm(c.scene, turn / 512, " of the case", takes_others));
  }
  std::erase_if(asked, [&](const Asked& one) {
    return !WithinLimits(one.scene, c.profile) || legal::WhyNotJoint(one.scene, c.profile);
  });
  return asked;
}

// Families have one tie rule each: as sets of grids. Grids finer than those that were tried are as
// none.
GridsLeft GridsOf(const std::vector<legal::Family>& families, int finest) {
  GridsLeft grids;
  for (const legal::Family& family : families) {
    if (!family.grid.IsNone()) {
      grids.Add(family.grid.bits);
      continue;
    }
    for (int bits = finest + 1; bits <= GridsLeft::kMostBits; ++bits) grids.Add(bits);
  }
  return grids;
}

int FinestOf(const std::vector<legal::Family>& families) {
  int finest = 0;
  for (const legal::Family& family : families) {
    if (!family.grid.IsNone()) finest = std::max(finest, family.grid.bits);
  }
  return finest;
}

Verdict NoGrid(const std::vector<Asked>& asked, const legal::CallsVerdict& verdict,
               const std::vector<legal::Family>& all, std::uint64_t exercised) {
  const int finest = FinestOf(all);
  std::string needs;
  for (const std::size_t k : verdict.conflict) {
    const GridsLeft grids = GridsOf(verdict.explaining[k], finest);
    if (!needs.empty()) needs += "; ";
    needs += asked[k].what +
             (grids.IsEmpty() ? ": no grid explains it" : ": " + grids.Text() + " subpixel bits");
  }
  Witness witness;
  witness.observed = {needs};
  witness.expected = {"one number of subpixel bits that explains every call on this target"};
  const bool is_one = verdict.conflict.size() == 1;
  return Verdict::Violated(exercised,
                           is_one ? "no legal grid explains a call by itself: " + needs
                                  : "no legal grid explains these calls together: " + needs,
                           witness);
}

Verdict Judge(const PlacedCase& c, const std::vector<Asked>& asked, const SubjectInfo& info,
              const Answers& answers) {
  std::vector<legal::Call> calls;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    calls.push_back({&asked[k].scene, ObservedOf(*answers.draws[k], info)});
  }
  const legal::CallsVerdict together = legal::JudgeCalls(calls, c.profile);
  // Where no triangle of the case is near the target, two calls of the ruler are compared.
  const std::uint64_t exercised = std::max<std::uint64_t>(1, DecisionsOf(c));
  if (together.legality == legal::Legality::kNotLegal) {
    Scene all = c.scene;
    for (const Asked& one : asked) {
      all.vertices.insert(all.vertices.end(), one.scene.vertices.begin(), one.scene.vertices.end());
    }
    Verdict violated = NoGrid(asked, together, legal::FamiliesOf(c.profile, all), exercised);
    violated.failed_draw = together.conflict.back();
    return violated;
  }
  Verdict held = Verdict::Held(exercised);
  if (together.legality == legal::Legality::kNotJudged) {
    held = Verdict::Held(0);
    held.not_judged = exercised;
    held.message = "a component of some call is too large to be judged";
  }
  if (asked.front().is_ruler && TurnOf(c) % kCasesOfAMeasurement == 0) {
    const std::vector<legal::Family> families = legal::FamiliesOf(c.profile, *calls.front().scene);
    held.grids = GridsOf(legal::ExplainingFamilies(calls.front(), c.profile), FinestOf(families));
  }
  return held;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (const std::optional<std::string> why = legal::WhyNotJoint(c.scene, c.profile)) {
    Checks asked = NotExercised(*why);
    asked.otherwise.not_judged = DecisionsOf(c);
    return asked;
  }
  const auto asked = std::make_shared<const std::vector<Asked>>(CallsOf(c));
  if (asked->size() < 2) return NotExercised("there is one call, and nothing to compare it with");
  Questions questions;
  for (const Asked& one : *asked) {
    questions.draws.push_back(WholeCallOf(one.scene, c.profile, WholeTarget(c)));
  }
  return OneCheck(std::move(questions), [&c, asked, &info = subject.info](const Answers& answers) {
    return Judge(c, *asked, info, answers);
  });
}

}  // namespace one_grid_explains_every_call

extern constinit const Property kOneGridExplainsEveryCall{
    .name = "OneGridExplainsEveryCall",
    .group = "coverage",
    .clause =
        "A device has one number of subpixel bits, which it reports, and no call changes it: "
        "Vulkan "
        "1.3 subPixelPrecisionBits; OpenGL 4.6 table 23.53 SUBPIXEL_BITS, read as one number for "
        "each size of target.",
    .required_by = kOneGridClauses,
    .tolerance = "the profile's own freedom, with one grid for all calls on a target",
    .domains = kFreeSnaps,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kWatertight,
             .any_model = true,
             .judges_clipped = true,
             .rules = one_grid_explains_every_call::kRules,
             .where = "clip space in front of the eye and on a grid"},
    .ask = one_grid_explains_every_call::Ask,
};

}  // namespace rasterproof::props
