// A triangle is front at every sample that it covers, or back at every one, as its area says.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "props/judging/freedom/facing_freedom.h"
#include "props/judging/places.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace facing_is_one_at_all_samples {

constexpr std::size_t kMostDrawn = 32;

Verdict HasOneFacing(const CoverageCounts& counts, int triangle) {
  const auto covered = [](std::uint32_t n) { return n != 0; };
  const auto front = std::ranges::find_if(counts.front, covered);
  const auto back = std::ranges::find_if(counts.back, covered);
  if (front == counts.front.end() || back == counts.back.end()) {
    return Verdict::Held(ShownFacing(counts) != 0 ? 1 : 0);
  }
  const auto index = static_cast<std::size_t>(back - counts.back.begin());
  Witness witness = WitnessAtIndex(counts, index);
  witness.triangle = triangle;
  const Witness other =
      WitnessAtIndex(counts, static_cast<std::size_t>(front - counts.front.begin()));
  witness.observed = {"back"};
  witness.expected = {
      "front, as at sample ", other.sample, " of pixel (", other.x, ", ", other.y, ")"};
  return Verdict::Violated(1, "a triangle alone is front at one sample and back at another",
                           witness);
}

const char* NameOfFacing(int facing) { return facing > 0 ? "front" : "back"; }

Verdict WrongFacing(const CoverageCounts& counts, int triangle, int wanted, std::string message) {
  const auto covered = [](std::uint32_t n) { return n != 0; };
  const std::vector<std::uint32_t>& side = wanted > 0 ? counts.back : counts.front;
  const auto at = std::ranges::find_if(side, covered);
  Witness witness = WitnessAtIndex(counts, static_cast<std::size_t>(at - side.begin()));
  witness.triangle = triangle;
  witness.observed = {NameOfFacing(-wanted)};
  witness.expected = {NameOfFacing(wanted)};
  return Verdict::Violated(1, std::move(message), witness);
}

// The sign of the area of the side that the references show as the front; 0: none shows any.
int FrontSign(const std::vector<Reference>& references, const Answers& answers) {
  for (std::size_t k = 0; k < references.size(); ++k) {
    const int shown = ShownFacing(answers.draws[k]->counts);
    if (shown != 0) return shown * references[k].facing;
  }
  return 0;
}

// All references face as one, and as is stated.
Verdict AreAlike(const std::vector<Reference>& references, FrontFace stated,
                 const Answers& answers) {
  const int front = FrontSign(references, answers);
  const bool is_stated = stated == FrontFace::kPositiveArea;
  for (std::size_t k = 0; k < references.size(); ++k) {
    const CoverageCounts& counts = answers.draws[k]->counts;
    Verdict one = HasOneFacing(counts, -1);
    if (one.outcome == Outcome::kViolated) return one;
    const int wanted = (is_stated ? 1 : front) * references[k].facing;
    if (ShownFacing(counts) != -wanted || wanted == 0) continue;
    return WrongFacing(counts, -1, wanted,
                       is_stated ? "the front of a triangle alone is not the side of positive area"
                                 : std::string(kReferenceWords) +
                                       " shows one side on a target, W wide and H high, and the "
                                       "other side on another");
  }
  Verdict held = Verdict::Held(0);
  if (!is_stated && front != 0) held.front_sign = front;
  return held;
}

std::uint64_t HowManyAreCovered(const CoverageCounts& counts) {
  std::uint64_t covered = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) covered += counts.Count(k) != 0 ? 1 : 0;
  return covered;
}

Verdict FacesAsItsArea(const CoverageCounts& counts, std::size_t triangle, int facing, int front) {
  Verdict verdict = HasOneFacing(counts, static_cast<int>(triangle));
  if (verdict.outcome == Outcome::kViolated) return verdict;
  if (facing == 0) verdict.not_judged = HowManyAreCovered(counts);
  if (facing == 0 || front == 0 || ShownFacing(counts) != -facing * front) return verdict;
  return WrongFacing(
      counts, static_cast<int>(triangle), facing * front,
      "a triangle alone does not show the side that its area says, by the side that " +
          std::string(kReferenceWords) + " shows");
}

