// A row of the tables of planted bugs and of legal variants.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_PLANTED_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_PLANTED_H_

#include <string_view>
#include <variant>
#include <vector>

#include "core/profile.h"
#include "subjects/mutants/clip_space.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/free_choice.h"
#include "subjects/mutants/own_transform.h"
#include "subjects/mutants/real_geometry.h"
#include "subjects/mutants/scanline.h"
#include "subjects/mutants/shown_values.h"

namespace rasterproof::subjects::mutants {

/// A sound base and what is different about it.
struct Planted {
  std::string_view name;
  std::string_view change;  ///< completes "a sound rasterizer, but ..."
  std::string_view source;  ///< where it was met: a bug report, an API's rule; may be empty
  std::variant<FixedStages, RealStages, ClipStages, ValueStages, TransformStages, ScanlineStages,
               FreeStages>
      stages;
};

/// Eight subpixel bits and four samples a pixel, on a rotated grid.
Profile FourSampleProfile();

// The mutants, by stage.
std::vector<Planted> FillRuleMutants();    // ties, facing
std::vector<Planted> PositionMutants();    // sample locations, snapping
std::vector<Planted> SetUpMutants();       // overflow, guard band
std::vector<Planted> TraversalMutants();   // box, tiles, walks
std::vector<Planted> TargetMutants();      // scissor, culling, target size, threads
std::vector<Planted> SceneMutants();       // state, degenerate and non-finite input, lost triangles
std::vector<Planted> RealMutants();        // exact geometry, clip space
std::vector<Planted> TransformMutants();   // clip space to window
std::vector<Planted> ScanlineMutants();    // where edges cross rows
std::vector<Planted> ShownValueMutants();  // edge values, walks, weights
std::vector<Planted> PromiseMutants();     // fixed-point input, target sizes, extents, overdraw
std::vector<Planted> FreeMutants();        // one illegal act among legal choices
/// Written after the generators and the properties were frozen.
std::vector<Planted> LateMutants();

std::vector<Planted> LegalVariants();
// Parts of them.
std::vector<Planted> TransformVariants();
std::vector<Planted> ScanlineVariants();
std::vector<Planted> FreeVariants();     // those that take the worst of what is legal
std::vector<Planted> PromiseVariants();  // those of profiles with the rarer keys

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_PLANTED_H_
