#include "reference/homogeneous.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "reference/bands.h"
#include "reference/box.h"
#include "reference/homogeneous_edges.h"
#include "reference/method.h"
#include "reference/method_rows.h"
#include "reference/proved.h"
#include "reference/sample_grid.h"
#include "reference/whole_scene.h"

namespace rasterproof::reference {
namespace {

/// The extent of a triangle's projection, or the whole plane.
struct Extent {
  double left = -std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  double right = std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
};

/// The box of the projected vertices, for vertices whose w are of one sign.
///
/// A quotient is off by a relative 2^-53 or by half the smallest subnormal: 2^-50 and 1e-300 more
/// on each side keep the closed box of the exact projection inside.
Extent ExtentOfProjection(const Corners3& v) {
  constexpr double kSlack = 0x1p-50;
  constexpr double kTiny = 1e-300;
  const auto [left, right] = std::minmax({v[0].x / v[0].w, v[1].x / v[1].w, v[2].x / v[2].w});
  const auto [top, bottom] = std::minmax({v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w});
  return {left - std::fabs(left) * kSlack - kTiny, top - std::fabs(top) * kSlack - kTiny,
          right + std::fabs(right) * kSlack + kTiny, bottom + std::fabs(bottom) * kSlack + kTiny};
}

/// How a method reads a triangle in clip space: what is seen of it, which way it faces, and the box
/// of its samples. Any finite vertices.
template <class R>
concept Reading = requires(const Corners3& v) {
  requires HomogeneousEdge<typename R::EdgeType>;
  { R::MayBeSeen(v) } -> std::same_as<bool>;
  { R::Facing(v) } -> std::same_as<int>;
  { R::Bounds(v) } -> std::same_as<Extent>;
};

bool AllInFront(const Corners3& v) { return v[0].w > 0 && v[1].w > 0 && v[2].w > 0; }

/// As the eye sees it: the surface itself, what lies behind the eye left out.
template <HomogeneousEdge Edge>
struct ThroughTheEye {
  using EdgeType = Edge;
  /// A ray with t > 0 meets the triangle only in points of positive w: some vertex has one.
  static bool MayBeSeen(const Corners3& v) { return v[0].w > 0 || v[1].w > 0 || v[2].w > 0; }
  static int Facing(const Corners3& v) { return Edge::Facing(v); }
  static Extent Bounds(const Corners3& v) {
    return AllInFront(v) ? ExtentOfProjection(v) : Extent{};
  }
};

/// The scaled projected form: w_i w_j E taken for E, and the projected triangle's facing for the
/// triangle's. Right only while every w > 0; what lies behind the eye is drawn as its mirror image,
/// what passes through the eye's plane is drawn wrong.
template <HomogeneousEdge Edge>
struct ScaledProjection {
  using EdgeType = Edge;
  static bool MayBeSeen(const Corners3& v) { return v[0].w != 0 && v[1].w != 0 && v[2].w != 0; }
  static int Facing(const Corners3& v) {
    const int negative = (v[0].w < 0) + (v[1].w < 0) + (v[2].w < 0);
    return negative % 2 == 0 ? Edge::Facing(v) : -Edge::Facing(v);
  }
  static Extent Bounds(const Corners3& v) {
    const bool all_behind = v[0].w < 0 && v[1].w < 0 && v[2].w < 0;
    return AllInFront(v) || all_behind ? ExtentOfProjection(v) : Extent{};
  }
};

/// The pixels of `area` whose sample at `offset` can lie in the extent.
PixelRect SamplesWithin(const Extent& extent, Point2 offset, const PixelRect& area) {
  const int x0 = FirstSampleFrom(extent.left, offset.x, area.x0, area.x1);
  const int y0 = FirstSampleFrom(extent.top, offset.y, area.y0, area.y1);
  return {x0, y0, FirstSampleBeyond(extent.right, offset.x, x0, area.x1),
          FirstSampleBeyond(extent.bottom, offset.y, y0, area.y1)};
}

/// Adds one to every covered sample of the box, sample s of a pixel lying at `offset`; `counts` are
/// those of sample s of each pixel, `samples` words apart.
template <HomogeneousEdge Edge>
void CountSamples(const std::array<Edge, 3>& edges, const PixelRect& box, Point2 offset,
                  std::uint32_t* counts, int width, int samples = 1) {
  if (IsEmpty(box)) return;
  for (int j = box.y0; j < box.y1; ++j) {
    const double y = j + offset.y;
    if (!std::ranges::all_of(edges, [&](const Edge& e) {
          return e.MayTouch(box.x0 + offset.x, box.x1 - 1 + offset.x, y);
        })) {
      continue;
    }
    std::uint32_t* const row = counts + static_cast<std::ptrdiff_t>(j) * width * samples;
    for (int i = box.x0; i < box.x1; ++i) {
      const double x = i + offset.x;
      const bool inside =
          edges[0].Contains(x, y) && edges[1].Contains(x, y) && edges[2].Contains(x, y);
      row[static_cast<std::ptrdiff_t>(i) * samples] += inside ? 1 : 0;
    }
  }
}

template <HomogeneousEdge Edge>
std::array<Edge, 3> EdgesOf(const Corners3& v, int facing, const TieRule& rule, Point2 largest) {
  return {Edge(v[0], v[1], facing, rule, largest), Edge(v[1], v[2], facing, rule, largest),
          Edge(v[2], v[0], facing, rule, largest)};
}

constexpr Point2 kCentre{0.5, 0.5};

/// The stages of a row of the table: one sample at each pixel's centre, top-left.
template <Reading R>
Stages StagesOf() {
  Stages stages;
  stages.place = [](const Corners3& given) {
    const bool is_drawn = std::ranges::all_of(given, IsFinite) && R::MayBeSeen(given);
    return is_drawn ? std::optional<Corners3>(given) : std::nullopt;
  };
  stages.box = [](const Corners3& v, const PixelRect& target) {
    return SamplesWithin(R::Bounds(v), kCentre, target);
  };
  stages.facing = [](const Corners3& v, const RasterOptions& /*options*/) { return R::Facing(v); };
  stages.fill = [](const Corners3& v, const RasterOptions& /*options*/, const FillTarget& to) {
    const Point2 largest{static_cast<double>(to.box.x1), static_cast<double>(to.box.y1)};
    const auto edges = EdgesOf<typename R::EdgeType>(v, +1, kTopLeft, largest);
    CountSamples(edges, to.area, kCentre, to.counts, to.width);
  };
  return stages;
}

/// The projected form: divide first, then the direct window-space form, whatever the sign of w.
Stages ProjectedStages() {
  Stages stages = DirectMethod().stages;
  stages.place = [](const Corners3& given) -> std::optional<Corners3> {
    if (!std::ranges::all_of(given, IsFinite)) return std::nullopt;
    Corners3 window;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto w = static_cast<float>(given[k].w);
      window[k] = {static_cast<float>(given[k].x) / w, static_cast<float>(given[k].y) / w,
                   given[k].z, 1};
    }
    return PlaceAsGiven(window);
  };
  return stages;
}

Method Row(std::string_view name, std::string_view summary, Precision input, const Stages& stages) {
  Method row;
  row.name = name;
  row.summary = summary;
  row.stages = stages;
  row.info.name = name;
  row.info.summary = summary;
  row.info.input = input;
  row.info.profile.coordinate_limit = input == Precision::kFloat32
                                          ? double{std::numeric_limits<float>::max()}
                                          : std::numeric_limits<double>::max();
  row.info.takes_window = false;
  row.info.takes_clip = true;
  return row;
}

// What float32 holds goes to the kernel of clip space: the same signs, many rows at a time.
bool DrawWholeFromClip(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  if (!KernelsPay(scene) || !ClipKernelTakes(scene)) return false;
  DrawByClipKernel(scene, options, counts);
  return true;
}

std::array<Method, 5> MakeRows() {
  using Float = FloatHomogeneousEdge<float>;
  using Double = FloatHomogeneousEdge<double>;
  std::array<Method, 5> rows{
      Row("hom-projected-f32", "divide by w, then the direct form; wrong for w <= 0",
          Precision::kFloat32, ProjectedStages()),
      Row("hom-scaled-f32", "w_i w_j E taken for E, no division; wrong unless every w > 0",
          Precision::kFloat32, StagesOf<ScaledProjection<Float>>()),
      Row("hom-f32", "(V_j x V_i) . p with the determinant's sign, float32", Precision::kFloat32,
          StagesOf<ThroughTheEye<Float>>()),
      Row("hom-f64", "(V_j x V_i) . p with the determinant's sign, float64", Precision::kFloat64,
          StagesOf<ThroughTheEye<Double>>()),
      Row("hom-exact", "(V_j x V_i) . p: float64 filter, then exact integers; float32 by vectors",
          Precision::kFloat64, StagesOf<ThroughTheEye<ExactHomogeneousEdge>>())};
  // The projected form divides and then is the direct one; the filter of hom-exact rests on the
  // bound of the others.
  rows.front().info.proofs = EdgeProofs(EdgeArithmetic::kDirect);
  for (std::size_t k = 1; k < rows.size(); ++k) rows[k].info.proofs = HomogeneousProofs();
  rows.back().info.states_exact = true;
  for (const Proof& proof : ClipKernelProofs()) rows.back().info.proofs.push_back(proof);
  rows.back().whole = &DrawWholeFromClip;
  return rows;
}

}  // namespace

