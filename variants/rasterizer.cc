#include "variants/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rasterproof::variants {
namespace {

template <class Number>
int Compare(Number a, Number b) {
  return (a > b) - (a < b);
}

template <class Point>
class Rasterizer final : public Subject {
 public:
  Rasterizer(const SubjectInfo& info, Stages<Point> stages, const Arithmetic<Point>& arithmetic)
      : info_(info), stages_(std::move(stages)), base_(arithmetic) {
    if (stages_.batch) info_.takes_batches = true;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    std::vector<DrawOutcome> outcomes = Subject::DrawMany(jobs);
    if (stages_.batch && outcomes.size() > 1) stages_.batch(outcomes);
    return outcomes;
  }
  Subject* Twin() override {
    if (!base_.has_twin) return nullptr;
    if (!twin_) twin_ = std::make_unique<Rasterizer>(info_, stages_, base_);
    return twin_.get();
  }

 protected:
  std::optional<InputError> WhyNotDrawn(const DrawJob& job) const override;
  Drawing Show(const DrawJob& job) override;
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;

 private:
  static constexpr std::size_t kMostKept = 64;
  static constexpr int kNoTiles = 1 << 29;  // wider than any target

  // What one draw sees of its target, and what it draws there.
  struct Target {
    const Scene& scene;
    const Profile& model;
    DrawOptions options;
    CoverageCounts& counts;
    Drawing* shown;                   // if set, a sample shows one triangle
    std::vector<Point> offsets = {};  // of sample s from pixel (x, row)
    PixelRect clip = {};
    int tile = 0;
  };

  Profile ModelOf(const Scene& scene) const;
  Scene Clipped(const Scene& scene) const;
  CoverageCounts DrawnWhole(const Scene& scene, const Profile& model, DrawOptions options) const;
  void DrawAnew(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);
  void DrawTriangles(const Scene& scene, const Profile& model, const DrawOptions& options,
                     CoverageCounts& counts, Drawing* shown) const;
  void Prepare(Target& target) const;
  std::optional<Point> PlacedVertex(const Vertex& v, const Target& target) const;
  std::optional<Placed<Point>> SetUp(const Target& target, std::size_t number) const;
  PixelRect BoxOf(const Placed<Point>& triangle, const Target& target) const;
  void DrawTriangle(const Placed<Point>& triangle, Target& target) const;
  TileTest Test(const Placed<Point>& triangle, const PixelRect& tile, const Target& target) const;
  bool Covers(const Placed<Point>& triangle, const Sample<Point>& sample) const;
  void DrawTile(const Placed<Point>& triangle, const PixelRect& tile, Target& target) const;
  void Put(const Sample<Point>& sample, const Placed<Point>& triangle, Target& target) const;
  void ShowAt(std::size_t k, const Sample<Point>& sample, const Placed<Point>& triangle,
              Target& target) const;

