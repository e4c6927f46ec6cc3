// Triangles on which two given models draw differently, by construction; and triangles that are
// not aimed at any two models.
#ifndef RASTERPROOF_PROPS_INFER_DIRECTED_H_
#define RASTERPROOF_PROPS_INFER_DIRECTED_H_

#include "core/scene.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/infer/model_space.h"

namespace rasterproof::props {

/// Returns a triangle near whose first edge the models usually differ: its first vertex lies where
/// their snaps differ (near a tie of one of them), and the edge passes exactly through a sample
/// once that vertex is snapped as one of them does. If their snaps are equal, the edge passes
/// through a sample, where their tie rules differ.
///
/// Returns:    float32 vertices; a small target.
Scene SplittingTriangle(BitSource& bits, const ModelSpace& space, const Model& a, const Model& b);

/// Returns a triangle on or near 16 x 16 pixels: corners anywhere; every other triangle's on
/// multiples of 1 to 1/16 pixel; every fourth's with an edge through a sample, or next to it.
///
/// Returns:    float32 vertices.
Scene AimlessTriangle(BitSource& bits);

/// One triangle for a subject of this profile: near-edge, between subpixels, far away, ordinary.
Scene OrdinaryTriangle(BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_DIRECTED_H_
