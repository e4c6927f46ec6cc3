// Grids turned by some angle, and needles along the diagonals of samples: edges that pass many
// samples exactly or as nearly as the lattice allows.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

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

// Legs of Pythagorean triangles: a square turned by their angle has its corners on the lattice.
// Multiples of the first two still fit most targets, and pass a sample each time.
constexpr std::array<Point2, 6> kLegs{{{4, 3}, {3, 4}, {12, 5}, {15, 8}, {24, 7}, {21, 20}}};

// One side of a cell: legs or half of them, exactly; of another length along the same line; or a
// little off the rows.
Point2 DrawCellSide(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const std::int64_t kind = bits.Int(0, 7);
  if (kind < 4) {
    const Point2 legs = kLegs[static_cast<std::size_t>(bits.Int(0, 1))];
    const auto times = static_cast<double>(bits.Int(1, 5));
    return {legs.x * times, builder.Sign() * legs.y * times};
  }
  const Point2 legs = bits.OneOf(std::span<const Point2>(kLegs));
  if (kind == 4) return {legs.x / 2, builder.Sign() * legs.y / 2};
  const double length = static_cast<double>(bits.Int(4, 32)) / 2;
  if (kind != 5) return {length, length * builder.LogUniform(-12, -3)};
  const double times = length / Hypot(legs.x, legs.y);
  return {times * legs.x, builder.Sign() * times * legs.y};
}

PlanarMesh DrawTiltedGrid(CaseBuilder& builder, Point2 node, Point2 side) {
  BitSource& bits = builder.bits();
  const int columns = static_cast<int>(bits.Int(1, 5));
  const int rows = static_cast<int>(bits.Int(1, 5));
  const auto first = static_cast<int>(bits.Int(0, columns));
  const auto top = static_cast<int>(bits.Int(0, rows));
  PlanarMesh mesh;
  for (int j = -top; j <= rows - top; ++j) {
    for (int i = -first; i <= columns - first; ++i) {
      mesh.AddVertex(
          OnLattice(builder, {node.x + i * side.x - j * side.y, node.y + i * side.y + j * side.x}));
    }
  }
  mesh.AddCells(bits, columns, rows);
  return mesh;
}

}  // namespace

static Case TiltedGrids(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Point2 side = DrawCellSide(builder);
  PlanarMesh mesh = DrawTiltedGrid(builder, OnLattice(builder, builder.Sample()), side);
  // An end of the range or a coarse lattice has folded it.
  if (!mesh.IsFacingOneWay()) mesh.triangles.resize(1);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kTiltedGridsDomain{
    .number = 101,
    .bits = 0xdd1e1a31db590f8d,
    .listed = 702,
    .name = "tilted-grids",
    .summary = "grids turned by Pythagorean angles, exactly or rounded, and by small ones",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = TiltedGrids};

static Case DiagonalNeedles(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t needles = bits.Int(1, 6);
  for (std::int64_t i = 0; i < needles; ++i) {
    const Point2 p = OnLattice(builder, builder.Sample());
    const double slope = builder.Sign();
    const auto at = [&](std::int64_t steps) {
      const auto t = static_cast<double>(steps);
      return OnLattice(builder, {p.x + t, p.y + slope * t});
    };
    const Point2 a = at(-bits.Int(0, 24));
    const Point2 b = at(bits.Int(1, 24));
    // The third corner beside an end or beside p; on the diagonal, the needle covers nothing.
    const Point2 apex = bits.OneOf(std::span<const Point2>(std::array{a, b, p}));
    const Point2 beside = OnLattice(builder, Nudged(builder, apex, 1));
    builder.AddTriangle({a, b, beside});
    // The other half of a strip a step wide, or a neighbour across the diagonal.
    if (bits.Chance(128)) builder.AddTriangle({b, a, OnLattice(builder, Nudged(builder, a, 1))});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kDiagonalNeedlesDomain{
    .number = 75,
    .bits = 0x861ed94f01c9779,
    .name = "diagonal-needles",
    .summary = "needles a step wide along the diagonals of samples",
    .theme = DomainTheme::kThin,
    .near_edge = true,
    .draw = DiagonalNeedles};

}  // namespace rasterproof::props
