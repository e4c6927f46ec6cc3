// Where a profile puts a vertex, in integers and apart from model/, so that the legal variants are
// an opinion of their own.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_PLACING_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_PLACING_H_

#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"

namespace rasterproof::subjects::mutants {

/// Returns the grid point of `snap` that x rounds to.
///
/// Domain:     |x| < 2^41; x itself beyond, and where it is not finite. For float32 differences, a
///             float32.
double SnapToGrid(double x, const Snap& snap);

/// Returns the profile with what it says of a target of this size as its own.
Profile ModelOn(const Profile& profile, int width, int height);
/// And on the scene's target.
Profile ModelOn(const Profile& profile, const Scene& scene);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_PLACING_H_
