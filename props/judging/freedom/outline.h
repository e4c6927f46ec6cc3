// The neighbourhood of a mesh's outline, where a profile may not state which samples are covered.
//
// Properties of meshes use Outline to leave these samples alone. Inside the outline the mesh must
// be covered whatever the subject did to its edges; beside the outline that depends on where
// exactly the subject's edges lie. For triangles that can turn over inside a mesh, see
// free_choices.h.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_OUTLINE_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_OUTLINE_H_

#include <vector>

#include "core/vertex.h"
#include "props/judging/freedom/visible_edge.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/placed_case.h"

namespace rasterproof::props {

// A sample is near an edge if it is within a margin, the sum of what may have displaced the edge.
// With u = 2^-24 the direct form in float32 displaces it by at most 3u |p - a|
// (docs/mathematics.md, forward bounds), so by 3 sqrt(2) u (L + T) for coordinates up to L and a
// target of side T. 2^-18 L = 64u L leaves room for targets up to 14 L, and 2^-10 for any up to
// 3861 pixels.
//
// A sample-exact subject of one model may displace nothing: there kOutlineMargin only chooses which
// property names a fault, and a sample that it leaves out is judged by CoverageEqualsTheModel. It
// has room for a walk of 176 steps beside the direct form; a longer one may be called a fault of
// the edge that two triangles share.
//
// A watertight or closed subject does not state its outline. It may have snapped vertices to a grid
// that it does not state: we take a pixel on each axis. It may have walked in float32: we take the
// longest walk in the target, down and across. Affine forms of edges that are short and far from
// the origin can go further.
inline constexpr double kOutlineMarginPerCoordinate = 0x1p-18;
inline constexpr double kOutlineMargin = 0x1p-10;
inline constexpr double kMovedOutlineMargin = 1;

/// How far a walk by additions in float32 displaces an edge beyond where its start does.
///
/// Domain:     0 to 2^17: steps of a pixel, down and across together.
/// Units:      pixels.
///
/// Let d = |b - a|, so that |dX|, |dY| <= d, and let the sample after the n-th step be r pixels
/// from the edge. After the k-th step |E| <= (n - k + r) d. A step's difference is off by u of
/// itself, and a sum rounds by u of itself: error_k <= (1 + u) (error_(k-1) + u d) + u (n - k + r)
/// d. So
///   error_n <= (1 + u)^n (error_0 + (n + n u + n (n - 1) / 2 + n r) u d),
/// and the side can be wrong only if r d <= error_n. With n u <= 2^-7 that is
///   r <= (1 + 2^-5) (error_0 / d + u n (n + 1) / 2).
/// One step of several pixels errs less than as many steps of one.
/// Measured:   4.0 pixels of 8.3 after 16384 steps: Outline.FloatWalks*, 2026-11-26.
inline double WalkMargin(double steps) { return (1 + 0x1p-5) * 0x1p-25 * steps * (steps + 1); }
// A sample whose place in its pixel is not stated lies at most a diagonal from any other place.
inline constexpr double kSampleMargin = 1.4142135623730952;

/// Returns how far, in pixels, a sample may lie from the place that the profile's pattern gives it:
/// 0 if the profile states that samples lie there.
inline double SampleReach(const Profile& profile) {
  return profile.sample_positions == SamplePositions::kStated ? 0 : kSampleMargin;
}

/// The samples near some edges of a mesh: those of its boundary, or all of them. Choose by how far
/// the subject may have moved the edges.
class Outline {
 public:
  /// Makes an empty outline: no sample is near it.
  Outline() = default;
  /// The boundary of the mesh where the canonical model places it; in clip space, where it is
  /// given. For a subject that draws by this model. Otherwise use OfMoved().
  explicit Outline(const PlacedCase& c);
  /// The boundary of a mesh that the subject may have moved by up to `most_moved` pixels, or one
  /// pixel if that is more: it chose other grid points than the canonical ones, snapped to another
  /// grid, or clipped; and, unless it is sample-exact, by a walk through the target. Two edges
  /// cancel only if they are the same in every legal model.
  ///
  /// The profile's `tie_ownership` can make it wider. If samples have an owner on shared edges
  /// only, the neighbourhood of each vertex belongs to it too. If nothing is stated of owners, this
  /// is OfAllEdges().
  static Outline OfMoved(const PlacedCase& c, double most_moved);
  /// Like OfMoved(), with every edge of every triangle with finite vertices, and no vertices.
  static Outline OfAllEdges(const PlacedCase& c, double most_moved);

  /// Returns whether the sample at `p` is within the margin of an edge or vertex of the outline.
  bool IsNear(Point2 p) const;
  bool IsEmpty() const { return edges_.empty() && vertices_.empty(); }

 private:
  struct SeenEdge {
    VisibleEdge seen;
    double margin = 0;
  };

  struct SeenVertex {
    Point2 at;
    double margin = 0;
  };

  void AddBoundary(const Scene& scene, double moved);
  void Add(const Scene& scene, const BoundaryEdge& edge, double moved);
  void AddVertices(const Scene& scene, double moved);

  std::vector<SeenEdge> edges_;
  std::vector<SeenVertex> vertices_;
  double largest_ = 0;  ///< the largest |coordinate| of the scene
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_OUTLINE_H_
