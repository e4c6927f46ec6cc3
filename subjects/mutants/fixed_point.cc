#include "subjects/mutants/fixed_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

int SignOf(std::int64_t n) { return (n > 0) - (n < 0); }

// The sample moves by (+-e, +-e^2), or by (+-e^2, +-e): whether it then is on the positive side.
bool Owns(const GridEdge& edge, const TieRule& rule) {
  if (!rule.IsConsistent()) return rule.inclusive;
  const int along_x = rule.sign_x * SignOf(edge.b.y - edge.a.y);
  const int along_y = rule.sign_y * SignOf(edge.a.x - edge.b.x);
  const int first = rule.y_first ? along_y : along_x;
  return (first != 0 ? first : rule.y_first ? along_x : along_y) > 0;
}

class FixedPoint final : public Subject {
 public:
  FixedPoint(const std::string& name, const std::string& summary, FixedStages stages)
      : stages_(std::move(stages)) {
    info_.name = name;
    info_.summary = summary;
    info_.profile = stages_.profile;
    info_.takes_threads = true;
    info_.takes_batches = static_cast<bool>(stages_.batch);
    bits_ = std::max(stages_.bits, stages_.profile.snap.bits);
    if (info_.profile.fixed) bits_ = std::max(bits_, info_.profile.fixed->fraction_bits);
    for (const TargetModel& model : info_.profile.by_target_size)
      bits_ = std::max(bits_, model.snap.bits);
  }

  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    std::vector<DrawOutcome> outcomes = Subject::DrawMany(jobs);
    if (stages_.batch && outcomes.size() > 1) stages_.batch(outcomes);
    return outcomes;
  }
  Subject* Twin() override {
    if (!twin_) twin_ = std::make_unique<FixedPoint>(info_.name, info_.summary, stages_);
    return twin_.get();
  }

 private:
  static constexpr std::size_t kMostKept = 64;

  void DrawAnew(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

  // What one draw sees of its target.
  struct Target {
    const Scene& scene;
    DrawOptions options;
    std::vector<GridPoint> offsets;  // of sample s from pixel (x, row)
    PixelRect clip;
    CoverageCounts& counts;
  };

  std::int64_t Units(double pixels) const {
    return static_cast<std::int64_t>(std::ldexp(pixels, bits_));
  }
  // The first pixel whose sample at `offset` lies at or beyond the grid coordinate.
  int FirstPixel(std::int64_t at, std::int64_t offset) const {
    const std::int64_t step = std::int64_t{1} << bits_;
    return static_cast<int>((at - offset + step - 1) >> bits_);
  }

  // The model that the profile has on the scene's target.
  Profile ModelOf(const Scene& scene) const;
  double Wrapped(double x) const;
  bool IsTooLarge(const std::array<GridPoint, 3>& v) const;
  Target Prepare(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) const;
  std::optional<GridPoint> Snapped(const Vertex& v) const;
  std::optional<GridTriangle> SetUp(const Scene& scene, std::size_t number) const;
  PixelRect Box(const GridTriangle& triangle, const Target& target) const;
  void DrawTriangle(const GridTriangle& triangle, Target& target) const;
  TileTest Test(const GridTriangle& triangle, const PixelRect& tile, const Target& target) const;
  bool Covers(const GridTriangle& triangle, const Sample& sample) const;
  void DrawTile(const GridTriangle& triangle, const PixelRect& tile, Target& target) const;
  GridPoint At(int x, int row, const GridPoint& offset) const {
    return {(std::int64_t{x} << bits_) + offset.x, (std::int64_t{row} << bits_) + offset.y};
  }

  FixedStages stages_;
  SubjectInfo info_;
  Profile model_;  ///< on the target of this draw
  std::map<std::vector<std::int64_t>, CoverageCounts> kept_;
  int bits_ = 8;
  std::unique_ptr<FixedPoint> twin_;
};

Profile FixedPoint::ModelOf(const Scene& scene) const {
  if (stages_.target_model) return stages_.target_model(info_.profile, scene);
  return ModelOn(info_.profile, scene.width, scene.height);
}

// The low n + m bits, the highest of them read as the sign.
double FixedPoint::Wrapped(double x) const {
  const FixedInput& fixed = *info_.profile.fixed;
  const auto raw = static_cast<std::int64_t>(std::ldexp(x, fixed.fraction_bits));
  const int bits = fixed.integer_bits + fixed.fraction_bits;
  std::int64_t used = raw;
  if (stages_.wrap) {
    used = stages_.wrap(raw);
  } else if (fixed.wraps) {
    used = raw & ((std::int64_t{1} << bits) - 1);
    if (fixed.is_signed && (used >> (bits - 1)) != 0) used -= std::int64_t{1} << bits;
  }
  return std::ldexp(static_cast<double>(used), -fixed.fraction_bits);
}