std::span<const Method> HomogeneousMethods() {
  static const std::array<Method, 5> rows = MakeRows();
  return rows;
}

void DrawHomogeneousExact(const Scene& scene, const Profile& profile, const DrawOptions& options,
                          CoverageCounts& counts) {
  using Eye = ThroughTheEye<ExactHomogeneousEdge>;
  const SampleGrid grid(profile, scene.height);
  RequireShape(scene, grid, counts);
  // With y up an offset can be as far as the height from its row; rows and columns reach it too.
  const Point2 largest{static_cast<double>(counts.width), 2.0 * counts.height};
  ForEachBand(DrawArea(scene, options), options, [&](const PixelRect& band) {
    for (const Triangle& t : scene.triangles) {
      Corners3 v = Corners(scene, t);
      for (Vertex& corner : v) corner.y = grid.Y(corner.y);
      if (!std::ranges::all_of(v, IsFinite) || !Eye::MayBeSeen(v)) continue;
      const int facing = Eye::Facing(v);
      if (facing == 0 || options.cull == (facing > 0 ? Cull::kFront : Cull::kBack)) continue;
      const auto edges = EdgesOf<Eye::EdgeType>(v, facing, profile.tie_rule, largest);
      std::uint32_t* const buffer = (facing > 0 ? counts.front : counts.back).data();
      for (std::size_t s = 0; s < grid.offsets.size(); ++s) {
        CountSamples(edges, SamplesWithin(Eye::Bounds(v), grid.offsets[s], band), grid.offsets[s],
                     buffer + s, counts.width, grid.samples());
      }
    }
  });
}

}  // namespace rasterproof::reference
