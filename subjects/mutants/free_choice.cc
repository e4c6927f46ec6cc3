#include "subjects/mutants/free_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "core/snap.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

// A point so near to the end of the tolerance is left alone: the division that led to it rounds.
constexpr double kMargin = 0x1p-20;

double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

class FreeChoice final : public Subject {
 public:
  FreeChoice(const std::string& name, const std::string& summary, FreeStages stages)
      : stages_(std::move(stages)), base_(MakeBase(name, summary, stages_)) {
    info_ = base_->Info();
    info_.profile = stages_.profile;
    info_.coverage = stages_.coverage;
    info_.fragments.barycentrics_of = BarycentricsOf::kGiven;
    info_.takes_threads = false;
    info_.takes_culling = stages_.coverage == CoverageKind::kFacingCounts;
    info_.takes_window = !stages_.takes_clip;
    info_.takes_clip = stages_.takes_clip;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (stages_.coverage == CoverageKind::kFacingCounts) {
      DrawTriangles(scene, options, counts);
      return;
    }
    CoverageCounts drawn(counts.width, counts.height, counts.samples);
    DrawTriangles(scene, options, drawn);
    const bool counts_all = stages_.coverage == CoverageKind::kCounts;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      counts.front[k] += counts_all ? drawn.Count(k) : std::min(drawn.Count(k), 1U);
    }
  }

  Drawing Show(const DrawJob& job) override {
    Drawing drawing = Subject::Show(job);
    if (!ShowsPrimitiveIds(info_)) return drawing;
    const std::size_t size = drawing.counts.size();
    drawing.primitive_ids.assign(size, kNoPrimitive);
    drawing.barycentrics.resize(size);
    drawing.depths.resize(size);
    const Scene scene = SceneOf(job);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const std::size_t id = stages_.id ? stages_.id(t, scene.triangles.size()) : t;
      CoverageCounts alone(scene.width, scene.height, job.samples);
      DrawTriangle(scene, t, job.options, alone);
      for (std::size_t k = 0; k < size; ++k) {
        if (alone.Count(k) == 0) continue;
        drawing.primitive_ids[k] = static_cast<std::int32_t>(id);
        Interpolate(scene, t, k, drawing);
      }
    }
    return drawing;
  }

 private:
  // It is given grid points, and only the tie rule is left for it to say.
  static std::unique_ptr<Subject> MakeBase(const std::string& name, const std::string& summary,
                                           const FreeStages& stages) {
    FixedStages base;
    base.profile = stages.profile;
    base.profile.freedom = {};
    base.profile.snap = {std::max(8, stages.bits)};
    return MakeFixedPoint(name, summary, base);
  }

  std::vector<double> LegalCoordinates(double x) const {
    const double own = SnapToGrid(x, {stages_.bits});
    const double step = std::ldexp(1.0, -stages_.bits);
    std::vector<double> legal{own};
    for (const double point : {own - step, own + step}) {
      if (std::fabs(point - x) <= (stages_.tolerance - kMargin) * step) legal.push_back(point);
    }
    return legal;
  }

  Point2 LegalPlace(Point2 at) const {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return at;
    Point2 worst;
    double most = -std::numeric_limits<double>::infinity();
    const std::vector<double> ys = LegalCoordinates(at.y);
    for (const double x : LegalCoordinates(at.x)) {
      for (const double y : ys) {
        const double harm = stages_.harm ? stages_.harm(at, {x, y}) : 0;
        if (harm <= most) continue;
        most = harm;
        worst = {x, y};
      }
    }
    return worst;
  }

  std::array<Point2, 3> Given(const Scene& scene, std::size_t t) const {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    std::array<Point2, 3> given{};
    for (std::size_t k = 0; k < 3; ++k) {
      given[k] = WindowPoint(v[k]);
      if (scene.clip_space) given[k] = {v[k].x / v[k].w, v[k].y / v[k].w};
      const bool is_dropped = stages_.profile.nan_z == NanZ::kNothing && std::isnan(v[k].z);
      if (is_dropped || !IsFinite(v[k]) || (scene.clip_space && !(v[k].w > 0)))
        given[k] = {kNowhere, kNowhere};
    }
    return given;
  }

  std::array<Point2, 3> Placed(const std::array<Point2, 3>& given) const {
    std::array<Point2, 3> placed{};
    for (std::size_t k = 0; k < 3; ++k) placed[k] = LegalPlace(given[k]);
    if (!stages_.instead) return placed;
    const double before = EdgeValue(given[0], given[1], given[2]);
    const bool turned = !(before * EdgeValue(placed[0], placed[1], placed[2]) > 0);
    for (std::size_t k = 0; k < 3; ++k) {
      placed[k] = stages_.instead({given[k], given, turned}, placed[k]);
    }
    return placed;
  }

  void DrawTriangles(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      DrawTriangle(scene, t, options, counts);
    }
  }

  void DrawTriangle(const Scene& scene, std::size_t t, const DrawOptions& options,
                    CoverageCounts& counts) {
    const std::array<Point2, 3> given = Given(scene, t);
    Scene placed;
    placed.width = scene.width;
    placed.height = scene.height;
    placed.precision = scene.precision;
    for (const Point2 p : Placed(given)) placed.vertices.push_back({p.x, p.y, 0, 1});
    placed.triangles = {{0, 1, 2}};
    if (!stages_.rule) {
      DrawOnto(*base_, placed, options, counts);
      return;
    }
    // Another rule is another rasterizer.
    FreeStages ruled = stages_;
    ruled.profile.tie_rule = stages_.rule(given);
    DrawOnto(*MakeBase(info_.name, info_.summary, ruled), placed, options, counts);
  }

  // Barycentrics are those of the vertices as given, in double.
  static void Interpolate(const Scene& scene, std::size_t t, std::size_t k, Drawing& drawing) {
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    const std::array<Point2, 3> at{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    const auto width = static_cast<std::size_t>(scene.width);
    const std::size_t row = k / width;
    const Point2 p{static_cast<double>(k % width) + 0.5, static_cast<double>(row) + 0.5};
    const double area = EdgeValue(at[0], at[1], at[2]);
    drawing.depths[k] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double barycentric = EdgeValue(at[(i + 1) % 3], at[(i + 2) % 3], p) / area;
      drawing.barycentrics[k][i] = barycentric;
      drawing.depths[k] += barycentric * v[i].z;
    }
  }

  FreeStages stages_;
  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> MakeFreeChoice(const std::string& name, const std::string& summary,
                                        FreeStages stages) {
  return std::make_unique<FreeChoice>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
