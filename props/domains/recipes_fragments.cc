// Fragments of triangles whose corners lie off the grid: what is interpolated between the corners
// as given differs from what is between those on the grid.
#include <array>
#include <cmath>
#include <cstdint>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/planar_mesh.h"

namespace rasterproof::props {
namespace {

// Anywhere; an integer input has its lattice alone.
std::int32_t AddOffGrid(CaseBuilder& builder, Point2 p) {
  return builder.profile().fixed ? builder.Add(p) : builder.AddRaw({p.x, p.y});
}

void AddMesh(CaseBuilder& builder, const PlanarMesh& mesh) {
  for (const Point2 p : mesh.vertices) AddOffGrid(builder, p);
  for (const Triangle& t : mesh.triangles) builder.AddTriangle(t[0], t[1], t[2]);
}

Point2 Towards(Point2 from, double turn, double distance) {
  return {from.x + CosPi(turn) * distance, from.y + SinPi(turn) * distance};
}

// Around samples, down to a few steps of a grid of eight bits, and as flat as it comes.
void AddSmallTriangles(CaseBuilder& builder) {
  constexpr int kLeast = -6;
  const std::int64_t triangles = builder.bits().Int(1, 6);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = builder.Sample();
    double turn = builder.Uniform(-1, 1);
    std::array<std::int32_t, 3> corners{};
    for (std::int32_t& corner : corners) {
      corner = AddOffGrid(builder, Towards(p, turn, std::fabs(builder.LogUniform(kLeast, 0))));
      turn += builder.Uniform(0.48, 0.82);  // less than half a turn, three of them more than one
    }
    builder.AddTriangle(corners[0], corners[1], corners[2]);
  }
}

// A hub in the target and a rim of up to 64 vertices, each as far away as it likes.
PlanarMesh DrawFan(CaseBuilder& builder) {
  PlanarMesh mesh;
  const Point2 hub = builder.Place();
  mesh.AddVertex(hub);
  const auto rim = static_cast<std::int32_t>(builder.bits().Int(5, 64));
  const double first = builder.Uniform(-1, 1);
  for (std::int32_t k = 0; k < rim; ++k) {
    const double turn = first + 2 * (k + builder.Uniform(0, 0.5)) / rim;
    mesh.AddVertex(Towards(hub, turn, builder.Uniform(2, 24)));
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % rim});
  }
  return mesh;
}

// Quads of two triangles from beyond the target's upper left corner on, every vertex moved.
PlanarMesh DrawQuads(CaseBuilder& builder) {
  PlanarMesh mesh;
  const auto columns = static_cast<std::int32_t>(builder.bits().Int(2, 7));
  const auto rows = static_cast<std::int32_t>(builder.bits().Int(2, 7));
  const double side = builder.Uniform(0.5, 6);
  for (std::int32_t row = 0; row <= rows; ++row) {
    for (std::int32_t column = 0; column <= columns; ++column) {
      const double x = side * (column + builder.Uniform(-0.3, 0.3));
      mesh.AddVertex({x, side * (row + builder.Uniform(-0.3, 0.3))});
      if (row == rows || column == columns) continue;
      const std::int32_t at = row * (columns + 1) + column;
      const std::int32_t below = at + columns + 1;
      mesh.triangles.push_back({at, at + 1, below});
      mesh.triangles.push_back({at + 1, below + 1, below});
    }
  }
  return mesh;
}

}  // namespace

static Case OffGridFragments(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  switch (bits.Int(0, 2)) {
    case 0:
      AddSmallTriangles(builder);
      break;
    case 1:
      AddMesh(builder, DrawFan(builder));
      break;
    default:
      AddMesh(builder, DrawQuads(builder));
      break;
  }
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kOffGridFragmentsDomain{
    .number = 98,
    .bits = 0x6bcb625f925c8caa,
    .listed = 522,
    .name = "off-grid-fragments",
    .summary = "small triangles, fans and quads whose corners lie between grid points",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .draw = OffGridFragments};

}  // namespace rasterproof::props
