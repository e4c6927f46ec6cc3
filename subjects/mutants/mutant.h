// A row of the tables of planted bugs and of legal variants.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_

#include <string_view>
#include <variant>
#include <vector>

#include "core/profile.h"
#include "subjects/mutants/centroids.h"
#include "subjects/mutants/clipping.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/free_choice.h"
#include "subjects/mutants/own_transform.h"
#include "subjects/mutants/real_geometry.h"
#include "subjects/mutants/shown_values.h"
#include "subjects/mutants/squares.h"
#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {

/// A sound base and what is different about it.
struct Mutant {
  std::string_view name;
  std::string_view change;  ///< completes "a sound rasterizer, but ..."
  std::string_view source;  ///< where it was met: a bug report, an API's rule; may be empty
  std::variant<FixedStages, RealStages, ClipStages, ValueStages, TransformStages, FreeStages,
               SquareStages, CentroidStages, ClippingStages, ChannelStages>
      stages;
  std::string_view causes = {};   ///< as MutantInfo::causes
  std::string_view killers = {};  ///< properties that each find it, with "|" between them
  /// Whether it is drawn in other floating-point modes, where only its bug shows.
  bool takes_float_modes = false;
};

/// Eight subpixel bits and four samples a pixel, on a rotated grid.
Profile FourSampleProfile();

/// Sound, under a preset.
FixedStages StagesOfPreset(std::string_view preset);

// The mutants, by stage.
std::vector<Mutant> TieRuleMutants();     // ties, facing
std::vector<Mutant> PositionMutants();    // sample locations, snapping
std::vector<Mutant> SetUpMutants();       // overflow, guard band
std::vector<Mutant> WidthMutants();       // numbers of one bit too few
std::vector<Mutant> TraversalMutants();   // box, tiles, stepping
std::vector<Mutant> TargetMutants();      // scissor, culling, target size, threads
std::vector<Mutant> SceneMutants();       // state, degenerate and non-finite input, lost triangles
std::vector<Mutant> CrowdMutants();       // many triangles, pairs, ends of numbers
std::vector<Mutant> RealMutants();        // exact geometry, clip space
std::vector<Mutant> TransformMutants();   // clip space to window
std::vector<Mutant> MapMutants();         // a map to window, tiles
std::vector<Mutant> ScanlineMutants();    // where edges cross rows
std::vector<Mutant> ShownValueMutants();  // edge values, steps, barycentrics
std::vector<Mutant> ContractMutants();    // fixed-point input, target sizes, extents, edge_samples
std::vector<Mutant> SquareMutants();      // whole pixels
std::vector<Mutant> FreeMutants();        // one illegal act among legal choices
std::vector<Mutant> SetMutants();         // just outside the legal sets of APIs
std::vector<Mutant> GridMutants();        // grids that change, under the legal sets of APIs
std::vector<Mutant> FacingMutants();      // facing, under the legal sets of APIs
std::vector<Mutant> FarMutants();         // large coordinates, under legal sets
std::vector<Mutant> HistoryMutants();     // what a scene leaves for the next, under legal sets
std::vector<Mutant> SampleMutants();      // several samples a pixel
std::vector<Mutant> CentroidMutants();    // where attributes are evaluated at centroids
std::vector<Mutant> ModeMutants();        // the caller's floating-point mode
std::vector<Mutant> FragmentMutants();    // whose barycentrics, and what is asked for alone
std::vector<Mutant> ValueMutants();       // values of channels
std::vector<Mutant> SlopeMutants();       // their derivatives, and depths
std::vector<Mutant> ListMutants();        // lists of more than 2^16 triangles
/// Written after the generators and the properties were frozen.
std::vector<Mutant> LateMutants();

std::vector<Mutant> LegalVariants();
// Parts of them.
std::vector<Mutant> TransformVariants();
std::vector<Mutant> MapVariants();
std::vector<Mutant> ScanlineVariants();
std::vector<Mutant> WidthVariants();
std::vector<Mutant> SquareVariants();
std::vector<Mutant> FreeVariants();      // those that take the worst of what is legal
std::vector<Mutant> SetVariants();       // of the legal sets of APIs
std::vector<Mutant> GridVariants();      // grids that change, of the legal sets of APIs
std::vector<Mutant> FacingVariants();    // facing, of the legal sets of APIs
std::vector<Mutant> FarVariants();       // large coordinates
std::vector<Mutant> HistoryVariants();   // that refuse a scene, and draw the next
std::vector<Mutant> SampleVariants();    // several samples a pixel
std::vector<Mutant> CentroidVariants();  // those that show centroids
std::vector<Mutant> FragmentVariants();  // those that show fragments in float32
std::vector<Mutant> ValueVariants();     // those that show values of channels
std::vector<Mutant> ListVariants();      // long lists
std::vector<Mutant> ContractVariants();  // those of profiles with the rarer keys

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_MUTANT_H_