  SubjectInfo info_;
  Stages<Point> stages_;
  Arithmetic<Point> base_;
  std::map<std::vector<std::int64_t>, CoverageCounts> kept_;
  std::unique_ptr<Rasterizer> twin_;
};

template <class Point>
Profile Rasterizer<Point>::ModelOf(const Scene& scene) const {
  Profile model = info_.profile;
  if (stages_.model) stages_.model(model, scene);
  return model;
}

template <class Point>
void Rasterizer<Point>::Prepare(Target& target) const {
  const Scene& scene = target.scene;
  if (stages_.options) stages_.options(target.options, scene);
  const PixelRect whole{0, 0, scene.width, scene.height};
  const PixelRect cut = target.options.scissor.value_or(whole);
  target.clip = {std::max(0, cut.x0), std::max(0, cut.y0), std::min(scene.width, cut.x1),
                 std::min(scene.height, cut.y1)};
  const bool y_up = target.model.y_axis == YAxis::kUp;
  for (const Point2& l : target.model.pattern.locations)
    target.offsets.push_back(base_.lattice.At(l.x, y_up ? -(scene.height - 1) - l.y : l.y));
  const int own = stages_.tile > 0 ? stages_.tile : base_.tile;
  target.tile = own == 0 ? kNoTiles : target.options.tile > 0 ? target.options.tile : own;
}

template <class Point>
std::optional<Point> Rasterizer<Point>::PlacedVertex(const Vertex& v, const Target& target) const {
  const Profile& model = target.model;
  const auto place = [&](double x, bool along_y) {
    if (model.fixed && std::isfinite(x))
      x = stages_.wrap ? stages_.wrap(x) : base_.wrap(x, *model.fixed);
    return stages_.snap ? stages_.snap(x, along_y) : base_.snap(x, model.snap);
  };
  const double x = place(v.x, false);
  const double y = place(v.y, true);
  const double limit = model.coordinate_limit;
  if (!base_.lattice.Reaches(x, limit) || !base_.lattice.Reaches(y, limit)) return std::nullopt;
  Point p = base_.lattice.At(x, model.y_axis == YAxis::kUp ? -y : y);
  if (stages_.place) stages_.place(p, target.scene);
  return p;
}

template <class Point>
std::optional<Placed<Point>> Rasterizer<Point>::SetUp(const Target& target,
                                                      std::size_t number) const {
  const Profile& model = target.model;
  Placed<Point> triangle;
  triangle.number = number;
  triangle.indices = target.scene.triangles[number];
  triangle.given = Corners(target.scene, triangle.indices);
  std::array<Vertex, 3> corners = triangle.given;
  if (stages_.vertices) stages_.vertices(corners);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool z_drops = std::isnan(corners[i].z) && model.nan_z == NanZ::kNothing;
    if (!IsFinite(corners[i]) || z_drops) return std::nullopt;
    const std::optional<Point> p = PlacedVertex(corners[i], target);
    if (!p) return std::nullopt;
    triangle.v[i] = *p;
  }
  const std::array<Point, 3>& v = triangle.v;
  if (const auto& most = model.max_primitive_extent) {
    if (stages_.too_large ? stages_.too_large(v) : base_.exceeds(v, *most, base_.lattice))
      return std::nullopt;
  }
  if (stages_.leaves_out && stages_.leaves_out(triangle, target.scene)) return std::nullopt;
  const ValueOf<Point> area = stages_.area ? stages_.area(v) : base_.value(v[0], v[1], v[2]);
  if (area == 0 && !stages_.draws_flat) return std::nullopt;
  if (AlwaysCulls(model, Compare(area, {}))) return std::nullopt;
  triangle.front = area > 0;
  triangle.is_turned = !triangle.front;
  if (triangle.is_turned) {
    std::swap(triangle.v[1], triangle.v[2]);
    std::swap(triangle.indices[1], triangle.indices[2]);
    std::swap(triangle.given[1], triangle.given[2]);
  }
  if (stages_.facing) stages_.facing(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    Edge<Point>& edge = triangle.edges[i];
    edge = {v[(i + 1) % 3], v[(i + 2) % 3], false, static_cast<int>(i)};
    edge.owns = Owns(edge, model.tie_rule);
  }
  if (stages_.edges) stages_.edges(triangle);
  return triangle;
}

template <class Point>
PixelRect Rasterizer<Point>::BoxOf(const Placed<Point>& triangle, const Target& target) const {
  const auto [left, right] = std::ranges::minmax(triangle.v, {}, &Point::x);
  const auto [top, bottom] = std::ranges::minmax(triangle.v, {}, &Point::y);
  const auto [least_x, most_x] = std::ranges::minmax(target.offsets, {}, &Point::x);
  const auto [least_y, most_y] = std::ranges::minmax(target.offsets, {}, &Point::y);
  // A sample at the far end of the box can be inside under some rules: one pixel beyond ends it.
  const Lattice<Point>& lattice = base_.lattice;
  PixelRect box{lattice.FirstPixel(left.x, most_x.x), lattice.FirstPixel(top.y, most_y.y),
                lattice.EndPixel(right.x, least_x.x), lattice.EndPixel(bottom.y, least_y.y)};
  if (stages_.sample) box = {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1};
  if (stages_.box) stages_.box(box, triangle, target.scene);
  return {std::max(box.x0, target.clip.x0), std::max(box.y0, target.clip.y0),
          std::min(box.x1, target.clip.x1), std::min(box.y1, target.clip.y1)};
}

