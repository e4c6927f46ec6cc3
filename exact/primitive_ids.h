// Which triangle stays on each sample where several cover it.
#ifndef RASTERPROOF_EXACT_PRIMITIVE_IDS_H_
#define RASTERPROOF_EXACT_PRIMITIVE_IDS_H_

#include <cstdint>
#include <vector>

#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "exact/placed_scene.h"

namespace rasterproof::exact {

/// Returns for every sample the last or the first triangle of the scene's list that covers it by
/// the profile's canonical model, or kNoPrimitive.
///
/// Domain:     as Coverage, but not a profile of squares.
/// Shape:      as CoverageCounts.
/// Error:      none; throws WhyNotDecided() outside Coverage's domain.
/// Cost:       as Coverage, and the target's width for each row that a triangle meets.
std::vector<std::int32_t> PrimitiveIds(const PlacedScene& scene, const DrawOptions& options,
                                       Visible order);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_PRIMITIVE_IDS_H_
