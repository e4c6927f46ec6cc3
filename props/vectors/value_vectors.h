// What vectors state of values: exact numbers, and the floats that the profile's error allows.
#ifndef RASTERPROOF_PROPS_VECTORS_VALUE_VECTORS_H_
#define RASTERPROOF_PROPS_VECTORS_VALUE_VECTORS_H_

#include <cstddef>

#include "core/profile.h"
#include "core/test_vector.h"
#include "model/target_profile.h"

namespace rasterproof::props {

/// The samples of a triangle whose values are stated, at most.
inline constexpr std::size_t kMostValueSamples = 4;

/// Throws InputError if the profile leaves open where vertices lie, and so what values are.
void RequireStatesValues(const Profile& profile);

/// Adds channels to the vector's scene, a w from 1 to 8 to each vertex, and what covered samples
/// hold by the vertices as the profile's model places them: the channels of `check` at samples and
/// centres, flat ones if a provoking vertex is stated. Left out is what no bound is known of, as in
/// RangeOf().
///
/// Domain:     RequireStatesValues() accepts the profile; `triangles` are there.
/// Returns:    intervals by the stated errors, or by the usual ones where none is stated, each with
///             exact ends: these floats hold as `check` judges, and no others.
void StateValues(const TargetProfile& profile, TestVector& vector);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_VECTORS_VALUE_VECTORS_H_
