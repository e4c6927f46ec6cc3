#include "props/cause/suspect.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/drawing.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "model/drop.h"
#include "model/snap.h"
#include "model/target_profile.h"
#include "model/transform.h"
#include "model/wrap.h"

namespace rasterproof::props {

int ToPixel(double x) {
  constexpr double kFarthest = 0x1p28;  // of a box's end: targets are smaller
  return static_cast<int>(std::clamp(x, -kFarthest, kFarthest));
}

namespace {

// What one draw sees of its target.
struct SuspectTarget {
  const Scene& scene;
  DrawOptions options;
  TargetProfile profile;
  std::vector<Point2> offsets = {};  // of sample s from pixel (x, row), in axes of the screen
  PixelRect clip = {};
};

class SuspectSubject final : public Subject {
 public:
  SuspectSubject(const SubjectInfo& info, SuspectStages stages)
      : info_(info), stages_(std::move(stages)), profile_(info.profile) {
    if (stages_.profile) stages_.profile(profile_);
  }

  const SubjectInfo& OwnInfo() const override { return info_; }
  Subject* Twin() override {
    if (!twin_) twin_ = std::make_unique<SuspectSubject>(info_, stages_);
    return twin_.get();
  }

 protected:
  Drawing Show(const DrawJob& job) override;
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;

 private:
  // Calls `show(index, triangle, times)` for each sample that a triangle covers.
  template <class Shows>
  void ForEachSample(const Scene& scene, const DrawOptions& options, const Shows& show) const;
  std::optional<SuspectTriangle> SetUp(const SuspectTarget& target, std::size_t number) const;
  Point2 Placed(const Vertex& v, const Profile& profile) const;
  PixelRect BoxOf(const SuspectTriangle& triangle, const SuspectTarget& target) const;
  std::array<SuspectEdge, 3> EdgesOf(const SuspectTriangle& triangle, const Profile& profile) const;
  bool Covers(const std::array<SuspectEdge, 3>& edges, const SuspectTriangle& triangle,
              const SuspectSample& sample) const;

  void DrawByStages(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) const;
  Scene Clipped(const Scene& scene) const;

  SubjectInfo info_;
  SuspectStages stages_;
  Profile profile_;  ///< by which it draws
  std::unique_ptr<SuspectSubject> twin_;
};

Point2 SuspectSubject::Placed(const Vertex& v, const Profile& profile) const {
  const auto place = [&](double x, bool along_y) {
    if (profile.fixed && std::isfinite(x)) x = Wrapped(x, *profile.fixed);
    return stages_.snap ? stages_.snap(x, along_y) : SnapCoordinate(x, profile.snap);
  };
  const double y = place(v.y, true);
  Point2 p{place(v.x, false), profile.y_axis == YAxis::kUp ? -y : y};
  if (stages_.place) stages_.place(p);
  return p;
}

std::optional<SuspectTriangle> SuspectSubject::SetUp(const SuspectTarget& target,
                                                     std::size_t number) const {
  const Scene& scene = target.scene;
  SuspectTriangle triangle;
  triangle.number = number;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.indices[i] = scene.triangles[number][i];
    triangle.given[i] = Corners(scene, scene.triangles[number])[i];
    Vertex v = triangle.given[i];
    if (stages_.input) stages_.input(v);
    const bool z_drops = std::isnan(v.z) && target.profile.nan_z == NanZ::kNothing;
    if (!IsFinite(v) || z_drops) return std::nullopt;
    triangle.v[i] = Placed(v, target.profile);
    if (!std::isfinite(triangle.v[i].x) || !std::isfinite(triangle.v[i].y)) return std::nullopt;
  }
  const auto& v = triangle.v;
  const auto& most = target.profile.max_primitive_extent;
  if (most && Exceeds(v, *most)) return std::nullopt;
  if (stages_.drops && stages_.drops(triangle, scene)) return std::nullopt;
  const int area = stages_.area ? stages_.area(v) : exact::EdgeSign(v[0], v[1], v[2]);
  if (area == 0 && !stages_.draws_flat) return std::nullopt;
  if (AlwaysCulls(target.profile, area)) return std::nullopt;
  triangle.is_front = area > 0;
  if (!triangle.is_front) {
    std::swap(triangle.v[1], triangle.v[2]);
    std::swap(triangle.indices[1], triangle.indices[2]);
    std::swap(triangle.given[1], triangle.given[2]);
  }
  if (stages_.facing) stages_.facing(triangle);
  return triangle;
}

PixelRect SuspectSubject::BoxOf(const SuspectTriangle& triangle,
                                const SuspectTarget& target) const {
  const auto [left, right] = std::ranges::minmax(triangle.v, {}, &Point2::x);
  const auto [top, bottom] = std::ranges::minmax(triangle.v, {}, &Point2::y);
  const auto [least_x, most_x] = std::ranges::minmax(target.offsets, {}, &Point2::x);
  const auto [least_y, most_y] = std::ranges::minmax(target.offsets, {}, &Point2::y);
  PixelRect box{ToPixel(std::ceil(left.x - most_x.x)), ToPixel(std::ceil(top.y - most_y.y)),
                ToPixel(std::floor(right.x - least_x.x) + 1),
                ToPixel(std::floor(bottom.y - least_y.y) + 1)};
  if (stages_.sample) box = {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1};
  if (stages_.box) stages_.box(box, triangle, target.scene);
  return {std::max(box.x0, target.clip.x0), std::max(box.y0, target.clip.y0),
          std::min(box.x1, target.clip.x1), std::min(box.y1, target.clip.y1)};
}

std::array<SuspectEdge, 3> SuspectSubject::EdgesOf(const SuspectTriangle& triangle,
                                                   const Profile& profile) const {
  std::array<SuspectEdge, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    SuspectEdge& edge = edges[i];
    edge = {static_cast<int>(i), triangle.v[(i + 1) % 3], triangle.v[(i + 2) % 3]};
    // The sign at a point of the edge itself: at its own end.
    edge.owns = exact::ShiftedEdgeSign(edge.a, edge.b, edge.a, profile.tie_rule) > 0 ||
                profile.tie_rule.inclusive;
  }
  return edges;
}

