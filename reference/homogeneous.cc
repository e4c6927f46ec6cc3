#include "reference/homogeneous.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "reference/bands.h"
#include "reference/box.h"
#include "reference/homogeneous_edges.h"
#include "reference/method.h"
#include "reference/proved.h"
#include "reference/sample_grid.h"

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
Extent ExtentOfProjection(const std::array<Vertex, 3>& v) {
  constexpr double kSlack = 0x1p-50;
  constexpr double kTiny = 1e-300;
  const auto [left, right] = std::minmax({v[0].x / v[0].w, v[1].x / v[1].w, v[2].x / v[2].w});
  const auto [top, bottom] = std::minmax({v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w});
  return {left - std::fabs(left) * kSlack - kTiny, top - std::fabs(top) * kSlack - kTiny,
          right + std::fabs(right) * kSlack + kTiny, bottom + std::fabs(bottom) * kSlack + kTiny};
}

bool AllInFront(const std::array<Vertex, 3>& v) { return v[0].w > 0 && v[1].w > 0 && v[2].w > 0; }

/// How a method reads a triangle: its facing, and where its samples can lie.
template <class Edge>
struct ThroughTheEye {
  using EdgeType = Edge;
  /// A ray with t > 0 meets the triangle only in points of positive w: some vertex has one.
  static bool MayBeSeen(const std::array<Vertex, 3>& v) {
    return v[0].w > 0 || v[1].w > 0 || v[2].w > 0;
  }
  static int Facing(const std::array<Vertex, 3>& v) { return Edge::Facing(v); }
  static Extent Bounds(const std::array<Vertex, 3>& v) {
    return AllInFront(v) ? ExtentOfProjection(v) : Extent{};
  }
};

/// The scaled projected form: w_i w_j E taken for E, and the projected triangle's facing for the
/// triangle's. Right only while every w > 0; what lies behind the eye is drawn as its mirror image,
/// what passes through the eye's plane is drawn wrong.
template <class Edge>
struct ScaledProjection {
  using EdgeType = Edge;
  static bool MayBeSeen(const std::array<Vertex, 3>& v) {
    return v[0].w != 0 && v[1].w != 0 && v[2].w != 0;
  }
  static int Facing(const std::array<Vertex, 3>& v) {
    const int negative = (v[0].w < 0) + (v[1].w < 0) + (v[2].w < 0);
    return negative % 2 == 0 ? Edge::Facing(v) : -Edge::Facing(v);
  }
  static Extent Bounds(const std::array<Vertex, 3>& v) {
    const bool all_behind = v[0].w < 0 && v[1].w < 0 && v[2].w < 0;
    return AllInFront(v) || all_behind ? ExtentOfProjection(v) : Extent{};
  }
};

/// Adds one to every covered sample of the box.
template <class Edge>
void CountSamples(const std::array<Edge, 3>& edges, const Extent& extent, const SampleGrid& grid,
                  const PixelRect& area, std::uint32_t* counts, int width) {
  const int samples = grid.samples();
  for (int s = 0; s < samples; ++s) {
    const Point2 offset = grid.offsets[static_cast<std::size_t>(s)];
    const int x0 = FirstSampleFrom(extent.left, offset.x, area.x0, area.x1);
    const int x1 = FirstSampleBeyond(extent.right, offset.x, x0, area.x1);
    const int y0 = FirstSampleFrom(extent.top, offset.y, area.y0, area.y1);
    const int y1 = FirstSampleBeyond(extent.bottom, offset.y, y0, area.y1);
    if (x0 >= x1) continue;
    for (int j = y0; j < y1; ++j) {
      const double y = j + offset.y;
      if (!std::ranges::all_of(edges, [&](const Edge& e) {
            return e.MayTouch(x0 + offset.x, x1 - 1 + offset.x, y);
          })) {
        continue;
      }
      std::uint32_t* const row = counts + static_cast<std::ptrdiff_t>(j) * width * samples + s;
      for (int i = x0; i < x1; ++i) {
        const double x = i + offset.x;
        const bool inside =
            edges[0].Contains(x, y) && edges[1].Contains(x, y) && edges[2].Contains(x, y);
        row[static_cast<std::ptrdiff_t>(i) * samples] += inside ? 1 : 0;
      }
    }
  }
}

