// The facings that the legal models of a profile leave open.
#ifndef RASTERPROOF_PROPS_JUDGING_FACING_FREEDOM_H_
#define RASTERPROOF_PROPS_JUDGING_FACING_FREEDOM_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/free_choices.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// A triangle whose facing may be that of the polygon that clipping leaves inside the target is
/// open if this polygon, grown by a grid step, is thinner than this many steps: its vertices snap
/// too, less than a step on each axis. Both edges of a wedge that crosses the target can move by a
/// step toward each other, which takes two steps times its length from an area that is at least
/// half its thickness times its length. A wedge of almost three steps may lose its area, which a
/// limit of two steps would miss (facing_freedom_test.cc).
inline constexpr double kThinnestClippedSteps = 4;

/// A triangle of a case, as legal models may face and place it.
class LegalTriangle {
 public:
  /// Domain:     a window-space case within the profile's limits.
  LegalTriangle(const PlacedCase& c, const Triangle& t);

  /// The sign of its area in every legal model, +1 or -1, as CoverageCounts has it. 0: it is open,
  /// because two models differ in it, because it has no area in one, or because clipping may turn
  /// or move it.
  int facing() const { return facing_; }
  /// Returns whether every legal model covers the sample at `p`, wherever in its pixel it may lie.
  ///
  /// Domain:     a place of the window in the pixel that holds it.
  bool CoversInEveryModel(Point2 p) const;
  /// Returns whether some legal model may cover the sample at `p`. Cruder: by the box.
  bool MayCover(Point2 p) const;

 private:
  bool has_places_ = false;
  bool knows_samples_ = true;  ///< where in their pixels they lie
  int facing_ = 0;
  int turn_ = 0;  ///< of the places, in window axes
  std::array<LegalPlaces, 3> places_{};
};

/// The triangle (0, 0), (2W, 0), (0, 2H) on a target W wide and H high: it covers every sample, and
/// its counts show which side the subject takes for the front.
struct Reference {
  PlacedCase value;
  int facing = 0;  ///< the same in every legal model: +1 or -1
};
inline constexpr const char* kReferenceWords = "the triangle (0, 0) (2 W, 0) (0, 2 H)";

/// The reference on a target of 4 x 4, the same question in every case, so that all answers can be
/// compared; then on the case's own. A limit may leave out either, and so may a grid that is coarse
/// for the target. None where single samples are not stated.
std::vector<Reference> ReferencesOf(const PlacedCase& c);

/// The case's first triangles, up to a number, after its last reference if that has its target.
PlacedCase BehindItsReference(const PlacedCase& c, const std::vector<Reference>& references,
                              std::size_t count);

/// The facing that a drawing of one triangle shows: +1 front counts alone, -1 back counts alone,
/// 0 none or both.
int ShownFacing(const CoverageCounts& counts);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FACING_FREEDOM_H_
