// The choices of a profile: grids and tie rules, and on one grid the points of each vertex.
#ifndef RASTERPROOF_LEGAL_CHOICES_H_
#define RASTERPROOF_LEGAL_CHOICES_H_

#include <array>
#include <cstddef>
#include <vector>

#include "core/scene.h"
#include "core/snap.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// The choices that are made once for a whole scene.
struct Family {
  Snap grid;
  TieRule rule;
};

/// Returns every family that the profile allows for the scene, the canonical one first.
///
/// Clip space is not judged without a grid: it has no places in such a family.
std::vector<Family> FamiliesOf(const TargetProfile& profile, const Scene& scene);

/// Where the legal models of one family put the vertices of a scene.
struct Choices {
  /// By vertex of the scene: its position. Vertices of equal coordinates have one.
  std::vector<std::size_t> position;
  /// By position: its legal places in screen axes, the canonical one first. None: the vertex is not
  /// finite.
  std::vector<std::vector<Point2>> places;

  const std::vector<Point2>& Of(std::size_t vertex) const { return places[position[vertex]]; }
};

/// Domain:     window space; clip space with a grid, every vertex in front of the eye, and each
///             x / w and y / w within the integers of 50 bits that exact::TrySnapQuotient decides.
/// Error:      InputError for a clip-space scene outside the domain.
Choices ChoicesOf(const Scene& scene, const TargetProfile& profile, const Family& family);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_CHOICES_H_
