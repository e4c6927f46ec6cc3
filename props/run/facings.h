// Counts by facing of any subject, also of those that tell no facings or only give a mask.
#ifndef RASTERPROOF_PROPS_RUN_FACINGS_H_
#define RASTERPROOF_PROPS_RUN_FACINGS_H_

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "core/subject.h"

namespace rasterproof::props {

/// Adds the coverage of every triangle of the scene to `counts`, by facing: what a subject of
/// CoverageKind::kFacingCounts draws itself, and of any other the sum of the draws of the parts
/// (FacingDraws) that the profile makes of the scene by which the subject is judged.
///
/// Returns:    how the call ended. Of a stop there is no drawing, and `counts` are of no use.
CallEnd DrawByFacing(Subject& subject, const Scene& scene, const DrawOptions& options,
                     CoverageCounts& counts);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_FACINGS_H_