template <class Point>
TileTest Rasterizer<Point>::Test(const Placed<Point>& triangle, const PixelRect& tile,
                                 const Target& target) const {
  // Samples that lie elsewhere, and other values, do so for tiles too: each sample is tested.
  if (stages_.sample || stages_.value || target.tile == kNoTiles) return TileTest::kMixed;
  const auto [least_x, most_x] = std::ranges::minmax(target.offsets, {}, &Point::x);
  const auto [least_y, most_y] = std::ranges::minmax(target.offsets, {}, &Point::y);
  const Point top_left = base_.lattice.SampleOf(tile.x0, tile.y0, {least_x.x, least_y.y});
  const Point bottom_right = base_.lattice.SampleOf(tile.x1 - 1, tile.y1 - 1, {most_x.x, most_y.y});
  std::array<typename Stages<Point>::TileCorners, 3> values{};
  TileTest test = TileTest::kInside;
  for (std::size_t i = 0; i < 3; ++i) {
    const Edge<Point>& edge = triangle.edges[i];
    const auto at = [&](Point p) { return base_.value(edge.a, edge.b, p); };
    values[i] = {at(top_left), at({bottom_right.x, top_left.y}), at({top_left.x, bottom_right.y}),
                 at(bottom_right)};
    const auto [least, most] = std::ranges::minmax(values[i]);
    if (most < 0) {
      test = TileTest::kOutside;
    } else if (least <= 0 && test == TileTest::kInside) {
      test = TileTest::kMixed;
    }
  }
  return stages_.tile_test ? stages_.tile_test(values, test) : test;
}

template <class Point>
bool Rasterizer<Point>::Covers(const Placed<Point>& triangle, const Sample<Point>& sample) const {
  for (const std::size_t i : {2U, 0U, 1U}) {  // from the edge that begins at the first vertex
    const Edge<Point>& edge = triangle.edges[i];
    const ValueOf<Point> e =
        stages_.value ? stages_.value(edge, sample) : base_.value(edge.a, edge.b, sample.at);
    if (e < 0) return false;
    if (e > 0) continue;
    if (!(stages_.owns ? stages_.owns(edge, triangle, sample) : edge.owns)) return false;
  }
  return true;
}

template <class Point>
void Rasterizer<Point>::Put(const Sample<Point>& sample, const Placed<Point>& triangle,
                            Target& target) const {
  const std::uint32_t times = stages_.times ? stages_.times(sample, triangle) : 1;
  CoverageCounts& counts = target.counts;
  const std::size_t k =
      stages_.index ? stages_.index(counts, sample) : counts.Index(sample.x, sample.row, sample.s);
  if (k >= counts.size()) return;
  if (target.shown == nullptr) {
    const bool tells = info_.coverage == CoverageKind::kFacingCounts;
    (triangle.front || !tells ? counts.front : counts.back)[k] += times;
    return;
  }
  const bool is_taken = info_.fragments.visible == Visible::kFirstDrawn && counts.front[k] != 0;
  if (times == 0 || is_taken) return;
  counts.front[k] = 1;
  ShowAt(k, sample, triangle, target);
}

template <class Point>
void Rasterizer<Point>::ShowAt(std::size_t k, const Sample<Point>& sample,
                               const Placed<Point>& triangle, Target& target) const {
  Drawing& shown = *target.shown;
  const std::size_t count = target.scene.triangles.size();
  const std::size_t id = stages_.id ? stages_.id(triangle.number, count) : triangle.number;
  shown.primitive_ids[k] = static_cast<std::int32_t>(id);
  if (shown.barycentrics.empty()) return;
  const auto pixels = [&](Point p) { return base_.lattice.InPixels(p); };
  const std::array<Point, 3> v = triangle.AsListed(triangle.v);
  Weights& weights = shown.barycentrics[k];
  weights = BarycentricsAt({pixels(v[0]), pixels(v[1]), pixels(v[2])}, pixels(sample.at));
  if (stages_.weights) stages_.weights(weights, triangle, sample);
  double depth = 0;
  const std::array<Vertex, 3> given = triangle.AsListed(triangle.given);
  for (std::size_t i = 0; i < 3; ++i) depth += weights[i] * given[i].z;
  if (stages_.depth) stages_.depth(depth, weights, triangle);
  shown.depths[k] = depth;
}

