// The verb plan.
#ifndef RASTERPROOF_TOOL_PLAN_CMD_PLAN_H_
#define RASTERPROOF_TOOL_PLAN_CMD_PLAN_H_

#include <string>

#include "tool/scene_source.h"

namespace rasterproof::tool {

struct PlanOptions {
  SceneOptions scene;
  std::string profile = "real";
  bool barycentrics = false;
  bool depth = false;
  bool wireframe = false;
  bool verify = false;
  bool measure = false;
  double error = -1;  ///< pixels that an edge may be off; negative: the plan is exact
  std::string bench;  ///< bench --json file with the times for `error`
};
int RunPlan(const PlanOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PLAN_CMD_PLAN_H_
