#include "props/placed_case.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/square_rule.h"

namespace rasterproof::props {
namespace {

// Whether the profile says what triangles of zero area cover, be it by its rule of squares.
bool StatesFlatTriangles(const Profile& profile) {
  return profile.degenerate_triangles == DegenerateTriangles::kNothing ||
         (profile.squares && profile.squares->flat != FlatSquares::kFree);
}

}  // namespace

PlacedCase::PlacedCase(const Case& c)
    : PlacedScene(c.scene, c.profile),
      stated(c.profile),
      options(c.options),
      origin(c.origin),
      name(c.name) {}

PlacedCase::PlacedCase(Scene other, const PlacedCase& c)
    : PlacedScene(std::move(other), c.stated),
      stated(c.stated),
      options(c.options),
      origin(c.origin),
      name(c.name) {}

PlacedCase PlacedCase::With(Scene other) const { return {std::move(other), *this}; }

PlacedCase PlacedCase::Only(const std::vector<std::size_t>& triangles) const {
  Scene part = scene;
  part.triangles.clear();
  for (const std::size_t t : triangles) part.triangles.push_back(scene.triangles[t]);
  return With(std::move(part));
}

PlacedCase PlacedCase::Under(const Freedom& freedom) const {
  PlacedCase c = *this;
  c.profile.freedom = c.stated.freedom = freedom;
  if (freedom.IsNone())  // one model has one front
    c.profile.front_face = c.stated.front_face = FrontFace::kPositiveArea;
  return c;
}

PlacedCase Place(const Case& given, bool judges_degenerates) {
  const bool owns_transform = TakesToWindow(given.profile, given.scene);
  PlacedCase c(owns_transform ? SeenCase(given) : given);
  if (owns_transform) c.before.emplace(given.scene, c.scene);
  if (c.flat.empty() || judges_degenerates || StatesFlatTriangles(c.profile)) return c;
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!std::ranges::binary_search(c.flat, t)) kept.push_back(t);
  }
  PlacedCase part = c.Only(kept);
  part.numbers = std::move(kept);
  part.before = std::move(c.before);
  return part;
}

std::optional<Verdict> FlatnessNotDecided(const PlacedCase& c, bool judges_degenerates) {
  if (judges_degenerates || StatesFlatTriangles(c.profile)) return std::nullopt;
  if (!c.why_not_placed || !PlacesClipSpace(c.profile)) return std::nullopt;
  return Verdict::NotExercised("the area after the division and snapping is not decided");
}

Verdict RenumberWitness(const PlacedCase& c, Verdict verdict) {
  if (!c.numbers) return verdict;
  if (verdict.witness && verdict.witness->triangle >= 0 && verdict.drawn == nullptr) {
    const auto among_kept = static_cast<std::size_t>(verdict.witness->triangle);
    verdict.witness->triangle = static_cast<int>((*c.numbers)[among_kept]);
  }
  if (verdict.outcome == Outcome::kViolated) {
    verdict.message += "; it numbers the triangles without those of zero area";
  }
  return verdict;
}

}  // namespace rasterproof::props
