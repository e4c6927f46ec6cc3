// What one call shows, as legal/joint.h takes it.
#ifndef RASTERPROOF_PROPS_JUDGING_OBSERVED_CALL_H_
#define RASTERPROOF_PROPS_JUDGING_OBSERVED_CALL_H_

#include "core/drawing.h"
#include "core/subject_info.h"
#include "legal/joint.h"

namespace rasterproof::props {

/// Returns what an answer to WholeCallOf() shows, by the kind of coverage that the subject shows.
///
/// Domain:     a drawing that outlives what is returned.
inline legal::Observed ObservedOf(const Drawing& drawing, const SubjectInfo& info) {
  legal::Observed observed;
  observed.last_is_visible = info.fragments.visible == Visible::kLastDrawn;
  if (info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts) {
    observed.together = &drawing.counts;
  } else if (!drawing.primitive_ids.empty()) {
    observed.primitive_ids = &drawing.primitive_ids;
  } else {
    observed.together = &drawing.counts;
    observed.is_mask = true;
  }
  return observed;
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_OBSERVED_CALL_H_
