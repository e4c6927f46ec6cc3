// The calls that tell the facings of a subject that does not tell them itself.
#ifndef RASTERPROOF_PROPS_RUN_FACING_DRAWS_H_
#define RASTERPROOF_PROPS_RUN_FACING_DRAWS_H_

#include <cstddef>
#include <span>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// One call's share of a draw.
struct FacingDraw {
  DrawJob job;
  bool is_back = false;  ///< its samples count as back; ignored if the subject reports facings
};

/// The parts that add up to the draw's counts by facing.
///
/// kFacingCounts: the draw itself. kCounts: triangles that face one way by the canonical model of
/// the profile (in clip space by their quotients on its grid) in one call, in their order, those
/// that face the other way in another. kMask, kPrimitiveIds, kFragments: every triangle by itself,
/// so that overlaps show; of a mesh too large for that the draw itself, as it is shown
/// (IsJudgedAsShown). A triangle of no area counts as front: it should cover nothing. Where the
/// profile leaves other models legal the facing is a guess (OpenTriangles).
std::vector<FacingDraw> FacingDraws(const DrawJob& job, CoverageKind coverage,
                                    const Profile& profile);

/// The most samples, vertices and triangles in one call of a subject: the call's draws take memory
/// on either side.
inline constexpr std::size_t kMostInACall = std::size_t{1} << 20;
/// Returns the samples, vertices and triangles that a job adds to a call.
std::size_t SizeInACall(const DrawJob& job);

/// Draws the parts in their order, in calls of kMostInACall, and adds what they drew.
///
/// Returns:    how it ended; if early, counts are of the parts before.
CallEnd DrawFacings(Subject& subject, std::span<const FacingDraw> parts, CoverageCounts& counts);

/// Adds what a part drew to the counts of its draw.
///
/// Shape:      both of one shape.
void AddFacingDraw(const FacingDraw& part, CoverageKind coverage, const CoverageCounts& drawn,
                   CoverageCounts& counts);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_FACING_DRAWS_H_
