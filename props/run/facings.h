// Facings for subjects that do not tell them apart, and counts for those that only give a mask.
#ifndef RASTERPROOF_PROPS_RUN_FACINGS_H_
#define RASTERPROOF_PROPS_RUN_FACINGS_H_

#include <memory>

#include "core/subject.h"

namespace rasterproof::props {

/// Returns a subject of CoverageKind::kFacingCounts that draws by the given one.
///
/// kCounts: triangles that face one way by the canonical model of the subject's profile (in clip
/// space by their quotients on its grid) are drawn in one call, in their order, those that face the
/// other way in another. kMask, kWinners, kFragments: every triangle is drawn by itself, so that
/// overlaps show. A triangle of no area counts as front: it should cover nothing. Where the profile
/// leaves other models legal the facing is a guess: see TellsFacings and OpenTriangles
/// (props/judging/free_choices.h). What only a whole mesh in one call would show is seen by the
/// properties that draw by Subject::Whole().
std::unique_ptr<Subject> WithFacings(std::unique_ptr<Subject> subject);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_FACINGS_H_