template <class Reading>
void DrawHomogeneousTriangle(const std::array<Vertex, 3>& v, const FillRule& rule, Cull cull,
                             const SampleGrid& grid, const PixelRect& area,
                             CoverageCounts& counts) {
  using Edge = typename Reading::EdgeType;
  if (!std::ranges::all_of(v, IsFinite) || !Reading::MayBeSeen(v)) return;
  const int facing = Reading::Facing(v);
  if (facing == 0 || cull == (facing > 0 ? Cull::kFront : Cull::kBack)) return;
  // With y up an offset can be as far as the height from its row; rows and columns reach it too.
  const Point2 largest{static_cast<double>(counts.width), 2.0 * counts.height};
  const std::array<Edge, 3> edges{Edge(v[0], v[1], facing, rule, largest),
                                  Edge(v[1], v[2], facing, rule, largest),
                                  Edge(v[2], v[0], facing, rule, largest)};
  CountSamples(edges, Reading::Bounds(v), grid, area,
               (facing > 0 ? counts.front : counts.back).data(), counts.width);
}

template <class Reading>
void DrawHomogeneous(const Scene& scene, const Profile& profile, const DrawOptions& options,
                     CoverageCounts& counts) {
  const SampleGrid grid(profile, scene.height);
  RequireShape(scene, grid, counts);
  ForEachBand(DrawArea(scene, options), options, [&](const PixelRect& band) {
    for (const Triangle& t : scene.triangles) {
      std::array<Vertex, 3> v = Corners(scene, t);
      for (Vertex& corner : v) corner.y = grid.Y(corner.y);
      DrawHomogeneousTriangle<Reading>(v, profile.fill_rule, options.cull, grid, band, counts);
    }
  });
}

/// A row's `draw`: the canonical model of the preset "real".
template <class Reading>
void DrawRow(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  DrawHomogeneous<Reading>(scene, Profile{}, options, counts);
}

/// The projected form: divide first, then the direct window-space form, whatever the sign of w.
void DrawProjected(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  Scene window = scene;
  window.clip_space = false;
  for (Vertex& v : window.vertices) {
    // An infinite w must not bring an infinite x back to a finite quotient.
    const float w = IsFinite(v) ? static_cast<float>(v.w) : std::numeric_limits<float>::quiet_NaN();
    v = {static_cast<float>(v.x) / w, static_cast<float>(v.y) / w, v.z, 1};
  }
  FindMethod("f32-direct")->draw(window, options, counts);
}

Method Row(std::string_view name, std::string_view summary, Precision input,
           void (*draw)(const Scene&, const RasterOptions&, CoverageCounts&)) {
  Method row;
  row.name = name;
  row.summary = summary;
  row.draw = draw;
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

std::array<Method, 5> MakeRows() {
  using Float = FloatHomogeneousEdge<float>;
  using Double = FloatHomogeneousEdge<double>;
  std::array<Method, 5> rows{
      Row("hom-projected-f32", "divide by w, then the direct form; wrong for w <= 0",
          Precision::kFloat32, DrawProjected),
      Row("hom-scaled-f32", "w_i w_j E taken for E, no division; wrong unless every w > 0",
          Precision::kFloat32, DrawRow<ScaledProjection<Float>>),
      Row("hom-f32", "(V_j x V_i) . p with the determinant's sign, float32", Precision::kFloat32,
          DrawRow<ThroughTheEye<Float>>),
      Row("hom-f64", "(V_j x V_i) . p with the determinant's sign, float64", Precision::kFloat64,
          DrawRow<ThroughTheEye<Double>>),
      Row("hom-exact", "(V_j x V_i) . p: float64 filter, then exact integers", Precision::kFloat64,
          DrawRow<ThroughTheEye<ExactHomogeneousEdge>>)};
  // The projected form divides and then is the direct one; the filter of hom-exact rests on the
  // bound of the others.
  rows.front().info.proofs = EdgeProofs(EdgeArithmetic::kDirect);
  for (std::size_t k = 1; k < rows.size(); ++k) rows[k].info.proofs = HomogeneousProofs();
  rows.back().info.claims_exact = true;
  return rows;
}

}  // namespace

std::span<const Method> HomogeneousMethods() {
  static const std::array<Method, 5> rows = MakeRows();
  return rows;
}

void DrawHomogeneousExact(const Scene& scene, const Profile& profile, const DrawOptions& options,
                          CoverageCounts& counts) {
  DrawHomogeneous<ThroughTheEye<ExactHomogeneousEdge>>(scene, profile, options, counts);
}

}  // namespace rasterproof::reference
