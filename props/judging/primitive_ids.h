// PrimitiveIds: which of the triangles that cover a sample a subject shows there.
#ifndef RASTERPROOF_PROPS_JUDGING_PRIMITIVE_IDS_H_
#define RASTERPROOF_PROPS_JUDGING_PRIMITIVE_IDS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// Entry k: whether anything covers sample k.
std::vector<bool> CoveredSamples(const CoverageCounts& counts);

/// The visible triangle of every sample. `covered` has an entry for each triangle, in the order of
/// drawing.
std::vector<std::int32_t> PrimitiveIdsOf(const std::vector<std::vector<bool>>& covered,
                                         Visible order);

/// Holds if the primitive ids are equal; else violated, with the first sample that differs. `how`
/// completes the sentence "triangle 3 should win, by the triangles ...".
///
/// Domain:     primitive ids of a list that repeats the `triangles` of the case.
Verdict SamePrimitiveIds(const Drawing& observed, const std::vector<std::int32_t>& expected,
                         std::size_t triangles, std::uint64_t exercised, const std::string& how);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_PRIMITIVE_IDS_H_
