// Why no legal model explains a drawing: one sample that all models contradict, or a minimal set of
// samples that none explains.
#ifndef RASTERPROOF_LEGAL_MINIMAL_SET_H_
#define RASTERPROOF_LEGAL_MINIMAL_SET_H_

#include <span>
#include <vector>

#include "core/scene.h"
#include "legal/joint.h"
#include "legal/needs.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// Returns the samples whose value no model of any family has, if there are any; else a set of
/// samples that no model of any family explains, of which none can be left out.
///
/// A family that explains some samples explains each part of them. So leaving out one sample after
/// the other, as long as every family still has no model, ends at a set that is minimal over all of
/// them, which a union of the families' own minimal sets is not.
///
/// Domain:     `refutations`: by family of FamiliesOf(profile, scene), a set it does not explain.
Core MinimalSet(const Scene& scene, const TargetProfile& profile, const Observed& observed,
                std::span<const std::vector<Seen>> refutations, const Effort& effort);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_MINIMAL_SET_H_
