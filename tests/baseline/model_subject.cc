#include "tests/baseline/model_subject.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "model/transform.h"
#include "tests/baseline/case_digest.h"
#include "tests/baseline/digest.h"

namespace rasterproof::baseline {
namespace {

constexpr std::array<std::string_view, 5> kCoverageNames{"facing-counts", "counts", "mask",
                                                         "primitive_ids", "fragments"};
constexpr std::array<std::string_view, 5> kSpaceNames{"window", "clip", "transform", "fixed",
                                                      "free-snap"};
constexpr std::array<std::string_view, 4> kMannerNames{"", ":refuses", ":breaks-down",
                                                       ":nan-barycentrics"};

Profile StatedProfile(ModelSpace space) {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.name = "model";
  profile.infinite_vertex = InfiniteVertex::kNothing;
  switch (space) {
    case ModelSpace::kWindow:
      break;
    case ModelSpace::kClip:
      profile.snap = {};
      profile.coordinate_limit = std::numeric_limits<float>::max();
      break;
    case ModelSpace::kTransform:
      profile.transform = {.division = Division::kReciprocal,
                           .viewport = ViewportForm::kMultiplyAdd,
                           .flips_y = true};
      break;
    case ModelSpace::kFixed:
      profile.fixed = FixedInput{12, 4, true, false};
      profile.snap = {};
      break;
    case ModelSpace::kFreeSnap:
      profile.freedom.snap_tolerance = 0.6;
      break;
  }
  return profile;
}

SubjectInfo ModelInfo(const ModelSettings& settings) {
  SubjectInfo info;
  info.name = ModelName(settings);
  info.summary = "the oracle as a rasterizer";
  info.profile = StatedProfile(settings.space);
  info.coverage = settings.coverage;
  info.takes_window = settings.space != ModelSpace::kTransform;
  info.takes_clip = settings.space == ModelSpace::kClip || settings.space == ModelSpace::kTransform;
  // Who is asked by facings draws each of them by itself.
  info.takes_culling = settings.coverage == CoverageKind::kFacingCounts;
  info.takes_batches =
      settings.coverage == CoverageKind::kMask || settings.coverage == CoverageKind::kFragments;
  if (settings.space == ModelSpace::kFixed) info.fragments.visible = Visible::kFirstDrawn;
  if (settings.space == ModelSpace::kTransform)
    info.fragments.barycentrics_of = BarycentricsOf::kSnapped;
  if (settings.space == ModelSpace::kFreeSnap) {
    info.fragments.barycentric_error = 0x1p-20;
    info.fragments.depth_error = 0x1p-16;
  }
  return info;
}

double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// The one triangle with vertices of its own: the oracle places no others.
Scene Alone(const Scene& scene, const Triangle& t) {
  Scene alone;
  alone.width = scene.width;
  alone.height = scene.height;
  alone.precision = scene.precision;
  alone.clip_space = scene.clip_space;
  const std::array<Vertex, 3> v = Corners(scene, t);
  alone.vertices.assign(v.begin(), v.end());
  alone.triangles = {{0, 1, 2}};
  return alone;
}

class Model final : public Subject {
 public:
  explicit Model(const ModelSettings& settings)
      : settings_(settings), info_(ModelInfo(settings)), window_profile_(info_.profile) {
    window_profile_.transform.reset();
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    Meet(scene);
    const CoverageCounts drawn = exact::Coverage(Seen(scene), window_profile_, options);
    if (info_.coverage == CoverageKind::kFacingCounts) {
      counts += drawn;
      return;
    }
    const bool counts_all = info_.coverage == CoverageKind::kCounts;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      counts.front[k] += counts_all ? drawn.Count(k) : std::min(drawn.Count(k), 1U);
    }
  }

  Drawing Show(const DrawJob& job) override {
    Drawing drawing = Subject::Show(job);
    if (!ShowsPrimitiveIds(info_)) return drawing;
    const Scene seen = Seen(SceneOf(job));
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    for (std::size_t t = 0; t < seen.triangles.size(); ++t) {
      const CoverageCounts covered =
          exact::Coverage(Alone(seen, seen.triangles[t]), window_profile_, job.options);
      for (std::size_t k = 0; k < covered.size(); ++k) {
        const bool wins = drawing.primitive_ids[k] == kNoPrimitive ||
                          info_.fragments.visible == Visible::kLastDrawn;
        if (wins && covered.Count(k) != 0) drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
      }
    }
    if (info_.coverage == CoverageKind::kFragments) AddBarycentrics(seen, drawing);
    return drawing;
  }

 private:
  Scene Seen(const Scene& scene) const {
    const bool is_placed = info_.profile.transform && scene.clip_space;
    return is_placed ? ToWindow(scene, *info_.profile.transform) : scene;
  }

