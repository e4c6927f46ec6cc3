#include "subjects/mutants/own_transform.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/profile.h"
#include "core/subject_info.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

PixelRect TileOf(const Scene& scene, const DrawOptions& options) {
  const PixelRect cut = options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
  return {std::max(cut.x0, 0), std::max(cut.y0, 0), std::min(cut.x1, scene.width),
          std::min(cut.y1, scene.height)};
}

void TakeToWindow(const TransformStages& stages, Scene& scene, const DrawOptions& options) {
  const PixelRect tile = TileOf(scene, options);
  const Snap grid = FixedPointProfile().snap;
  const auto place = [&](const Vertex& v) -> Point2 {
    if (!IsFinite(v)) return {kNowhere, kNowhere};
    if (!stages.to_tile) return v.w > 0 ? stages.to_window(v, scene) : Point2{kNowhere, kNowhere};
    // Rounded before it moves: exact on the grid.
    const Point2 p = stages.to_tile(v, tile);
    return {SnapToGrid(p.x, grid) + tile.x0, SnapToGrid(p.y, grid) + tile.y0};
  };
  scene.clip_space = false;
  for (Vertex& v : scene.vertices) {
    const Point2 p = place(v);
    v = {p.x, p.y, v.z, 1};
  }
}

}  // namespace

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const TransformStages& stages) {
  FixedStages base;
  base.has_workers = false;
  base.scene = [stages](Scene& scene, const DrawOptions& options) {
    TakeToWindow(stages, scene, options);
  };
  base.depth = [stages](double& depth, const variants::Weights& weights, const GridTriangle& t) {
    std::array<Vertex, 3> v = t.AsListed(t.given);
    const auto [least, greatest] = std::minmax({v[0].z, v[1].z, v[2].z});
    if (greatest - least < stages.flat_depths) v[1].z = v[2].z = v[0].z;
    depth = stages.depth_error;
    for (std::size_t i = 0; i < 3; ++i) depth += weights[i] * v[i].z;
  };
  SubjectInfo info = FixedPointInfo(name, summary, base.profile);
  info.profile.name = "transform of its own";
  info.profile.transform = stages.stated;
  info.takes_window = stages.stated.map.has_value();
  info.takes_clip = !info.takes_window;
  if (info.takes_window) info.input = Precision::kFloat64;
  if (stages.shows_fragments) {
    info.coverage = CoverageKind::kFragments;
    info.fragments = {.barycentrics_of = BarycentricsOf::kSnapped,
                      .barycentric_error = kBarycentricError,
                      .depth_error = kDepthError};
  }
  return Make(info, base);
}

}  // namespace rasterproof::subjects::mutants
