// The verb coverage.
#ifndef RASTERPROOF_TOOL_COVERAGE_CMD_COVERAGE_H_
#define RASTERPROOF_TOOL_COVERAGE_CMD_COVERAGE_H_

#include <string>

#include "tool/scene_source.h"

namespace rasterproof::tool {

/// A subject's coverage as rows of counts or a picture, or its difference from another's.
struct CoverageOptions {
  SceneOptions scene;
  std::string subject;  ///< empty: "exact", or "spans-exact" where pixels are shaded
  std::string profile;  ///< empty: "real" for exact, the subject's own otherwise
  std::string output = "-";
  std::string against;  ///< the subject to compare with; empty: none
  std::string png;      ///< a picture instead of the rows, or with the comparison; empty: none
  std::string mode = "coverage";  ///< of the picture; flat, barycentrics, depth, wireframe: shaded
  double line_width = 1;
};
int RunCoverage(const CoverageOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COVERAGE_CMD_COVERAGE_H_