bool FixedPoint::IsTooLarge(const std::array<GridPoint, 3>& v) const {
  const auto [left, right] = std::ranges::minmax(v, {}, &GridPoint::x);
  const auto [top, bottom] = std::ranges::minmax(v, {}, &GridPoint::y);
  const std::int64_t width = right.x - left.x;
  const std::int64_t height = bottom.y - top.y;
  if (stages_.too_large) return stages_.too_large(width, height);
  const MaxPrimitiveExtent& most = *info_.profile.max_primitive_extent;
  return width > Units(most.width) || height > Units(most.height);
}

FixedPoint::Target FixedPoint::Prepare(const Scene& scene, const DrawOptions& options,
                                       CoverageCounts& counts) const {
  Target target{scene, options, {}, {0, 0, scene.width, scene.height}, counts};
  if (stages_.options) stages_.options(target.options, scene);
  if (const std::optional<PixelRect>& s = target.options.scissor) {
    target.clip = {std::max(0, s->x0), std::max(0, s->y0), std::min(scene.width, s->x1),
                   std::min(scene.height, s->y1)};
  }
  const bool y_up = info_.profile.y_axis == YAxis::kUp;
  for (const Point2& l : model_.pattern.locations) {
    target.offsets.push_back({Units(l.x), Units(y_up ? -(scene.height - 1) - l.y : l.y)});
  }
  return target;
}

std::optional<GridPoint> FixedPoint::Snapped(const Vertex& v) const {
  const auto snap = [&](double x, bool along_y) {
    if (info_.profile.fixed && std::isfinite(x)) x = Wrapped(x);
    return stages_.snap ? stages_.snap(x, along_y) : SnapToGrid(x, model_.snap);
  };
  const double reach = 2 * info_.profile.coordinate_limit;
  const double x = snap(v.x, false);
  const double y = snap(v.y, true);
  if (!(std::fabs(x) <= reach && std::fabs(y) <= reach)) return std::nullopt;  // NaN is not
  GridPoint p{Units(x), Units(info_.profile.y_axis == YAxis::kUp ? -y : y)};
  if (stages_.place) stages_.place(p);
  return p;
}

std::optional<GridTriangle> FixedPoint::SetUp(const Scene& scene, std::size_t number) const {
  GridTriangle triangle;
  triangle.number = number;
  triangle.indices = scene.triangles[number];
  std::array<Vertex, 3> corners = Corners(scene, triangle.indices);
  if (stages_.vertices) stages_.vertices(corners);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!IsFinite(corners[i])) return std::nullopt;
    const std::optional<GridPoint> p = Snapped(corners[i]);
    if (!p) return std::nullopt;
    triangle.v[i] = *p;
  }
  const std::array<GridPoint, 3>& v = triangle.v;
  if (info_.profile.max_primitive_extent && IsTooLarge(v)) return std::nullopt;
  const std::int64_t area = stages_.area ? stages_.area(v) : GridEdge{v[0], v[1]}.At(v[2]);
  if (area == 0 && !stages_.draws_flat) return std::nullopt;
  triangle.front = area > 0;
  if (!triangle.front) {
    std::swap(triangle.v[1], triangle.v[2]);
    std::swap(triangle.indices[1], triangle.indices[2]);
  }
  if (stages_.facing) stages_.facing(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    GridEdge edge{triangle.v[(i + 1) % 3], triangle.v[(i + 2) % 3]};
    edge.owns = area == 0 || Owns(edge, model_.tie_rule);
    triangle.edges[i] = edge;
  }
  if (stages_.edges) stages_.edges(triangle);
  return triangle;
}

PixelRect FixedPoint::Box(const GridTriangle& triangle, const Target& target) const {
  const auto [left, right] = std::ranges::minmax(triangle.v, {}, &GridPoint::x);
  const auto [top, bottom] = std::ranges::minmax(triangle.v, {}, &GridPoint::y);
  const auto [least_x, most_x] = std::ranges::minmax(target.offsets, {}, &GridPoint::x);
  const auto [least_y, most_y] = std::ranges::minmax(target.offsets, {}, &GridPoint::y);
  // A sample at the far end of the box can be inside under some rules: one pixel beyond ends it.
  PixelRect box{FirstPixel(left.x, most_x.x), FirstPixel(top.y, most_y.y),
                FirstPixel(right.x + 1, least_x.x), FirstPixel(bottom.y + 1, least_y.y)};
  if (stages_.sample) box = {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1};
  if (stages_.box) stages_.box(box, triangle, target.scene);
  return {std::max(box.x0, target.clip.x0), std::max(box.y0, target.clip.y0),
          std::min(box.x1, target.clip.x1), std::min(box.y1, target.clip.y1)};
}

