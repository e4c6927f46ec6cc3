#include "props/run/judged_case.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/profile.h"
#include "core/square_rule.h"
#include "exact/snap_clip.h"
#include "model/target_model.h"
#include "props/judging/flat_triangles.h"
#include "props/judging/redraw.h"
#include "props/run/own_transform.h"

namespace rasterproof::props {

Description DescriptionOf(Subject& subject) {
  return {subject.Info(), subject.Edges(), subject.Barycentrics(), subject.Twin() != nullptr};
}

Description AsJudged(Description subject) {
  if (!OwnsTransform(subject.info)) return subject;
  subject.info = AsSeenByRecipes(subject.info);
  subject.edges = nullptr;
  subject.barycentrics = nullptr;
  return subject;
}

namespace {

// Whether the profile says what triangles of zero area cover, be it by its rule of squares.
bool StatesFlatTriangles(const Profile& profile) {
  return profile.degenerate_triangles == DegenerateTriangles::kNothing ||
         (profile.squares && profile.squares->flat != FlatSquares::kFree);
}

}  // namespace

JudgedCase Judged(const Case& given, const Description& subject, bool judges_degenerates) {
  JudgedCase judged{given, subject, subject.info.profile, {}, {}, {}};
  Case& c = judged.value;
  if (TakesToWindow(given.profile, given.scene)) {
    c = SeenCase(given);
    judged.subject = AsJudged(subject);
    judged.places.emplace(given.scene, c.scene);
  }
  c.profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  if (StatesFlatTriangles(c.profile) || judges_degenerates) return judged;
  const bool is_snapped_clip = c.scene.clip_space && !c.profile.snap.IsNone();
  if (is_snapped_clip && exact::SnapClipError(c.scene, c.profile)) {
    judged.instead = {Outcome::kNotExercised, 0, 0,
                      "the area after the division and snapping is not decided", std::nullopt};
    return judged;
  }
  const std::vector<std::size_t> flat = FlatTriangles(c);
  if (flat.empty()) return judged;
  std::vector<std::size_t>& kept = judged.numbers.emplace();
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!std::ranges::binary_search(flat, t)) kept.push_back(t);
  }
  c = OnlyTriangles(c, kept);
  return judged;
}

Verdict RenumberWitness(const JudgedCase& judged, Verdict verdict) {
  if (!judged.numbers) return verdict;
  if (verdict.witness && verdict.witness->triangle >= 0 && verdict.drawn == nullptr) {
    const auto among_kept = static_cast<std::size_t>(verdict.witness->triangle);
    verdict.witness->triangle = static_cast<int>((*judged.numbers)[among_kept]);
  }
  if (verdict.outcome == Outcome::kViolated) {
    verdict.message += "; it numbers the triangles without those of zero area";
  }
  return verdict;
}

}  // namespace rasterproof::props
