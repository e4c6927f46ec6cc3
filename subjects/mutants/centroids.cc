#include "subjects/mutants/centroids.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

using Barycentric3 = std::array<double, 3>;
using variants::BarycentricsAt;

class Centroids final : public Subject {
 public:
  Centroids(const std::string& name, const std::string& summary, CentroidStages stages)
      : stages_(std::move(stages)), base_(Make(name, summary, stages_.base)), info_(base_->Info()) {
    info_.coverage = CoverageKind::kFragments;
    info_.takes_threads = false;
    info_.takes_culling = false;
    info_.fragments.barycentrics_of = stages_.barycentrics_of;
    info_.fragments.shows_centroids = stages_.shows_centroids;
    if (!stages_.centroid) stages_.centroid = CentroidOfDirect3D;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  Drawing Show(const DrawJob& job) override {
    if (job.samples != info_.profile.pattern.samples()) {
      throw SubjectStop(Stop::kNotDrawable, "it has another number of samples a pixel");
    }
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    const std::size_t size = drawing.counts.size();
    drawing.primitive_ids.assign(size, kNoPrimitive);
    drawing.barycentrics.resize(size);
    drawing.depths.resize(size);
    if (job.wants.centroids) drawing.centroids.resize(size);
    Scene one = scene;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      CoverageCounts alone(scene.width, scene.height, job.samples);
      one.triangles = {scene.triangles[t]};
      DrawOnto(*base_, one, job.options, alone);
      ShowTriangle(scene, t, alone, job.wants, drawing);
    }
    return drawing;
  }

 private:
  std::array<Point2, 3> PlacedCorners(const std::array<Vertex, 3>& corners) const {
    std::array<Point2, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      const Snap& snap = stages_.base.profile.snap;
      v[k] = {SnapToGrid(corners[k].x, snap), SnapToGrid(corners[k].y, snap)};
    }
    return v;
  }

  CentroidQuestion QuestionAt(const std::array<Point2, 3>& v, int x, int row,
                              const CoverageCounts& alone) const {
    const bool up = stages_.base.profile.y_axis == YAxis::kUp;
    CentroidQuestion q{
        .v = v,
        .low = {static_cast<double>(x), static_cast<double>(up ? alone.height - 1 - row : row)},
        .samples = {},
        .covered = {},
        .x = x};
    for (int s = 0; s < alone.samples; ++s) {
      const Point2 location = stages_.base.profile.pattern.locations[static_cast<std::size_t>(s)];
      q.samples.push_back({q.low.x + location.x, q.low.y + location.y});
      q.covered.push_back(alone.Count(alone.Index(x, row, s)) != 0);
    }
    return q;
  }

  // At any sample of the pixel.
  static bool IsCovered(const CoverageCounts& counts, int x, int row) {
    for (int s = 0; s < counts.samples; ++s) {
      if (counts.Count(counts.Index(x, row, s)) != 0) return true;
    }
    return false;
  }

  void ShowTriangle(const Scene& scene, std::size_t t, const CoverageCounts& alone,
                    const Outputs& wants, Drawing& drawing) const {
    const std::array<Vertex, 3> corners = Corners(scene, scene.triangles[t]);
    ShownFragment shown{.wants = wants, .indices = scene.triangles[t]};
    shown.placed = PlacedCorners(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      shown.given[k] = WindowPoint(corners[k]);
      shown.z[k] = corners[k].z;
    }
    const bool snapped = stages_.barycentrics_of == BarycentricsOf::kSnapped;
    const std::array<Point2, 3>& owners = snapped ? shown.placed : shown.given;
    for (int row = 0; row < alone.height; ++row) {
      for (int x = 0; x < alone.width; ++x) {
        if (!IsCovered(alone, x, row)) continue;
        const CentroidQuestion q = QuestionAt(shown.placed, x, row, alone);
        const Barycentric3 centroid = drawing.centroids.empty()
                                          ? Barycentric3{}
                                          : BarycentricsAt(owners, stages_.centroid(q));
        for (int s = 0; s < alone.samples; ++s) {
          if (!q.covered[static_cast<std::size_t>(s)]) continue;
          const std::size_t k = alone.Index(x, row, s);
          if (!drawing.centroids.empty()) drawing.centroids[k] = centroid;
          shown.at = q.samples[static_cast<std::size_t>(s)];
          Win(shown, owners, static_cast<std::int32_t>(t), k, drawing);
        }
      }
    }
  }

  void Win(ShownFragment& shown, const std::array<Point2, 3>& owners, std::int32_t t, std::size_t k,
           Drawing& drawing) const {
    const Barycentric3 l = BarycentricsAt(owners, shown.at);
    shown.barycentrics = l;
    shown.depth = l[0] * shown.z[0] + l[1] * shown.z[1] + l[2] * shown.z[2];
    if (stages_.shown) stages_.shown(shown);
    drawing.counts.front[k] = 1;
    drawing.primitive_ids[k] = t;
    drawing.barycentrics[k] = shown.barycentrics;
    drawing.depths[k] = shown.depth;
  }

  CentroidStages stages_;
  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
};

}  // namespace

bool CentroidQuestion::IsWhole() const {
  return std::ranges::find(covered, false) == covered.end();
}

Point2 CentroidOfDirect3D(const CentroidQuestion& q) {
  if (q.IsWhole()) return q.Centre();
  return q
      .samples[static_cast<std::size_t>(std::ranges::find(q.covered, true) - q.covered.begin())];
}

std::vector<Point2> CommonPolygon(const CentroidQuestion& q) {
  const Point2 high{q.low.x + 1, q.low.y + 1};
  std::vector<Point2> polygon{q.low, {high.x, q.low.y}, high, {q.low.x, high.y}};
  const double facing = variants::RoundedEdgeValue(q.v[0], q.v[1], q.v[2]) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Point2> rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point2 a = polygon[k];
      const Point2 b = polygon[(k + 1) % polygon.size()];
      const double at_a = facing * variants::RoundedEdgeValue(q.v[i], q.v[(i + 1) % 3], a);
      const double at_b = facing * variants::RoundedEdgeValue(q.v[i], q.v[(i + 1) % 3], b);
      if (at_a >= 0) rest.push_back(a);
      if ((at_a < 0) == (at_b < 0)) continue;
      const double part = at_a / (at_a - at_b);
      rest.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
    }
    polygon = std::move(rest);
  }
  return polygon;
}

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              CentroidStages stages) {
  return std::make_unique<Centroids>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