template <class Point>
void Rasterizer<Point>::DrawTile(const Placed<Point>& triangle, const PixelRect& tile,
                                 Target& target) const {
  const TileTest test = Test(triangle, tile, target);
  if (test == TileTest::kOutside) return;
  const Scene& scene = target.scene;
  for (int row = tile.y0; row < tile.y1; ++row) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      for (std::size_t s = 0; s < target.offsets.size(); ++s) {
        const Point at = base_.lattice.SampleOf(x, row, target.offsets[s]);
        Sample<Point> sample{x, row, static_cast<int>(s), at, scene.width, scene.height};
        if (stages_.sample) sample.at = stages_.sample(sample);
        if (test == TileTest::kInside || Covers(triangle, sample)) Put(sample, triangle, target);
      }
    }
  }
}

template <class Point>
void Rasterizer<Point>::DrawTriangle(const Placed<Point>& triangle, Target& target) const {
  const PixelRect box = BoxOf(triangle, target);
  const int side = target.tile;
  const int workers = std::max(1, target.options.threads);
  // A scissor may lie anywhere.
  const std::int64_t height = std::int64_t{box.y1} - box.y0;
  for (int worker = 0; worker < workers; ++worker) {
    const auto row = [&](int share) { return static_cast<int>(box.y0 + height * share / workers); };
    int begin = row(worker);
    int end = row(worker + 1);
    if (stages_.share) stages_.share(begin, end, worker, workers);
    // Tiles lie on a grid of the target; a box's and a share's ends cut them.
    for (int y = begin / side * side; y < end; y += side) {
      for (int x = box.x0 / side * side; x < box.x1; x += side) {
        const PixelRect tile{std::max(x, box.x0), std::max(y, begin), std::min(x + side, box.x1),
                             std::min(y + side, end)};
        DrawTile(triangle, tile, target);
      }
    }
  }
}

// `shown`: where it shows one triangle a sample.
template <class Point>
void Rasterizer<Point>::DrawTriangles(const Scene& given, const Profile& model,
                                      const DrawOptions& options, CoverageCounts& counts,
                                      Drawing* shown) const {
  std::optional<Scene> taken;
  if (base_.to_window != nullptr) taken = base_.to_window(model, given);
  if (stages_.scene) stages_.scene(taken ? *taken : taken.emplace(given), options);
  const Scene& scene = taken ? *taken : given;
  const Profile on_target = base_.on_target(model, scene);
  Target target{scene, on_target, options, counts, shown};
  Prepare(target);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    if (stages_.drops && stages_.drops(scene, t)) continue;
    const std::optional<Placed<Point>> triangle = SetUp(target, t);
    if (!triangle) continue;
    if (target.options.cull == (triangle->front ? Cull::kFront : Cull::kBack)) continue;
    DrawTriangle(*triangle, target);
  }
}

template <class Point>
Drawing Rasterizer<Point>::Show(const DrawJob& job) {
  if (!ShowsPrimitiveIds(info_)) return Subject::Show(job);
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
  if (info_.coverage == CoverageKind::kFragments) {
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
  }
  const Scene scene = SceneOf(job);
  DrawTriangles(scene, ModelOf(scene), job.options, drawing.counts, &drawing);
  return drawing;
}

template <class Point>
void Rasterizer<Point>::Draw(const Scene& scene, const DrawOptions& options,
                             CoverageCounts& counts) {
  if (!stages_.kept_by) return DrawAnew(scene, options, counts);
  std::vector<std::int64_t> key = stages_.kept_by(scene);
  for (const int word : {scene.width, scene.height, static_cast<int>(options.cull)}) {
    key.push_back(word);
  }
  if (const auto& cut = options.scissor) {
    key.insert(key.end(), {cut->x0, cut->y0, cut->x1, cut->y1});
  }
  if (kept_.size() >= kMostKept) kept_.clear();
  const auto [entry, is_new] =
      kept_.try_emplace(key, scene.width, scene.height, info_.profile.pattern.samples());
  if (is_new) DrawAnew(scene, options, entry->second);
  counts += entry->second;
}

