// Meshes too large to be drawn triangle by triangle, for subjects that show no counts.
#ifndef RASTERPROOF_PROPS_JUDGING_AS_SHOWN_H_
#define RASTERPROOF_PROPS_JUDGING_AS_SHOWN_H_

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/case.h"
#include "core/coverage.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

/// A subject that shows no counts is drawn one triangle at a time, so that overlaps show, each draw
/// as large as the target. This many samples in all, 1024 x 1024 samples of 256 triangles, take
/// seconds. The triangles of a scanned model on a full target would take hours.
inline constexpr std::uint64_t kMostSamplesByTriangle = std::uint64_t{1} << 28;
/// This many calls take as long as hundreds of other cases, on any target.
inline constexpr std::size_t kMostCallsByTriangle = 1024;

/// Returns whether a draw of this many triangles and samples is judged as one call shows it: by
/// whether a sample is covered, not how often or by which facing.
///
/// Returns:    false for subjects that count, whatever the size.
bool IsJudgedAsShown(CoverageKind coverage, std::size_t triangles, std::uint64_t samples);
bool IsJudgedAsShown(const SubjectInfo& info, const Scene& scene);

/// Returns these counts as one call without counts shows them: 1 in `front` where anything covers.
CoverageCounts AsShown(CoverageCounts counts);

/// Why a property about counts or facings is not judged on such a mesh.
inline constexpr std::string_view kJudgedAsShown =
    "the mesh is too large to draw triangle by triangle, and in one call this subject shows "
    "neither counts nor facings";

/// Returns the verdict for a draw that is judged as it is shown: it can be violated but never
/// holds, since how often a sample is covered does not show.
Verdict NeverHolds(Verdict verdict);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_AS_SHOWN_H_
