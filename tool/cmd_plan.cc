// rasterproof plan: what a scene needs, and what can be left out.
#include <algorithm>
#include <string>

#include "core/coverage.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "model/target_model.h"
#include "reference/plan.h"
#include "tool/commands.h"
#include "tool/session.h"

namespace rasterproof::tool {

int RunPlan(const PlanOptions& options) {
  RequireHonestEnvironment();
  const Scene scene = LoadScene(options.scene);
  const Profile profile = ForTarget(io::ReadProfile(options.profile), scene.width, scene.height);
  if (profile.squares) {
    throw InputError("--profile " + options.profile,
                     "it states whole pixels, and what is planned samples points",
                     "give a profile of samples");
  }
  const reference::Needs needs{options.barycentrics, options.depth, options.wireframe};
  const reference::Plan plan = reference::MakePlan(scene, profile, {}, needs);
  std::string text = fmt::format("scene       {}\nprofile     {}\narithmetic  {}\n",
                                 scene.name.empty() ? options.scene.path : scene.name, profile.name,
                                 plan.arithmetic);
  for (const reference::PlanReason& reason : plan.reasons) {
    text += fmt::format("  {:<16} {:<28} {}\n", reason.stage, reason.choice, reason.why);
  }
  int status = kExitHolds;
  if (options.verify) {
    const int samples = profile.pattern.samples();
    CoverageCounts planned(scene.width, scene.height, samples);
    plan.draw(scene, profile, {}, planned);
    const CoverageDifference difference = Compare(planned, exact::Coverage(scene, profile));
    text += fmt::format("verified    {} of {} samples differ from the oracle\n", difference.wrong,
                        difference.samples);
    if (difference.wrong != 0) status = kExitViolated;
  }
  io::WriteStandardOutput(text);
  return status;
}

}  // namespace rasterproof::tool