bool SuspectSubject::Covers(const std::array<SuspectEdge, 3>& edges,
                            const SuspectTriangle& triangle, const SuspectSample& sample) const {
  for (const SuspectEdge& edge : edges) {
    const int sign =
        stages_.value ? stages_.value(edge, sample) : exact::EdgeSign(edge.a, edge.b, sample.at);
    if (sign < 0) return false;
    if (sign > 0) continue;
    if (!(stages_.owns ? stages_.owns(edge, triangle, sample) : edge.owns)) return false;
  }
  return true;
}

template <class Shows>
void SuspectSubject::ForEachSample(const Scene& given, const DrawOptions& options,
                                   const Shows& show) const {
  const Profile& stated = profile_;
  const Scene scene = TakesToWindow(stated, given) ? ToWindow(given, *stated.transform) : given;
  SuspectTarget target{scene, options, TargetProfile(stated, scene)};
  if (stages_.options) stages_.options(target.options, scene);
  const bool y_up = stated.y_axis == YAxis::kUp;
  for (const Point2& l : target.profile.pattern.locations)
    target.offsets.push_back({l.x, y_up ? -(scene.height - 1) - l.y : l.y});
  const PixelRect whole{0, 0, scene.width, scene.height};
  const PixelRect cut = target.options.scissor.value_or(whole);
  target.clip = {std::max(0, cut.x0), std::max(0, cut.y0), std::min(scene.width, cut.x1),
                 std::min(scene.height, cut.y1)};
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::optional<SuspectTriangle> triangle = SetUp(target, t);
    if (!triangle) continue;
    if (target.options.cull == (triangle->is_front ? Cull::kFront : Cull::kBack)) continue;
    const std::array<SuspectEdge, 3> edges = EdgesOf(*triangle, target.profile);
    const PixelRect box = BoxOf(*triangle, target);
    for (int row = box.y0; row < box.y1; ++row) {
      for (int x = box.x0; x < box.x1; ++x) {
        for (std::size_t s = 0; s < target.offsets.size(); ++s) {
          SuspectSample sample{x,           row,         static_cast<int>(s), target.offsets[s],
                               scene.width, scene.height};
          sample.at = {sample.at.x + x, sample.at.y + row};
          if (stages_.sample) sample.at = stages_.sample(sample);
          if (!Covers(edges, *triangle, sample)) continue;
          show(sample, *triangle, stages_.times ? stages_.times(sample, *triangle) : 1U);
        }
      }
    }
  }
}

