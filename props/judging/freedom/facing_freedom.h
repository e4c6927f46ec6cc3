// Which facings a profile decides, and which it leaves open.
//
// A triangle faces front or back by the sign of its area after snapping and clipping, so a profile
// that leaves these free can leave the facing free too. LegalTriangle answers for one triangle.
// ReferencesOf() gives a triangle that faces one way in every legal model: if the profile does not
// say which side is the front, properties compare other triangles with it. For the triangles of a
// whole mesh that legal models face differently, see OpenTriangles (free_choices.h).
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_FACING_FREEDOM_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_FACING_FREEDOM_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/freedom/free_choices.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The facing of a clipped triangle is open if the polygon that clipping leaves inside the target,
/// grown by a grid step, is thinner than this many steps.
///
/// The polygon's vertices snap too, less than a step on each axis. So both edges of a wedge that
/// crosses the target can move by a step toward each other. That takes two steps times the wedge's
/// length from its area, which is at least half its thickness times its length: a wedge thicker
/// than four steps keeps its facing. A limit of two steps would be too low: a wedge of almost three
/// can lose its area (facing_freedom_test.cc).
inline constexpr double kThinnestClippedSteps = 4;

/// One triangle of a case, in all legal models of the profile at once.
class LegalTriangle {
 public:
  /// Domain:     a window-space case within the profile's limits.
  LegalTriangle(const PlacedCase& c, const Triangle& t);

  /// Returns +1 if the triangle faces front in every legal model, -1 if it faces back in every one,
  /// and 0 otherwise: two models differ, or it has no area in one of them, or clipping may turn it
  /// or move it. Front is as in CoverageCounts.
  int facing() const { return facing_; }
  /// Returns whether every legal model covers the sample at `p`. If the profile does not state
  /// where in its pixel the sample lies, every place in the pixel must be covered.
  ///
  /// Domain:     a place of the window in the pixel that holds it.
  bool CoversInEveryModel(Point2 p) const;
  /// Returns false only if no legal model covers the sample at `p`. This is a test by bounding box:
  /// it can be true of samples that no model covers.
  bool MayCover(Point2 p) const;

 private:
  bool has_places_ = false;
  bool knows_samples_ = true;  ///< the profile states where samples lie in their pixels
  double beyond_pixel_ = 0;    ///< how far beyond its pixel a sample may lie otherwise
  int facing_ = 0;
  bool is_culled_ = false;  ///< its side is one that the profile never draws
  int turn_ = 0;            ///< the sign of the area at all `places_`, in window axes
  std::array<LegalPlaces, 3> places_{};
};

/// A triangle that covers every sample of a target W wide and H high: (0, 0), (2W, 0), (0, 2H), in
/// another order if the profile always culls this one. Its counts show which side the subject takes
/// for the front.
struct Reference {
  PlacedCase value;
  int facing = 0;  ///< LegalTriangle::facing() of it: +1 or -1, never 0
};
inline constexpr const char* kReferenceWords = "the triangle (0, 0) (2 W, 0) (0, 2 H)";

/// Returns the references to ask for beside a case: one on a target of 4 x 4, which is the same
/// question in every case, so that answers to different cases can be compared; then one on the
/// case's target.
///
/// Either is left out if it lies beyond the profile's limits, or if the grid is so coarse for its
/// target that its facing is open. Both are if the profile states no single samples.
std::vector<Reference> ReferencesOf(const PlacedCase& c);

/// Returns the case's first `count` triangles, in one scene with the last reference before them. If
/// that reference has another target than the case, it is left out.
PlacedCase BehindItsReference(const PlacedCase& c, const std::vector<Reference>& references,
                              std::size_t count);

/// Returns the facing that a drawing of one triangle shows: +1 if it has front counts only, -1 if
/// it has back counts only, 0 if it has both or none.
int ShownFacing(const CoverageCounts& counts);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_FACING_FREEDOM_H_
