// Leave out what a scene does not need: the cheapest arithmetic that is proved exact for it.
#ifndef RASTERPROOF_REFERENCE_PLAN_H_
#define RASTERPROOF_REFERENCE_PLAN_H_

#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "model/target_profile.h"
#include "reference/rasterize.h"

namespace rasterproof::reference {

/// One decision of the plan, with the number that it rests on.
struct PlanReason {
  /// "edge arithmetic", "snap", "clip", "cull", "barycentrics", "depth", ...
  std::string stage;
  std::string choice;  ///< "int32 direct", "left out"
  std::string why;     ///< "box side * 2^s = 2048 <= 4096 (docs/mathematics.md, exactness table)"
};

/// Draws a scene under the profile that it was planned for.
using PlanDraw = void (*)(const Scene&, const Profile&, const DrawOptions&, CoverageCounts&);

/// The planned kernel with something kept that the plan leaves out: the same counts, for measuring
/// what leaving it out saves.
struct PlanVariant {
  std::string kept;  ///< a stage of the reasons, or "everything": exact for any finite double
  PlanDraw draw;
};

struct Plan {
  std::string arithmetic;  ///< name of the kernel that runs
  std::vector<PlanReason> reasons;
  /// Draws the scene by the planned kernel. Bit-identical to the full exact pipeline.
  PlanDraw draw = nullptr;
  /// Each stage that is left out and could be kept, by itself; "everything" last.
  std::vector<PlanVariant> variants;
};

/// The cheapest kernel that is proved exact for the scene under the profile's canonical model.
///
/// Domain:     any scene; a TargetProfile of the scene's target, without rounded
///             crossings, which no kernel computes. Clip space that no transform of the profile's
///             places gets the homogeneous kernel, and takes no fixed-point input and no largest
///             extent.
/// Error:      InputError where the domain is left; Plan::draw throws it too, where a clip-space
///             scene can't be snapped (SnapProjected).
Plan MakePlan(const Scene& scene, const Profile& profile, const DrawOptions& options,
              const Needs& needs);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_PLAN_H_
