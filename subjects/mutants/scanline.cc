#include "subjects/mutants/scanline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::int64_t kUnit = 256;
constexpr std::int64_t kCentre = kUnit / 2;

std::int64_t FloorOf(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

std::int64_t FirstAtOrAfter(std::int64_t place) { return -FloorOf(kCentre - place, kUnit); }

class Scanline final : public Subject {
 public:
  Scanline(const std::string& name, const std::string& summary, ScanlineStages stages)
      : stages_(std::move(stages)) {
    info_.name = name;
    info_.summary = summary;
    info_.profile = FixedPointProfile();
    info_.profile.name = "rounded crossings";
    info_.profile.scanline_rounding = {8, stages_.stated};
    info_.takes_tiles = false;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    PixelRect clip{0, 0, scene.width, scene.height};
    if (const auto& s = options.scissor) {
      clip = {std::max(0, s->x0), std::max(0, s->y0), std::min(scene.width, s->x1),
              std::min(scene.height, s->y1)};
    }
    for (const Triangle& t : scene.triangles) {
      const auto v = Placed(Corners(scene, t));
      if (v) Fill(*v, options.cull, clip, counts);
    }
  }

 private:
  using Corners3 = std::array<GridPoint, 3>;

  std::optional<Corners3> Placed(const std::array<Vertex, 3>& corners) const {
    Corners3 v;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = SnapToGrid(corners[k].x, info_.profile.snap);
      const double y = SnapToGrid(corners[k].y, info_.profile.snap);
      const double reach = 2 * info_.profile.coordinate_limit;
      if (!(std::fabs(x) <= reach && std::fabs(y) <= reach)) return std::nullopt;
      v[k] = {static_cast<std::int64_t>(x * kUnit), static_cast<std::int64_t>(y * kUnit)};
    }
    return v;
  }

  std::int64_t CrossingOf(GridPoint a, GridPoint b, std::int64_t y) const {
    if (stages_.crossing) return stages_.crossing(a, b, y);
    // The rules apply to the crossing itself; |dx dy| is below 2^50.
    const std::int64_t n = (y - a.y) * (b.x - a.x);
    const std::int64_t d = b.y - a.y;
    if (stages_.stated == SnapRule::kFloor) return a.x + FloorOf(n, d);
    return a.x + FloorOf(2 * n + d, 2 * d);  // half up
  }

  void Fill(Corners3 v, Cull cull, const PixelRect& clip, CoverageCounts& counts) const {
    const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
    if (area == 0 || cull == (area > 0 ? Cull::kFront : Cull::kBack)) return;
    std::vector<std::uint32_t>& side = area > 0 ? counts.front : counts.back;
    std::ranges::sort(v, {}, &GridPoint::y);
    const auto first = std::max<std::int64_t>(clip.y0, FirstAtOrAfter(v[0].y));
    const auto last = std::min<std::int64_t>(clip.y1, FirstAtOrAfter(v[2].y));
    for (std::int64_t row = first; row < last; ++row) {
      const std::int64_t y = row * kUnit + kCentre;
      const std::int64_t p = CrossingOf(v[0], v[2], y);
      const std::int64_t q = y < v[1].y ? CrossingOf(v[0], v[1], y) : CrossingOf(v[1], v[2], y);
      const auto begin = std::max<std::int64_t>(clip.x0, FirstAtOrAfter(std::min(p, q)));
      const auto end = std::min<std::int64_t>(clip.x1, FirstAtOrAfter(std::max(p, q)));
      for (std::int64_t x = begin; x < end; ++x) {
        ++side[counts.Index(static_cast<int>(x), static_cast<int>(row), 0)];
      }
    }
  }

  SubjectInfo info_;
  ScanlineStages stages_;
};

}  // namespace

std::unique_ptr<Subject> MakeScanline(const std::string& name, const std::string& summary,
                                      ScanlineStages stages) {
  return std::make_unique<Scanline>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
