// Small scenes and the methods that draw them.
#ifndef RASTERPROOF_TESTS_REFERENCE_SCENES_H_
#define RASTERPROOF_TESTS_REFERENCE_SCENES_H_

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "reference/rasterize.h"

namespace rasterproof::reference {

/// A window-space scene; triangles take the vertices three by three unless given.
inline Scene WindowScene(int width, int height, const std::vector<Point2>& points,
                         std::vector<Triangle> triangles = {}) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  for (const Point2& p : points) scene.vertices.push_back({p.x, p.y, 0, 1});
  if (triangles.empty()) {
    for (int n = 0; n + 2 < static_cast<int>(points.size()); n += 3) {
      triangles.push_back({n, n + 1, n + 2});
    }
  }
  scene.triangles = std::move(triangles);
  return scene;
}

inline CoverageCounts Draw(const Scene& scene, std::string_view method,
                           const RasterOptions& options = {}) {
  CoverageCounts counts(scene.width, scene.height);
  Rasterize(scene, *FindMethod(method), options, counts);
  return counts;
}

/// Every method that takes window space.
inline std::vector<std::string> WindowMethods() {
  std::vector<std::string> names;
  for (const Method& method : Methods()) {
    if (method.info.takes_window) names.emplace_back(method.name);
  }
  return names;
}

/// The counts, front and back together, a line of digits per row.
inline std::string Picture(const CoverageCounts& counts) {
  std::string text;
  for (int j = 0; j < counts.height; ++j) {
    for (int i = 0; i < counts.width; ++i) {
      text += std::to_string(counts.Count(counts.Index(i, j)));
    }
    text += '\n';
  }
  return text;
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_TESTS_REFERENCE_SCENES_H_
