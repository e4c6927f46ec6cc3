// A scene covers the same before and after any other scene: one that is not finite, flat or huge,
// one of another size or count, one that the subject refuses.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "core/target_size.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace predecessors_keep_coverage {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHuge = 0x1p100;
// More than any vector has lanes, and than a first buffer of a hundred holds.
constexpr std::size_t kMany = 128;
// Of the predecessors, one in so many is drawn before a case.
constexpr std::size_t kEvery = 5;

struct Predecessor {
  Scene scene;
  const char* words;  ///< completes "that before a scene ..."
};

Vertex& FirstVertexOf(Scene& scene, const Triangle& t) {
  return scene.vertices[static_cast<std::size_t>(t[0])];
}

Scene WithNan(Scene scene) {
  FirstVertexOf(scene, scene.triangles.front()).x = kNan;
  return scene;
}

Scene WithInfinities(Scene scene) {
  Vertex& v = FirstVertexOf(scene, scene.triangles.back());
  v.x = kInfinity;
  v.y = -kInfinity;
  return scene;
}

Scene Flat(Scene scene) {
  for (Triangle& t : scene.triangles) t[2] = t[1];
  return scene;
}

// Its vertices at corners of a square around the target, as far off as that.
Scene AsFarAs(Scene scene, double distance) {
  for (std::size_t k = 0; k < scene.vertices.size(); ++k) {
    scene.vertices[k].x = k % 2 == 0 ? -distance : distance;
    scene.vertices[k].y = k % 3 == 2 ? distance : -distance;
  }
  return scene;
}

Scene OfManyTriangles(Scene scene) {
  const std::vector<Triangle> all = std::move(scene.triangles);
  scene.triangles.clear();
  while (scene.triangles.size() < kMany) {
    scene.triangles.push_back(all[scene.triangles.size() % all.size()]);
  }
  return scene;
}

Scene OfItsLastTriangle(Scene scene) {
  scene.triangles = {scene.triangles.back()};
  return scene;
}

// The same size, count, indices and first triangle, the rest a pixel to the right.
Scene MovedBehindTheFirst(Scene scene) {
  const Triangle& first = scene.triangles.front();
  for (std::size_t k = 0; k < scene.vertices.size(); ++k) {
    if (std::ranges::find(first, static_cast<std::int32_t>(k)) != first.end()) continue;
    double& x = scene.vertices[k].x;
    x = scene.precision == Precision::kFloat32 ? double{static_cast<float>(x + 1)} : x + 1;
  }
  return scene;
}

Scene OnATarget(Scene scene, int width, int height) {
  scene.width = width;
  scene.height = height;
  return scene;
}

// Two of those that can be given to the subject, who may refuse them: all would take four times as
// long as most properties. Which two goes by the case's size, so that cases take turns, and a
// case keeps them while its coordinates are made simpler.
std::vector<Predecessor> PredecessorsOf(const PlacedCase& c) {
  const Scene& scene = c.scene;
  const double limit = std::min(c.profile.coordinate_limit, 0x1p20);
  std::vector<Predecessor> all{
      {WithNan(scene), "with a NaN"},
      {WithInfinities(scene), "with infinities"},
      {Flat(scene), "of triangles without area"},
      {AsFarAs(scene, kHuge), "with coordinates of 2^100"},
      {AsFarAs(scene, std::floor(limit)), "with coordinates at the stated limit"},
      {OfManyTriangles(scene), "of 128 triangles"},
      {OfItsLastTriangle(scene), "of one triangle"},
      {MovedBehindTheFirst(scene), "that agrees with it in size, indices and the first triangle"},
      {OnATarget(scene, scene.width + 7, scene.height + 5), "on a larger target"},
      {OnATarget(scene, 1, 1), "on a target of one pixel"}};
  std::erase_if(all, [&](const Predecessor& p) {
    return !IsTargetSize(p.scene.width, p.scene.height, c.profile.pattern.samples()) ||
           WhyTooLarge(p.scene, c.profile) || !CanBeGiven(p.scene, c.profile);
  });
  if (all.empty()) return all;
  const std::size_t turn = static_cast<std::size_t>(scene.width) +
                           3 * static_cast<std::size_t>(scene.height) + 5 * scene.triangles.size();
  std::ranges::rotate(all, all.begin() + static_cast<std::ptrdiff_t>(turn % all.size()));
  std::vector<Predecessor> chosen;
  for (std::size_t k = 0; k < all.size(); k += kEvery) chosen.push_back(std::move(all[k]));
  return chosen;
}

// The case, and after each predecessor the case again; then a copy of the subject, if there is one,
// that saw none of them.
Check CheckOf(const PlacedCase& c, const std::vector<Predecessor>& predecessors, bool has_twin) {
  Check check;
  Questions& questions = check.questions;
  questions.company = Company::kInOrderAlone;
  const DrawQuestion once = WholeCallOf(c.scene, c.profile, c.options);
  questions.draws.push_back(once);
  for (const Predecessor& p : predecessors) {
    check.may_be_refused.push_back(questions.draws.size());
    questions.draws.push_back(WholeCallOf(p.scene, c.profile, WholeTarget(c)));
    questions.draws.push_back(once);
  }
  if (has_twin) {
    questions.draws.push_back(once);
    questions.draws.back().by_twin = true;
  }
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.scene.triangles.empty()) return NotExercised("the scene has no triangles");
  const auto open = WhereCallsMayDiffer(c, MayChooseByCall(c.profile));
  if (!open) return NotExercised(kPlacesNotKnown);
  const std::vector<Predecessor> predecessors = PredecessorsOf(c);
  Check check = CheckOf(c, predecessors, subject.has_twin);
  std::vector<std::string> words;
  for (const Predecessor& p : predecessors) {
    words.push_back("that before a scene " + std::string(p.words));
  }
  if (subject.has_twin) {
    words.emplace_back("that of a copy of the subject that drew nothing else of the case");
  }
  check.judge = [words, open = *open, decisions = open->Judged(DecisionsOf(c))](const Answers& a) {
    const CoverageCounts& first = a.draws.front()->counts;
    for (std::size_t k = 0; k < words.size(); ++k) {
      const std::size_t draw = std::min(2 * (k + 1), a.draws.size() - 1);
      const CoverageCounts& observed = a.draws[draw]->counts;
      Verdict same = SameCounts(observed, open.Expected(observed, first), 0, words[k]);
      if (same.outcome == Outcome::kViolated) return OfDraw(draw, std::move(same));
    }
    return Verdict::Held(decisions);
  };
  Checks asked;
  asked.checks.push_back(std::move(check));
  return asked;
}

// Equal draws are equal, or, where no clause says so, what is compared is decided by every legal
// model.
constexpr auto kClauses = Both(kRepeatableClauses, kLegalModelClauses);

}  // namespace predecessors_keep_coverage

extern constinit const Property kPredecessorsKeepCoverage{
    .name = "PredecessorsKeepCoverage",
    .group = "extremes",
    .clause = "A scene covers the same after any other, whatever became of that.",
    .required_by = predecessors_keep_coverage::kClauses,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .is_about_sequence = true,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kAny,
             .judges_clipped = true,
             .judges_degenerates = true},
    .ask = predecessors_keep_coverage::Ask,
};

}  // namespace rasterproof::props
