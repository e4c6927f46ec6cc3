#include "subjects/mutants/own_transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

// Exact: grid points within the profile's limit have 24 bits.
double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

class OwnTransform final : public Subject {
 public:
  OwnTransform(const std::string& name, const std::string& summary, TransformStages stages)
      : base_(MakeFixedPoint(name, summary, {})), info_(base_->Info()), stages_(std::move(stages)) {
    info_.profile.name = "transform of its own";
    info_.profile.transform = stages_.stated;
    info_.takes_window = stages_.stated.map.has_value();
    info_.takes_clip = !info_.takes_window;
    if (info_.takes_window) info_.input = Precision::kFloat64;
    if (!stages_.shows_fragments) return;
    info_.coverage = CoverageKind::kFragments;
    info_.fragments = {.barycentrics_of = BarycentricsOf::kSnapped,
                       .barycentric_error = kBarycentricError,
                       .depth_error = kDepthError};
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (stages_.to_tile) {
      DrawTile(scene, options, counts);
      return;
    }
    if (!stages_.shows_fragments) {
      DrawOnto(*base_, InTheWindow(scene), options, counts);
      return;
    }
    Subject::Draw(scene, options, counts);
  }

  Drawing Show(const DrawJob& job) override {
    if (!stages_.shows_fragments) return Subject::Show(job);
    const Scene window = InTheWindow(SceneOf(job));
    Drawing drawing;
    drawing.counts = CoverageCounts(window.width, window.height, job.samples);
    const std::size_t size = drawing.counts.size();
    drawing.primitive_ids.assign(size, kNoPrimitive);
    drawing.barycentrics.resize(size);
    drawing.depths.resize(size);
    for (std::size_t t = 0; t < window.triangles.size(); ++t) {
      Scene one = window;
      one.triangles = {window.triangles[t]};
      CoverageCounts alone(window.width, window.height, job.samples);
      DrawOnto(*base_, one, job.options, alone);
      for (std::size_t k = 0; k < size; ++k) {
        if (alone.Count(k) != 0) Win(window, t, k, drawing);
      }
    }
    return drawing;
  }

 private:
  void DrawTile(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
    PixelRect tile{0, 0, scene.width, scene.height};
    if (const auto& cut = options.scissor) {
      tile = {std::max(cut->x0, 0), std::max(cut->y0, 0), std::min(cut->x1, scene.width),
              std::min(cut->y1, scene.height)};
    }
    if (tile.x0 >= tile.x1 || tile.y0 >= tile.y1) return;
    Scene part = scene;
    part.width = tile.x1 - tile.x0;
    part.height = tile.y1 - tile.y0;
    for (Vertex& v : part.vertices) {
      constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
      const Point2 p = IsFinite(v) ? stages_.to_tile(v, tile) : Point2{kNowhere, kNowhere};
      v = {p.x, p.y, v.z, 1};
    }
    DrawOptions whole = options;
    whole.scissor.reset();
    CoverageCounts drawn(part.width, part.height, counts.samples);
    DrawOnto(*base_, part, whole, drawn);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const auto samples = static_cast<std::size_t>(counts.samples);
      const auto width = static_cast<std::size_t>(part.width);
      const std::size_t at = counts.Index(tile.x0 + static_cast<int>(k / samples % width),
                                          tile.y0 + static_cast<int>(k / samples / width),
                                          static_cast<int>(k % samples));
      counts.front[at] += drawn.front[k];
      counts.back[at] += drawn.back[k];
    }
  }

  Scene InTheWindow(const Scene& scene) const {
    Scene window = scene;
    window.clip_space = false;
    for (Vertex& v : window.vertices) {
      constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
      const bool has_place = IsFinite(v) && v.w > 0;
      const Point2 p = has_place ? stages_.to_window(v, scene) : Point2{kNowhere, kNowhere};
      v = {p.x, p.y, v.z, 1};
    }
    return window;
  }

  void Win(const Scene& window, std::size_t t, std::size_t k, Drawing& drawing) const {
    std::array<Vertex, 3> v = Corners(window, window.triangles[t]);
    const auto [least, greatest] = std::minmax({v[0].z, v[1].z, v[2].z});
    if (greatest - least < stages_.flat_depths) v[1].z = v[2].z = v[0].z;
    std::array<Point2, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = {SnapToGrid(v[i].x, info_.profile.snap), SnapToGrid(v[i].y, info_.profile.snap)};
    }
    const auto width = static_cast<std::size_t>(window.width);
    const std::size_t row = k / width;
    const Point2 p{static_cast<double>(k % width) + 0.5, static_cast<double>(row) + 0.5};
    const double area = EdgeValue(at[0], at[1], at[2]);
    drawing.counts.front[k] = 1;
    drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
    drawing.depths[k] = stages_.depth_error;
    for (std::size_t i = 0; i < 3; ++i) {
      const double barycentric = EdgeValue(at[(i + 1) % 3], at[(i + 2) % 3], p) / area;
      drawing.barycentrics[k][i] = barycentric;
      drawing.depths[k] += barycentric * v[i].z;
    }
  }

  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
  TransformStages stages_;
};

}  // namespace

std::unique_ptr<Subject> MakeOwnTransform(const std::string& name, const std::string& summary,
                                          TransformStages stages) {
  return std::make_unique<OwnTransform>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
