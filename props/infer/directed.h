// Triangles on which two models draw differently, by construction; and triangles with no two
// models in mind.
#ifndef RASTERPROOF_PROPS_INFER_DIRECTED_H_
#define RASTERPROOF_PROPS_INFER_DIRECTED_H_

#include "core/scene.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/infer/model_space.h"

namespace rasterproof::props {

/// One triangle near whose first edge the models part, more often than not: its first vertex lies
/// where their snaps differ (near a tie of one of them), and the edge passes exactly through a
/// sample once that vertex is snapped as one of them does. Where their snaps are one, the edge
/// passes through a sample, and their tie rules differ.
///
/// Returns:    float32 vertices; a small target.
Scene SplittingTriangle(BitSource& bits, const ModelSpace& space, const Model& a, const Model& b);

/// One triangle on 16 x 16 pixels and a little beside: corners anywhere; every other one's on
/// multiples of 1 to 1/16 pixel; every fourth with an edge through a sample, or next to it.
///
/// Returns:    float32 vertices.
Scene AimlessTriangle(BitSource& bits);

/// One triangle for a subject of this profile: near-edge, between subpixels, far away, ordinary.
Scene OrdinaryTriangle(BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_DIRECTED_H_