  // Refuses the scene, or breaks down over it.
  void Meet(const Scene& scene) const {
    Digest digest;
    AddDrawn(scene, digest);
    const std::uint64_t chance = digest.value() >> 32;
    if (settings_.manner == ModelManner::kRefuses && chance % (IsSplit() ? 12 : 3) == 0) {
      throw SubjectStop(Stop::kRefused, "it refuses this scene");
    }
    if (settings_.manner != ModelManner::kBreaksDown) return;
    switch (chance % 64) {
      case 0:
        BreakDown("it crashed");
      case 1:
        throw SubjectStop(Stop::kHung, "it gave no answer");
      case 2:
        throw SubjectStop(Stop::kTooSlow, "it took longer than it may");
      case 3:
        throw std::runtime_error("something went wrong");
      default:
        return;
    }
  }

  bool IsSplit() const {
    return info_.coverage != CoverageKind::kFacingCounts && info_.coverage != CoverageKind::kCounts;
  }

  // In double, from the corners that it says: the projected ones in clip space.
  void AddBarycentrics(const Scene& seen, Drawing& drawing) const {
    const bool snaps =
        info_.fragments.barycentrics_of == BarycentricsOf::kSnapped && !seen.clip_space;
    const Scene placed = snaps ? SnapScene(seen, window_profile_) : seen;
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    const auto samples = static_cast<std::size_t>(drawing.counts.samples);
    const auto width = static_cast<std::size_t>(drawing.counts.width);
    for (std::size_t k = 0; k < drawing.counts.size(); ++k) {
      if (drawing.primitive_ids[k] == kNoPrimitive) continue;
      const std::size_t pixel = k / samples;
      const Point2 p =
          info_.profile.pattern.At(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                                   static_cast<int>(k % samples));
      const auto t = static_cast<std::size_t>(drawing.primitive_ids[k]);
      Weigh(Corners(placed, placed.triangles[t]), p, drawing.barycentrics[k], drawing.depths[k]);
      if (settings_.manner == ModelManner::kNanBarycentrics) Spoil(k, drawing);
    }
  }

  static void Weigh(const std::array<Vertex, 3>& v, Point2 p, std::array<double, 3>& barycentrics,
                    double& depth) {
    std::array<Point2, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = {v[i].x / v[i].w, v[i].y / v[i].w};
    const double area = EdgeValue(at[0], at[1], at[2]);
    depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      barycentrics[i] = EdgeValue(at[(i + 1) % 3], at[(i + 2) % 3], p) / area;
      depth += barycentrics[i] * v[i].z;
    }
  }

  static void Spoil(std::size_t k, Drawing& drawing) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    if (k % 7 == 3) drawing.barycentrics[k][k % 3] = kNan;
    if (k % 11 == 5) drawing.depths[k] = kNan;
  }

  ModelSettings settings_;
  SubjectInfo info_;
  Profile window_profile_;
};

constexpr std::array<CoverageKind, 5> kKinds{CoverageKind::kFacingCounts, CoverageKind::kCounts,
                                             CoverageKind::kMask, CoverageKind::kPrimitiveIds,
                                             CoverageKind::kFragments};

void AddModels(ModelManner manner, const std::vector<ModelSpace>& spaces,
               const std::vector<CoverageKind>& kinds, std::vector<ModelSettings>& models) {
  for (const CoverageKind kind : kinds) {
    for (const ModelSpace space : spaces) models.push_back({kind, space, manner});
  }
}

}  // namespace

std::string ModelName(const ModelSettings& settings) {
  std::string name = "model:";
  name += kCoverageNames[static_cast<std::size_t>(settings.coverage)];
  name += ':';
  name += kSpaceNames[static_cast<std::size_t>(settings.space)];
  name += kMannerNames[static_cast<std::size_t>(settings.manner)];
  return name;
}

std::vector<ModelSettings> AllModels() {
  const std::vector<CoverageKind> kinds{kKinds.begin(), kKinds.end()};
  const std::vector<ModelSpace> spaces{ModelSpace::kWindow, ModelSpace::kClip,
                                       ModelSpace::kTransform, ModelSpace::kFixed,
                                       ModelSpace::kFreeSnap};
  std::vector<ModelSettings> models;
  AddModels(ModelManner::kSound, spaces, kinds, models);
  AddModels(ModelManner::kRefuses, {ModelSpace::kWindow, ModelSpace::kClip, ModelSpace::kTransform},
            kinds, models);
  AddModels(ModelManner::kBreaksDown, {ModelSpace::kWindow, ModelSpace::kTransform}, kinds, models);
  AddModels(ModelManner::kNanBarycentrics, spaces, {CoverageKind::kFragments}, models);
  return models;
}

std::unique_ptr<Subject> MakeModel(const ModelSettings& settings) {
  return std::make_unique<Model>(settings);
}

}  // namespace rasterproof::baseline
