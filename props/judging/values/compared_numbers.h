// The numbers around a failing one, for a picture of them.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_COMPARED_NUMBERS_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_COMPARED_NUMBERS_H_

#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Adds to a violation by ValueViolation() or NumberViolation() the numbers of the same kind and
/// triangle that are shown around it. They explain and judge nothing: exact numbers are estimates.
///
/// Domain:     a violation of the drawing that is shown; to others nothing is added.
void AddNumbersAround(const PlacedCase& c, const SubjectInfo& info, const ShownValues& shown,
                      Verdict& verdict);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_COMPARED_NUMBERS_H_