// The pieces of all triangles, each with vertices of its own.
Scene SuspectSubject::Clipped(const Scene& scene) const {
  if (!stages_.clip || !scene.clip_space) return scene;
  Scene pieces = scene;
  pieces.precision = Precision::kFloat64;
  pieces.vertices.clear();
  pieces.triangles.clear();
  for (const Triangle& t : scene.triangles) {
    for (const SuspectClip& piece : stages_.clip(Corners(scene, t))) {
      const auto first = static_cast<std::int32_t>(pieces.vertices.size());
      pieces.vertices.insert(pieces.vertices.end(), piece.begin(), piece.end());
      pieces.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return pieces;
}

void SuspectSubject::Draw(const Scene& scene, const DrawOptions& given, CoverageCounts& counts) {
  if (!HasStages(scene, profile_)) {
    DrawOptions options = given;
    if (stages_.options) stages_.options(options, scene);
    CoverageCounts drawn = exact::Coverage(Clipped(scene), profile_, options);
    if (info_.coverage != CoverageKind::kFacingCounts) {
      for (std::size_t k = 0; k < drawn.size(); ++k)
        drawn.front[k] += std::exchange(drawn.back[k], 0U);
    }
    counts += drawn;
  } else {
    DrawByStages(scene, given, counts);
  }
  if (stages_.after) stages_.after(counts);
  if (info_.coverage != CoverageKind::kMask) return;
  for (std::uint32_t& count : counts.front) count = std::min(count, 1U);
}

void SuspectSubject::DrawByStages(const Scene& scene, const DrawOptions& options,
                                  CoverageCounts& counts) const {
  ForEachSample(scene, options,
                [&](const SuspectSample& at, const SuspectTriangle& triangle, std::uint32_t times) {
                  const bool tells = info_.coverage == CoverageKind::kFacingCounts;
                  const std::size_t k = counts.Index(at.x, at.row, at.number);
                  (triangle.is_front || !tells ? counts.front : counts.back)[k] += times;
                });
}

Drawing SuspectSubject::Show(const DrawJob& job) {
  if (!ShowsPrimitiveIds(info_)) return Subject::Show(job);
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  CoverageCounts& counts = drawing.counts;
  drawing.primitive_ids.assign(counts.size(), kNoPrimitive);
  const bool first = info_.fragments.visible == Visible::kFirstDrawn;
  ForEachSample(SceneOf(job), job.options,
                [&](const SuspectSample& at, const SuspectTriangle& triangle, std::uint32_t times) {
                  const std::size_t k = counts.Index(at.x, at.row, at.number);
                  if (times == 0 || (first && counts.front[k] != 0)) return;
                  counts.front[k] = 1;
                  drawing.primitive_ids[k] = static_cast<std::int32_t>(triangle.number);
                });
  return drawing;
}

// Fills `into` from `from` where only one of the two is there.
template <class Stage>
bool Merge(Stage& into, const Stage& from) {
  if (into && from) return false;
  if (from) into = from;
  return true;
}

// Both changes, one after the other.
template <class... Arguments>
std::function<void(Arguments...)> InTurn(std::function<void(Arguments...)> first,
                                         std::function<void(Arguments...)> second) {
  if (!first) return second;
  if (!second) return first;
  return [first = std::move(first), second = std::move(second)](Arguments... arguments) {
    first(arguments...);
    second(arguments...);
  };
}

}  // namespace

std::optional<SuspectStages> Composed(const SuspectStages& a, const SuspectStages& b) {
  SuspectStages both = a;
  both.draws_flat = a.draws_flat || b.draws_flat;
  both.profile = InTurn(a.profile, b.profile);
  both.options = InTurn(a.options, b.options);
  both.input = InTurn(a.input, b.input);
  both.place = InTurn(a.place, b.place);
  both.facing = InTurn(a.facing, b.facing);
  both.box = InTurn(a.box, b.box);
  both.after = InTurn(a.after, b.after);
  if (a.drops && b.drops) {
    both.drops = [one = a.drops, two = b.drops](const SuspectTriangle& t, const Scene& scene) {
      return one(t, scene) || two(t, scene);
    };
  } else if (b.drops) {
    both.drops = b.drops;
  }
  if (a.times && b.times) {
    both.times = [one = a.times, two = b.times](const SuspectSample& s, const SuspectTriangle& t) {
      return one(s, t) * two(s, t);
    };
  } else if (b.times) {
    both.times = b.times;
  }
  const bool is_one = Merge(both.clip, b.clip) && Merge(both.snap, b.snap) &&
                      Merge(both.area, b.area) && Merge(both.sample, b.sample) &&
                      Merge(both.value, b.value) && Merge(both.owns, b.owns);
  return is_one ? std::optional(both) : std::nullopt;
}

bool HasStages(const Scene& scene, const Profile& profile) {
  return !profile.squares && profile.scanline_rounding.IsNone() &&
         profile.contract != Contract::kSquares && !IsHomogeneous(scene, profile);
}

double WorkOf(const Scene& scene, const SubjectInfo& info) {
  const double samples = double{1} * scene.width * scene.height * info.profile.pattern.samples();
  const auto triangles = static_cast<double>(std::max<std::size_t>(1, scene.triangles.size()));
  return samples * triangles;
}

bool SuspectsDraw(const Scene& scene, const SubjectInfo& info) {
  constexpr double kMostWork = 0x1p18;
  if (WorkOf(scene, info) > kMostWork) return false;
  if (HasStages(scene, info.profile)) return true;
  return !ShowsPrimitiveIds(info) && !exact::WhyNotDecided({scene, info.profile});
}

std::unique_ptr<Subject> MakeSuspect(const SubjectInfo& info, SuspectStages stages) {
  return std::make_unique<SuspectSubject>(info, std::move(stages));
}

std::vector<Suspect> SuspectsOf(const Profile& profile) {
  std::vector<Suspect> list;
  AddEdges(profile, list);
  AddPlacing(profile, list);
  AddTaking(profile, list);
  AddTraversal(profile, list);
  AddClipping(profile, list);
  return list;
}

}  // namespace rasterproof::props
