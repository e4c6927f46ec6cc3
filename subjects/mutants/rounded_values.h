// Values of channels that are correctly rounded to float32, by sums that lose nothing.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_ROUNDED_VALUES_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_ROUNDED_VALUES_H_

#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {

/// Returns the float nearest to the exact value, of two the even one.
///
/// Domain:     corners and numbers of float32, not flat. NaN where a number is not finite or the
///             value has a denominator of 0.
/// Error:      half an ulp of the floats.
float CorrectlyRounded(const ValueQuestion& q);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_ROUNDED_VALUES_H_
