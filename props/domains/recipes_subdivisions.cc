// Meshes made by splitting: triangulations of hard places, fans that cover the target from far
// away, recursive subdivision, T-junctions, grids finer than pixels.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"
#include "props/domains/planar_mesh.h"

namespace rasterproof::props {
namespace {

// A quad around the target, on whole pixels a few off its border, cut along a diagonal.
PlanarMesh DrawFrame(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const auto margin = [&] { return static_cast<double>(bits.Int(1, 6)); };
  PlanarMesh mesh;
  const auto add = [&](Point2 p) { mesh.AddVertex(OnLattice(builder, p)); };
  add({-margin(), -margin()});
  add({-margin(), builder.height() + margin()});
  add({builder.width() + margin(), builder.height() + margin()});
  add({builder.width() + margin(), -margin()});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

struct EdgeMiddle {
  std::size_t triangle = 0;
  std::size_t edge = 0;  ///< opposite vertex `edge`
  Point2 at;             ///< on the lattice
};

EdgeMiddle DrawMiddle(CaseBuilder& builder, const PlanarMesh& mesh) {
  const auto count = static_cast<std::int64_t>(mesh.triangles.size());
  EdgeMiddle middle{.triangle = static_cast<std::size_t>(builder.bits().Int(0, count - 1)),
                    .edge = static_cast<std::size_t>(builder.bits().Int(0, 2)),
                    .at = {}};
  const Triangle& t = mesh.triangles[middle.triangle];
  const Point2 a = mesh.vertices[static_cast<std::size_t>(t[(middle.edge + 1) % 3])];
  const Point2 b = mesh.vertices[static_cast<std::size_t>(t[(middle.edge + 2) % 3])];
  middle.at = OnLattice(builder, {(a.x + b.x) / 2, (a.y + b.y) / 2});
  return middle;
}

// A fan around a sample of the target, its rim one corner in each outer quadrant, up to the end of
// the range: it covers the target, however far the corners are. Real geometry, whose range is
// large, would have all of the target count as beside the outline of two neighbours: 2^17 at most.
PlanarMesh DrawCoveringFan(CaseBuilder& builder) {
  const bool is_real = builder.profile().snap.IsNone();
  const double range = is_real ? std::min(builder.Range(), 0x1p17) : builder.Range();
  const int most = std::max(4, std::ilogb(range));
  const auto beyond = [&] {
    const int least = builder.bits().Chance(128) ? 1 : most - 3;
    return std::min(std::fabs(builder.LogUniform(least, most)), range);
  };
  PlanarMesh mesh;
  for (const Point2 side : {Point2{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}) {
    const double x = side.x < 0 ? -beyond() : builder.width() + beyond();
    const double y = side.y < 0 ? -beyond() : builder.height() + beyond();
    mesh.AddVertex(OnLattice(builder, {x, y}));
  }
  const std::int32_t hub = mesh.AddVertex(OnLattice(builder, builder.Sample()));
  for (std::int32_t k = 0; k < 4; ++k) mesh.triangles.push_back({hub, k, (k + 1) % 4});
  return mesh;
}

// Splits the mesh at middles of edges, samples, places beside them and others.
void InsertPlaces(CaseBuilder& builder, PlanarMesh& mesh) {
  BitSource& bits = builder.bits();
  const std::int64_t places = bits.Int(1, 16);
  for (std::int64_t i = 0; i < places; ++i) {
    const std::int64_t kind = bits.Int(0, 3);
    if (kind == 0) {
      mesh.Insert(DrawMiddle(builder, mesh).at);
    } else if (kind == 1) {
      mesh.Insert(OnLattice(builder, builder.Sample()));
    } else if (kind == 2) {
      mesh.Insert(OnLattice(builder, Nudged(builder, builder.Sample(), 2)));
    } else {
      mesh.Insert(OnLattice(builder, builder.Place()));
    }
  }
}

// A grid over some whole pixels, its nodes on sixteenths, which every grid of 4 bits has. It stays
// on the target when it is moved by less than a pixel.
PlanarMesh DrawFineGrid(CaseBuilder& builder, Point2 corner, int pixels) {
  constexpr std::array kSpacings{2, 2, 3, 4, 6, 8};  // in sixteenths
  BitSource& bits = builder.bits();
  const int spacing = bits.OneOf(std::span<const int>(kSpacings));
  const int cells = pixels * 16 / spacing;
  const std::int64_t most = spacing < 6 || bits.Chance(128) ? 0 : 1;
  PlanarMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool is_inner = i > 0 && i < cells && j > 0 && j < cells;
      const auto moved = [&] {
        return is_inner && most != 0 ? static_cast<double>(bits.Int(-most, most)) : 0.0;
      };
      const double x = corner.x + (i * spacing + moved()) / 16;
      const double y = corner.y + (j * spacing + moved()) / 16;
      mesh.AddVertex(OnLattice(builder, {x, y}));
    }
  }
  mesh.AddCells(bits, cells, cells);
  return mesh;
}

}  // namespace

static Case FineMeshes(BitSource& bits, const SubjectInfo& info) {
  const int pixels = bits.Chance(64) ? 4 : 3;
  const int width = pixels + static_cast<int>(bits.Int(1, 4));
  const int height = pixels + static_cast<int>(bits.Int(1, 4));
  CaseBuilder builder(bits, info, width, height);
  const auto x = static_cast<double>(bits.Int(0, width - pixels - 1));
  const auto y = static_cast<double>(bits.Int(0, height - pixels - 1));
  PlanarMesh mesh = DrawFineGrid(builder, {x, y}, pixels);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kFineMeshesDomain{
    .number = 92,
    .bits = 0x1a64e26cf8bc1459,
    .name = "fine-meshes",
    .summary = "grids of 1/8 to 1/2 pixel on sixteenths: each pixel many triangles",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .overlaps = true,
    .is_stated = [](const Profile& p) { return p.sample_positions != SamplePositions::kStated; },
    .draw = FineMeshes};

static Case Triangulations(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  PlanarMesh mesh = DrawFrame(builder);
  mesh.Insert(OnLattice(builder, builder.Sample()));
  InsertPlaces(builder, mesh);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kTriangulationsDomain{
    .number = 33,
    .bits = 0x12a312b80d8dd965,
    .name = "triangulations",
    .summary = "samples, midpoints and places beside them inserted one by one",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = Triangulations};

static Case CoveringFans(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  PlanarMesh mesh = DrawCoveringFan(builder);
  if (bits.Chance(192)) InsertPlaces(builder, mesh);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kCoveringFansDomain{
    .number = 34,
    .bits = 0xc8f525f5c7780bdc,
    .name = "covering-fans",
    .summary = "a hub on the target, the rim up to the end of the stated range",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .draw = CoveringFans};

static Case Subdivisions(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  PlanarMesh mesh = DrawFrame(builder);
  mesh.Insert(OnLattice(builder, builder.Sample()));
  // Every split is taken by both sides of the edge, so the mesh stays conforming; midpoints halve
  // until the lattice ends them.
  const std::int64_t splits = bits.Int(4, 40);
  for (std::int64_t i = 0; i < splits; ++i) mesh.Insert(DrawMiddle(builder, mesh).at);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kSubdivisionsDomain{
    .number = 35,
    .bits = 0xa427f0df502f79dc,
    .name = "subdivisions",
    .summary = "edges halved again and again, on both sides",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .draw = Subdivisions};

static Case TJunctions(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  PlanarMesh mesh = DrawFrame(builder);
  const Point2 p = builder.Sample();
  mesh.Insert(OnLattice(builder, p));
  const std::int64_t splits = bits.Int(1, 8);
  for (std::int64_t i = 0; i < splits; ++i) {
    EdgeMiddle middle = DrawMiddle(builder, mesh);
    // Half of them on the edge as nearly as the lattice allows; of the others half a step off it,
    // a quarter some steps, a quarter visibly.
    const std::int64_t kind = bits.Int(0, 7);
    if (kind < 2) middle.at = OnLattice(builder, Nudged(builder, middle.at, 1));
    if (kind == 2) middle.at = OnLattice(builder, Nudged(builder, middle.at, 16));
    if (kind == 3) middle.at = OnLattice(builder, {OnGrid(middle.at.x, 0), OnGrid(middle.at.y, 0)});
    mesh.SplitOneSide(middle.triangle, middle.edge, middle.at);
  }
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kTJunctionsDomain{
    .number = 36,
    .bits = 0x9c6b96ddf18cd688,
    .name = "t-junctions",
    .summary = "edges halved on one side only: the oracle's count is expected, not 1",
    .theme = DomainTheme::kMeshes,
    .near_edge = true,
    .mesh = true,
    .overlaps = true,
    .draw = TJunctions};

}  // namespace rasterproof::props
