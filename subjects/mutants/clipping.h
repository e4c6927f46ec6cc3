// A rasterizer that clips triangles, snaps the vertices which that makes, and draws the polygon. No
// stage says it: a sample counts by the signs of several triangles together.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_CLIPPING_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_CLIPPING_H_

#include <memory>
#include <string>

#include "core/subject.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {

/// How the rasterizer clips, and to what.
struct ClippingStages {
  FixedStages base;   ///< draws what is left, and snaps all vertices, new ones too
  double beyond = 0;  ///< clips to the target and this many pixels around it
  /// A planted bug: the ends of the polygon on a side of the rectangle lie this many pixels further
  /// apart, or nearer if negative. Two neighbours then overlap along an edge that leaves, or part.
  double wider = 0;
};

/// The rasterizer with the given stages. A polygon covers what it winds around, whatever snapping
/// made of its shape, so that neighbours which are clipped alike stay watertight.
///
/// Domain:     as Make() of FixedStages.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ClippingStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_CLIPPING_H_
