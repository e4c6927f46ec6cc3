// Profiles with the rarer keys, for the variants that keep them and the mutants that don't.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_CONTRACTS_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_CONTRACTS_H_

#include "core/profile.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {

/// Integers of 11.4 bits, signed, that wrap; no snap of their own.
FixedStages WrappingInput();
/// Nothing wider than 64 or higher than 32 pixels is drawn; 12.4 signed integers, as in a console.
FixedStages LimitedExtent();
/// Edges may move where a vertex is more than 256 pixels off.
FixedStages ClippedBeyond256();
/// 8 subpixel bits on targets of up to 32 by 24 pixels, 4 that truncate on those of up to 40 by 40,
/// else 6.
FixedStages BitsByTarget();
/// Triangles of zero area are left unspecified.
FixedStages UnspecifiedFlat();
/// Any triangle may draw the samples on its edges.
FixedStages EdgeSamplesMayBeShared();
/// The d3d11 profile under the tie rule "inclusive" or "exclusive".
FixedStages EdgesInside();
FixedStages EdgesOutside();

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_CONTRACTS_H_