// At no sample do more triangles show a side than may have it.
Verdict NoSideIsShownTooOften(const PlacedCase& drawn, const CoverageCounts& counts, int front) {
  std::vector<LegalTriangle> triangles;
  for (const Triangle& t : drawn.scene.triangles) triangles.emplace_back(drawn, t);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.Count(k) == 0) continue;
    const Witness at = WitnessAtIndex(counts, k);
    const Point2 p = PlaceOf(drawn, at.x, at.y, at.sample).at;
    std::array<std::uint32_t, 2> most{};
    for (const LegalTriangle& t : triangles) {
      if (!t.MayCover(p)) continue;
      if (t.facing() * front >= 0) ++most[0];
      if (t.facing() * front <= 0) ++most[1];
    }
    if (counts.front[k] <= most[0] && counts.back[k] <= most[1]) continue;
    const bool is_front = counts.front[k] > most[0];
    Witness witness = at;
    witness.observed = {is_front ? counts.front[k] : counts.back[k], " ",
                        NameOfFacing(is_front ? 1 : -1)};
    witness.expected = {"at most ", is_front ? most[0] : most[1]};
    return Verdict::Violated(1,
                             "in one call behind " + std::string(kReferenceWords) +
                                 " more triangles show a side than have it by their areas",
                             witness);
  }
  return Verdict::Held(0);
}

Check InOneCall(const PlacedCase& c, const std::vector<Reference>& references,
                std::vector<std::size_t> bases, std::size_t count) {
  Check check;
  PlacedCase drawn = BehindItsReference(c, references, count);
  check.questions.draws.push_back(CountsOf(drawn.scene, c.profile, WholeTarget(c)));
  check.bases = std::move(bases);
  check.judge = [drawn = std::move(drawn), references](const Answers& answers) {
    const int front = FrontSign(references, answers);
    return front == 0 ? Verdict::Held(0)
                      : NoSideIsShownTooOften(drawn, answers.draws.back()->counts, front);
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  if (c.scene.triangles.empty()) return NotExercised("the scene has no triangles");
  const auto scene = std::make_shared<const Scene>(c.scene);
  const std::vector<Reference> references = ReferencesOf(c);
  std::vector<std::size_t> bases;
  Checks asked;
  if (!references.empty()) {
    Check& check = asked.checks.emplace_back();
    for (const Reference& reference : references) {
      bases.push_back(bases.size());
      check.questions.draws.push_back(CountsOf(reference.value.scene, c.profile, WholeTarget(c)));
    }
    check.judge = [references, stated = c.profile.front_face](const Answers& answers) {
      return AreAlike(references, stated, answers);
    };
  }
  const std::size_t count = std::min(kMostDrawn, scene->triangles.size());
  for (std::size_t t = 0; t < count; ++t) {
    Check& check = asked.checks.emplace_back();
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
    check.bases = bases;
    const int facing = LegalTriangle(c, scene->triangles[t]).facing();
    check.judge = [t, facing, references](const Answers& answers) {
      return FacesAsItsArea(answers.draws.back()->counts, t, facing,
                            FrontSign(references, answers));
    };
  }
  if (!bases.empty()) asked.checks.push_back(InOneCall(c, references, bases, count));
  return asked;
}

}  // namespace facing_is_one_at_all_samples

extern constinit const Property kFacingIsOneAtAllSamples{
    .name = "FacingIsOneAtAllSamples",
    .group = "coverage",
    .clause =
        "Facing is the sign of the triangle's area, one for all its samples (OpenGL 4.6 section "
        "14.6.1; Vulkan 1.3, Basic Polygon Rasterization; D3D11.3 functional specification 3.4.1, "
        "of the snapped area).",
    .required_by = kFacingClauses,
    .tolerance = kExact,
    .domains = kFacings,
    .gate = {.shows = Shows::kFacings,
             .contract = ContractNeeded::kAny,
             .any_model = true,
             .judges_clipped = true,
             .where = "which facing it is: contract sample-exact, a triangle that no legal choice "
                      "of places and no clipping turns"},
    .ask = facing_is_one_at_all_samples::Ask,
};

}  // namespace rasterproof::props