// The pieces of all triangles, each with vertices of its own.
template <class Point>
Scene Rasterizer<Point>::Clipped(const Scene& scene) const {
  if (!stages_.clip || !scene.clip_space) return scene;
  Scene pieces = scene;
  pieces.precision = Precision::kFloat64;
  pieces.vertices.clear();
  pieces.triangles.clear();
  for (const Triangle& t : scene.triangles) {
    for (const ClipTriangle& piece : stages_.clip(Corners(scene, t))) {
      const auto first = static_cast<std::int32_t>(pieces.vertices.size());
      pieces.vertices.insert(pieces.vertices.end(), piece.begin(), piece.end());
      pieces.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return pieces;
}

template <class Point>
std::optional<InputError> Rasterizer<Point>::WhyNotDrawn(const DrawJob& job) const {
  if (base_.why_not_whole == nullptr) return std::nullopt;
  const Scene scene = SceneOf(job);
  const Profile model = ModelOf(scene);
  if (base_.has_stages == nullptr || base_.has_stages(scene, model)) return std::nullopt;
  return base_.why_not_whole(Clipped(scene), model);
}

template <class Point>
CoverageCounts Rasterizer<Point>::DrawnWhole(const Scene& scene, const Profile& model,
                                             DrawOptions options) const {
  if (!stages_.turns_over) return base_.whole(Clipped(scene), model, options);
  Scene kept = scene;
  Scene turned = scene;
  const auto is_turned = [&](const Triangle& t) { return stages_.turns_over(Corners(scene, t)); };
  std::erase_if(kept.triangles, is_turned);
  std::erase_if(turned.triangles, std::not_fn(is_turned));
  CoverageCounts drawn = base_.whole(Clipped(kept), model, options);
  if (options.cull != Cull::kNone)
    options.cull = options.cull == Cull::kFront ? Cull::kBack : Cull::kFront;
  CoverageCounts over = base_.whole(Clipped(turned), model, options);
  std::swap(over.front, over.back);
  drawn += over;
  return drawn;
}

template <class Point>
void Rasterizer<Point>::DrawAnew(const Scene& scene, const DrawOptions& given,
                                 CoverageCounts& counts) {
  const Profile model = ModelOf(scene);
  const CoverageCounts before = stages_.after ? counts : CoverageCounts();
  if (base_.has_stages != nullptr && !base_.has_stages(scene, model)) {
    DrawOptions options = given;
    if (stages_.options) stages_.options(options, scene);
    CoverageCounts drawn = DrawnWhole(scene, model, options);
    if (info_.coverage != CoverageKind::kFacingCounts) {
      for (std::size_t k = 0; k < drawn.size(); ++k)
        drawn.front[k] += std::exchange(drawn.back[k], 0U);
    }
    counts += drawn;
  } else {
    DrawTriangles(scene, model, given, counts, nullptr);
  }
  if (stages_.after) stages_.after(counts, before);
  if (info_.coverage != CoverageKind::kMask) return;
  for (std::uint32_t& count : counts.front) count = std::min(count, 1U);
}

}  // namespace

template <class Point>
std::unique_ptr<Subject> MakeVariant(const SubjectInfo& info, Stages<Point> stages,
                                     const Arithmetic<Point>& arithmetic) {
  return std::make_unique<Rasterizer<Point>>(info, std::move(stages), arithmetic);
}

template std::unique_ptr<Subject> MakeVariant(const SubjectInfo&, Stages<Point2>,
                                              const Arithmetic<Point2>&);
template std::unique_ptr<Subject> MakeVariant(const SubjectInfo&, Stages<GridPoint>,
                                              const Arithmetic<GridPoint>&);

}  // namespace rasterproof::variants