TileTest FixedPoint::Test(const GridTriangle& triangle, const PixelRect& tile,
                          const Target& target) const {
  // Samples that lie elsewhere, and other values, do so for tiles too: each sample is tested.
  if (stages_.sample || stages_.value) return TileTest::kMixed;
  const auto [least_x, most_x] = std::ranges::minmax(target.offsets, {}, &GridPoint::x);
  const auto [least_y, most_y] = std::ranges::minmax(target.offsets, {}, &GridPoint::y);
  const GridPoint top_left = At(tile.x0, tile.y0, {least_x.x, least_y.y});
  const GridPoint bottom_right = At(tile.x1 - 1, tile.y1 - 1, {most_x.x, most_y.y});
  std::array<TileCorners, 3> values{};
  TileTest test = TileTest::kInside;
  for (std::size_t i = 0; i < 3; ++i) {
    const GridEdge& edge = triangle.edges[i];
    values[i] = {edge.At(top_left), edge.At({bottom_right.x, top_left.y}),
                 edge.At({top_left.x, bottom_right.y}), edge.At(bottom_right)};
    const auto [least, most] = std::ranges::minmax(values[i]);
    if (most < 0) {
      test = TileTest::kOutside;
    } else if (least <= 0 && test == TileTest::kInside) {
      test = TileTest::kMixed;
    }
  }
  return stages_.tile_test ? stages_.tile_test(values, test) : test;
}

bool FixedPoint::Covers(const GridTriangle& triangle, const Sample& sample) const {
  for (const GridEdge& edge : triangle.edges) {
    const std::int64_t e = stages_.value ? stages_.value(edge, sample) : edge.At(sample.at);
    if (e < 0) return false;
    if (e > 0) continue;
    if (!(stages_.owns ? stages_.owns(edge, triangle, sample) : edge.owns)) return false;
  }
  return true;
}

void FixedPoint::DrawTile(const GridTriangle& triangle, const PixelRect& tile,
                          Target& target) const {
  const TileTest test = Test(triangle, tile, target);
  if (test == TileTest::kOutside) return;
  CoverageCounts& counts = target.counts;
  std::vector<std::uint32_t>& side = triangle.front ? counts.front : counts.back;
  for (int row = tile.y0; row < tile.y1; ++row) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const GridPoint at = At(x, row, target.offsets[static_cast<std::size_t>(s)]);
        Sample sample{x, row, s, at, counts.width, counts.height};
        if (stages_.sample) sample.at = stages_.sample(sample);
        if (test != TileTest::kInside && !Covers(triangle, sample)) continue;
        const std::uint32_t times = stages_.times ? stages_.times(sample, triangle) : 1;
        const std::size_t k =
            stages_.index ? stages_.index(counts, sample) : counts.Index(x, row, s);
        if (k < side.size()) side[k] += times;
      }
    }
  }
}

void FixedPoint::DrawTriangle(const GridTriangle& triangle, Target& target) const {
  const PixelRect box = Box(triangle, target);
  const int side = target.options.tile > 0 ? target.options.tile : stages_.tile;
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

void FixedPoint::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
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

void FixedPoint::DrawAnew(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  model_ = ModelOf(scene);
  const CoverageCounts before = stages_.after ? counts : CoverageCounts();
  Target target = Prepare(scene, options, counts);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    if (stages_.drops && stages_.drops(scene, t)) continue;
    const std::optional<GridTriangle> triangle = SetUp(scene, t);
    if (!triangle) continue;
    if (target.options.cull == (triangle->front ? Cull::kFront : Cull::kBack)) continue;
    DrawTriangle(*triangle, target);
  }
  if (stages_.after) stages_.after(counts, before);
}

}  // namespace

Profile FixedPointProfile() {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.name = "fixed point";
  profile.infinite_vertex = InfiniteVertex::kNothing;
  return profile;
}

std::unique_ptr<Subject> MakeFixedPoint(const std::string& name, const std::string& summary,
                                        FixedStages stages) {
  return std::make_unique<FixedPoint>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
