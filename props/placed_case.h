// A case as properties see it: placed once on its target.
#ifndef RASTERPROOF_PROPS_PLACED_CASE_H_
#define RASTERPROOF_PROPS_PLACED_CASE_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "exact/placed_scene.h"
#include "props/run/own_transform.h"

namespace rasterproof::props {

/// A case under the model of its target. The gate, properties, the oracle and pictures read what
/// is worked out here; a property that changes the scene places it again by With() or Only().
struct PlacedCase : exact::PlacedScene {
  explicit PlacedCase(const Case& c);

  Profile stated;  ///< on any target
  DrawOptions options;
  std::string origin;
  std::optional<CaseName> name;
  /// Triangle k of `scene` is this one of the case as given. Nothing: all are there.
  std::optional<std::vector<std::size_t>> numbers;
  /// The places given to a subject with its own transform. Nothing: `scene`.
  std::optional<PlacesOfTransform> before;

  /// The same about another scene.
  PlacedCase With(Scene other) const;
  /// The same about some of its triangles, by their places in its list.
  PlacedCase Only(const std::vector<std::size_t>& triangles) const;
  /// The same under another freedom.
  PlacedCase Under(const Freedom& freedom) const;
  /// The case, to be compared and saved.
  Case Value() const { return {scene, profile, options, origin, name}; }

 private:
  PlacedCase(Scene other, const PlacedCase& c);
};

/// The case on its target, in window space where the subject owns the transform; without triangles
/// of zero area where the profile leaves open what they cover, unless the property judges those.
PlacedCase Place(const Case& given, bool judges_degenerates);

/// Why the placed case is not judged: what its triangles of zero area are is not decided.
std::optional<Verdict> FlatnessNotDecided(const PlacedCase& c, bool judges_degenerates);

/// The verdict on the case as given: its witness names the triangle by its place there, or in
/// the scene that was drawn instead.
Verdict RenumberWitness(const PlacedCase& c, Verdict verdict);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PLACED_CASE_H_
