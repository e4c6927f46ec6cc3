// Embedded meshes: pairs, fans, strips and grids. Every sample inside belongs to one triangle.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"
#include "props/domains/planar_mesh.h"

namespace rasterproof::props {
namespace {

// The diagonal of a quad: exactly through a sample, a step or some steps off it, or as near as the
// lattice allows.
Segment DrawDiagonal(CaseBuilder& builder) {
  const Point2 p = builder.Sample();
  const Segment through = SegmentThrough(builder, p);
  const std::int64_t kind = builder.bits().Int(0, 3);
  if (kind == 0) return through;
  if (kind == 1) return {through.a, Hardest(builder, through.b, through.a, p)};
  return {Nudged(builder, through.a, kind == 2 ? 1 : 16), through.b};
}

// The diagonal of a square whose corners are the same small power of two off the samples, as in a
// 6-pixel gap found along the shared diagonal of a quad at 0.49993896484375 = 1/2 - 2^-14 (DRTK
// pull request 9). It passes exactly through the samples between its ends.
Segment DrawOffsetDiagonal(CaseBuilder& builder) {
  const Point2 p = builder.Sample();
  const double sign = builder.Sign();
  const double off = -sign * std::ldexp(1.0, -static_cast<int>(builder.bits().Int(6, 18)));
  const double side = sign * static_cast<double>(builder.bits().Int(1, 32));
  return {{p.x + off, p.y + off}, {p.x + off + side, p.y + off + side}};
}

// A grid, one node of which is a sample of the target.
struct GridShape {
  int columns = 1;
  int rows = 1;
  double spacing = 1;
  Point2 sample;
  int sample_column = 0;
  int sample_row = 0;
};

GridShape DrawGridShape(CaseBuilder& builder, int columns, int rows) {
  GridShape shape{.columns = columns, .rows = rows, .sample = builder.Sample()};
  shape.spacing = static_cast<double>(builder.bits().Int(2, 16)) / 2;
  shape.sample_column = static_cast<int>(builder.bits().Int(0, columns));
  shape.sample_row = static_cast<int>(builder.bits().Int(0, rows));
  return shape;
}

// Two nodes that are `spacing` apart may come 4 * jitter nearer in the determinant: below
// spacing / 4 no triangle folds. Rounding to a coarse lattice can still fold one: see the caller.
PlanarMesh MakeGrid(CaseBuilder& builder, const GridShape& shape, double jitter) {
  PlanarMesh mesh;
  for (int j = 0; j <= shape.rows; ++j) {
    for (int i = 0; i <= shape.columns; ++i) {
      const bool pinned = i == shape.sample_column && j == shape.sample_row;
      const double moved = pinned || builder.bits().Chance(64) ? 0 : jitter;
      const double x = shape.sample.x + (i - shape.sample_column) * shape.spacing;
      const double y = shape.sample.y + (j - shape.sample_row) * shape.spacing;
      mesh.AddVertex(OnLattice(
          builder, {x + builder.Uniform(-moved, moved), y + builder.Uniform(-moved, moved)}));
    }
  }
  mesh.AddCells(builder.bits(), shape.columns, shape.rows);
  return mesh;
}

Case DoneGrid(CaseBuilder& builder, const GridShape& shape) {
  const double jitter = builder.bits().Chance(128) ? 0 : 0.24 * shape.spacing;
  PlanarMesh mesh = MakeGrid(builder, shape, jitter);
  if (!mesh.IsFacingOneWay()) mesh = MakeGrid(builder, shape, 0);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

// The place at distance t of [0, 8 radius) along the perimeter of a square of half side `radius`.
Point2 OnSquare(Point2 centre, double radius, double t) {
  const double side = 2 * radius;
  const double along = std::fmod(t, side) - radius;
  if (t < side) return {centre.x + along, centre.y - radius};
  if (t < 2 * side) return {centre.x + radius, centre.y + along};
  if (t < 3 * side) return {centre.x - along, centre.y + radius};
  return {centre.x - radius, centre.y - along};
}

// The rim of a fan in order around its hub: the square's corners and places between them, so that
// no wedge reaches half a turn.
std::vector<double> DrawRim(CaseBuilder& builder, double radius, double grid_step) {
  const std::int64_t places = static_cast<std::int64_t>(8 * radius / grid_step);
  std::vector<double> rim;
  for (int corner = 0; corner < 4; ++corner) rim.push_back(corner * 2 * radius);
  const std::int64_t more =
      builder.bits().Chance(32) ? builder.bits().Int(24, 124) : builder.bits().Int(0, 12);
  for (std::int64_t i = 0; i < more; ++i) {
    rim.push_back(grid_step * static_cast<double>(builder.bits().Int(0, places - 1)));
  }
  std::ranges::sort(rim);
  rim.erase(std::ranges::unique(rim).begin(), rim.end());
  return rim;
}

// Log-uniform up to 2^15 pixels, whatever the range is beyond that; or up to an eighth of it. The
// largest mesh of such a size around a target still lies in the range.
double DrawSize(CaseBuilder& builder) {
  constexpr int kOrdinary = 14;
  const int end = std::max(1, std::ilogb(builder.Range()) - 4);
  const int most = builder.bits().Chance(48) ? end : std::min(kOrdinary, end);
  return std::fabs(builder.LogUniform(1, most));
}

// A sample, or a place as far from it as a mesh of that size still reaches.
Point2 DrawCentre(CaseBuilder& builder, double size) {
  const Point2 p = builder.Sample();
  if (builder.bits().Chance(128)) return p;
  const double x = builder.Uniform(-size, size);
  return {p.x + x, p.y + builder.Uniform(-size, size)};
}

PlanarMesh DrawSizedGrid(CaseBuilder& builder, double size) {
  GridShape shape{.columns = static_cast<int>(builder.bits().Int(1, 3)),
                  .rows = static_cast<int>(builder.bits().Int(1, 3)),
                  .spacing = size,
                  .sample = DrawCentre(builder, size)};
  shape.sample_column = static_cast<int>(builder.bits().Int(0, shape.columns));
  shape.sample_row = static_cast<int>(builder.bits().Int(0, shape.rows));
  return MakeGrid(builder, shape, builder.bits().Chance(128) ? 0 : 0.24 * size);
}

PlanarMesh DrawSizedFan(CaseBuilder& builder, double size) {
  const Point2 centre = OnLattice(builder, DrawCentre(builder, size));
  PlanarMesh mesh;
  mesh.AddVertex(centre);
  std::vector<double> rim = DrawRim(builder, size, std::ldexp(1.0, std::ilogb(size) - 8));
  for (const double t : rim) mesh.AddVertex(OnLattice(builder, OnSquare(centre, size, t)));
  const auto n = static_cast<std::int32_t>(rim.size());
  for (std::int32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  return mesh;
}

// Two on an edge past a sample, each of a height of its own: where a rasterizer goes another way
// from some size on, they go different ways.
PlanarMesh DrawUnequalNeighbours(CaseBuilder& builder, double size) {
  const Point2 p = builder.bits().Chance(128) ? builder.Sample() : builder.Place();
  const double turn = builder.Uniform(-1, 1);
  const Point2 along{CosPi(turn) * size, SinPi(turn) * size};
  const double before = builder.Uniform(0.25, 1);
  const double behind = builder.Uniform(0.25, 1);
  const Point2 a = OnLattice(builder, {p.x - before * along.x, p.y - before * along.y});
  const Point2 b = OnLattice(builder, {p.x + behind * along.x, p.y + behind * along.y});
  const auto beside = [&](double sign) {
    const double height = sign * DrawSize(builder) / size;
    const double t = builder.Uniform(0, 1);
    return OnLattice(builder, {a.x + t * (b.x - a.x) - height * along.y,
                               a.y + t * (b.y - a.y) + height * along.x});
  };
  PlanarMesh mesh;
  mesh.AddVertex(a);
  mesh.AddVertex(b);
  mesh.AddVertex(beside(+1));
  mesh.AddVertex(beside(-1));
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

}  // namespace

static Case SharedEdge(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Segment drawn = bits.Chance(64) ? DrawOffsetDiagonal(builder) : DrawDiagonal(builder);
  const Point2 a = OnLattice(builder, drawn.a);
  const Point2 b = OnLattice(builder, drawn.b);
  const Point2 d{b.x - a.x, b.y - a.y};
  // Two more corners, at least two pixels to either side of the diagonal.
  const auto beside = [&](double sign) {
    const double length = std::max(1.0, Hypot(d.x, d.y));
    const double off = sign * builder.Uniform(2, 24) / length;
    const double along = builder.Uniform(-0.25, 1.25);
    return OnLattice(builder, {a.x + along * d.x - off * d.y, a.y + along * d.y + off * d.x});
  };
  const bool square = bits.Chance(64) && d.x != 0 && d.y != 0;
  const std::int32_t ia = builder.Add(a);
  const std::int32_t ib = builder.Add(b);
  builder.AddTriangle(ia, ib, builder.Add(square ? Point2{a.x, b.y} : beside(+1)));
  builder.AddTriangle(ib, ia, builder.Add(square ? Point2{b.x, a.y} : beside(-1)));
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kSharedEdgeDomain{
    .number = 29,
    .bits = 0xba92d18cbd162a38,
    .name = "shared-edge",
    .summary = "two triangles whose common edge passes samples on or near it",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = SharedEdge};

static Case Fans(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Point2 p = builder.Sample();
  const double radius = static_cast<double>(bits.Int(4, 48)) / 2;
  const int grid_bits = std::max(0, std::min(8, builder.lattice().GridBits(256)));
  const Point2 centre = OnLattice(builder, p);
  const Point2 hub = bits.Chance(96) ? centre : OnLattice(builder, Nudged(builder, centre, 1));
  PlanarMesh mesh;
  const std::int32_t h = mesh.AddVertex(hub);
  const std::vector<double> rim = DrawRim(builder, radius, std::ldexp(1.0, -grid_bits));
  for (const double t : rim) mesh.AddVertex(OnLattice(builder, OnSquare(centre, radius, t)));
  const auto n = static_cast<std::int32_t>(rim.size());
  const std::int32_t left_out = bits.Chance(64) ? static_cast<std::int32_t>(bits.Int(1, n - 1)) : 0;
  for (std::int32_t i = 0; i < n - left_out; ++i) {
    mesh.triangles.push_back({h, h + 1 + i, h + 1 + (i + 1) % n});
  }
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kFansDomain{
    .number = 30,
    .bits = 0x84546d08f18b4ac2,
    .name = "fans",
    .summary = "a hub on a sample or a step off it, up to 128 triangles around",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = Fans};

static Case Strips(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const int cells = static_cast<int>(bits.Int(2, 16));
  const bool along_y = bits.Chance(128);
  return DoneGrid(builder, DrawGridShape(builder, along_y ? 1 : cells, along_y ? cells : 1));
}

extern constinit const Domain kStripsDomain{.number = 31,
                                            .bits = 0x2b2adddecf528e9,
                                            .name = "strips",
                                            .summary = "one row of quads, regular or jittered",
                                            .theme = DomainTheme::kMeshes,
                                            .near_edge = true,
                                            .mesh = true,
                                            .draw = Strips};

static Case Grids(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const int columns = static_cast<int>(bits.Int(1, 6));
  return DoneGrid(builder, DrawGridShape(builder, columns, static_cast<int>(bits.Int(1, 6))));
}

extern constinit const Domain kGridsDomain{
    .number = 32,
    .bits = 0xd418d8ca2e6e7f1e,
    .name = "grids",
    .summary = "rows of quads, regular or jittered, diagonals either way",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = Grids};

static Case EverySize(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const double size = DrawSize(builder);
  PlanarMesh mesh;
  switch (bits.Int(0, 3)) {
    case 0:
      mesh = DrawSizedGrid(builder, size);
      break;
    case 1:
      mesh = DrawSizedFan(builder, size);
      break;
    default:
      mesh = DrawUnequalNeighbours(builder, size);
      break;
  }
  // An end of the range or a coarse lattice has folded it.
  if (!mesh.IsFacingOneWay()) mesh.triangles.resize(1);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kEverySizeDomain{
    .number = 100,
    .bits = 0x5d18162ac0d222f8,
    .listed = 701,
    .name = "every-size",
    .summary = "meshes of every size up to 2^15, whatever the range; unequal neighbours",
    .theme = DomainTheme::kOrdinary,
    .mesh = true,
    .draw = EverySize};

static Case PerspectiveMeshes(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const int columns = static_cast<int>(bits.Int(1, 4));
  const GridShape shape = DrawGridShape(builder, columns, static_cast<int>(bits.Int(1, 4)));
  PlanarMesh mesh = MakeGrid(builder, shape, bits.Chance(128) ? 0 : 0.2 * shape.spacing);
  if (!mesh.IsFacingOneWay()) mesh = MakeGrid(builder, shape, 0);
  for (const Point2 p : mesh.vertices) {
    // Powers of two keep the place exact; others move it by an ulp or two.
    const double w = bits.Chance(96)
                         ? std::ldexp(1.0, static_cast<int>(bits.Int(-4, 4)))
                         : builder.lattice().RoundToFloat(std::fabs(builder.LogUniform(-4, 3)));
    builder.AddRaw({p.x * w, p.y * w, 0, w});
  }
  for (const Triangle& t : mesh.triangles) builder.AddTriangle(t[0], t[1], t[2]);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kPerspectiveMeshesDomain{
    .number = 46,
    .bits = 0x564e3a674814dac5,
    .listed = 661,
    .name = "perspective-meshes",
    .summary = "grids in clip space, in front of the eye, each vertex with a w of its own",
    .theme = DomainTheme::kClip,
    .clip = true,
    .mesh = true,
    .draw = PerspectiveMeshes};

static Case SharedSnapTies(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Snap& snap = builder.profile().snap;
  const double step = std::ldexp(1.0, -(snap.IsNone() ? 8 : snap.bits));
  // Half of the coordinates lie half way between two grid points or within a sixteenth of that.
  const auto between = [&] {
    const std::int64_t kind = bits.Int(0, 7);
    if (kind < 4) return 0.0;
    return step * (0.5 + static_cast<double>(kind - 5) / 16);
  };
  const Point2 p = builder.Sample();
  auto dx = static_cast<double>(bits.Int(-3, 3));
  const auto dy = static_cast<double>(bits.Int(-3, 3));
  if (dx == 0 && dy == 0) dx = 1;
  // Ends far enough apart that not even whole pixels fold a triangle.
  const auto place = [&](double along, double across) {
    const double off_x = between();
    const double off_y = between();
    return builder.AddRaw(
        {p.x + along * dx - across * dy + off_x, p.y + along * dy + across * dx + off_y});
  };
  const auto before = static_cast<double>(bits.Int(2, 6));
  const std::int32_t a = place(-before, 0);
  const std::int32_t b = place(static_cast<double>(bits.Int(2, 6)), 0);
  const std::int32_t left = place(0, 4);
  const std::int32_t right = place(0, -4);
  builder.AddTriangle(a, b, left);
  builder.AddTriangle(b, a, right);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kSharedSnapTiesDomain{
    .number = 45,
    .bits = 0x7b85fab785e1cef0,
    .name = "shared-snap-ties",
    .summary = "two triangles whose common edge ends between subpixels and passes a sample",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .mesh = true,
    .draw = SharedSnapTies};

}  // namespace rasterproof::props
