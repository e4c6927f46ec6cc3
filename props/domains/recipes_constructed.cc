// Meshes as other programs make them: arrangements of lines whose crossings are rounded, vertices
// that only the snap makes equal, polygons with holes that were cut into ears.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"
#include "props/domains/planar_mesh.h"

namespace rasterproof::props {
namespace {

using Ring = std::vector<std::int32_t>;

// Faces between lines that cross a frame. Each edge is an edge of two of them, once each way,
// wherever rounding puts the vertices.
struct Arrangement {
  std::vector<Point2> vertices;
  std::vector<Ring> faces;  ///< the first is the back of the frame, which no line cuts in two

  void Cut(Point2 through, Point2 along);
};

void Arrangement::Cut(Point2 through, Point2 along) {
  const auto side = [&](std::int32_t v) {
    const Point2 p = vertices[static_cast<std::size_t>(v)];
    const double across = along.x * (p.y - through.y);
    return across - along.y * (p.x - through.x);
  };
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> crossings;
  const auto crossing = [&](std::int32_t v, std::int32_t w) {
    const auto [found, is_new] =
        crossings.try_emplace(std::minmax({v, w}), static_cast<std::int32_t>(vertices.size()));
    if (is_new) {
      const double t = side(v) / (side(v) - side(w));
      const Point2 a = vertices[static_cast<std::size_t>(v)];
      const Point2 b = vertices[static_cast<std::size_t>(w)];
      vertices.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    return found->second;
  };
  const std::size_t count = faces.size();
  for (std::size_t f = 0; f < count; ++f) {
    Ring ring;
    std::vector<std::ptrdiff_t> cuts;
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const std::int32_t v = faces[f][k];
      const std::int32_t next = faces[f][(k + 1) % faces[f].size()];
      ring.push_back(v);
      if ((side(v) < 0) == (side(next) < 0)) continue;
      cuts.push_back(static_cast<std::ptrdiff_t>(ring.size()));
      ring.push_back(crossing(v, next));
    }
    if (f != 0 && cuts.size() == 2) {
      faces.emplace_back(ring.begin() + cuts[0], ring.begin() + cuts[1] + 1);
      ring.erase(ring.begin() + cuts[0] + 1, ring.begin() + cuts[1]);
    }
    faces[f] = std::move(ring);
  }
}

// Lines that pass a few steps beside one sample, and cross there, or a few pixels.
Arrangement DrawArrangement(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const auto margin = static_cast<double>(bits.Int(1, 6));
  const double right = builder.width() + margin;
  const double bottom = builder.height() + margin;
  Arrangement drawn{{{-margin, -margin}, {-margin, bottom}, {right, bottom}, {right, -margin}},
                    {{3, 2, 1, 0}, {0, 1, 2, 3}}};
  for (Point2& p : drawn.vertices) p = OnLattice(builder, p);
  const Point2 hub = OnLattice(builder, builder.Sample());
  const double step = builder.lattice().Step(std::max(std::fabs(hub.x), std::fabs(hub.y)));
  const double apart = bits.Chance(192) ? 2 * step : 3;
  // Nearly parallel lines make slivers, whose triangles are inverted most often.
  const std::int64_t steepest = bits.Chance(128) ? 64 : 3;
  const std::int64_t lines = bits.Int(4, 9);
  for (std::int64_t i = 0; i < lines; ++i) {
    const double x = hub.x + builder.Uniform(-apart, apart);
    const Point2 through{x, hub.y + builder.Uniform(-apart, apart)};
    drawn.Cut(through, {32, static_cast<double>(bits.Int(-steepest, steepest))});
  }
  return drawn;
}

// Places along one axis, some of which the snap makes equal to the one before. Where nothing is
// snapped, they are one step apart.
std::vector<double> DrawPlaces(CaseBuilder& builder, double first) {
  BitSource& bits = builder.bits();
  const InputLattice& lattice = builder.lattice();
  const bool is_snapped = !builder.profile().snap.IsNone();
  std::vector<double> places{
      lattice.RoundWithinLimit(first - 2 * static_cast<double>(bits.Int(0, 4)))};
  const std::int64_t more = bits.Int(2, 5);
  for (std::int64_t i = 0; i < more; ++i) {
    const double last = places.back();
    if (bits.Chance(96)) {
      places.push_back(is_snapped ? last : lattice.Move(last, 1));
    } else {
      places.push_back(lattice.RoundWithinLimit(last + 2 * static_cast<double>(bits.Int(1, 4))));
    }
  }
  return places;
}

// A place between grid points that is snapped to x; x itself where nothing is snapped.
double SnappedTo(CaseBuilder& builder, double x) {
  const Snap& snap = builder.profile().snap;
  if (snap.IsNone()) return x;
  const double off = builder.Uniform(-0.45, 0.45) * std::ldexp(1.0, -snap.bits);
  const InputLattice& lattice = builder.lattice();
  for (const double moved : {x + off, x - off}) {
    const double given = lattice.RoundToPrecision(moved);
    if (given < lattice.lowest() || given > lattice.limit()) continue;
    if (SnapCoordinate(given, snap) == SnapCoordinate(x, snap)) return given;
  }
  return x;
}

std::int32_t AddSnappedTo(CaseBuilder& builder, Point2 p) {
  const double x = SnappedTo(builder, p.x);
  return builder.AddRaw({x, SnappedTo(builder, p.y)});
}

// A box around `centre`, or a diamond, the other way round than a frame and from its leftmost
// corner; with points half way along its sides or without.
std::vector<Point2> DrawHole(BitSource& bits, Point2 centre, double radius) {
  const double r = radius;
  std::vector<Point2> corners{{-r, 0}, {0, -r}, {r, 0}, {0, r}};
  if (bits.Chance(128)) corners = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  const bool has_middles = bits.Chance(128);
  std::vector<Point2> hole;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point2 a = corners[k];
    const Point2 b = corners[(k + 1) % 4];
    hole.push_back({centre.x + a.x, centre.y + a.y});
    if (!has_middles) continue;
    hole.push_back({centre.x + (a.x + b.x) / 2, centre.y + (a.y + b.y) / 2});
  }
  return hole;
}

// The outline with the hole's joined to it by a bridge from its vertex `at` to the hole's first:
// both ends are there twice.
std::vector<Point2> Bridged(const std::vector<Point2>& outline, std::size_t at,
                            const std::vector<Point2>& hole) {
  const auto bridge = outline.begin() + static_cast<std::ptrdiff_t>(at);
  std::vector<Point2> joined(outline.begin(), bridge + 1);
  joined.insert(joined.end(), hole.begin(), hole.end());
  joined.push_back(hole.front());
  joined.insert(joined.end(), bridge, outline.end());
  return joined;
}

// A box with one hole or two, as one outline around the origin. Every number is even but those of
// points half way.
std::vector<Point2> DrawOutline(BitSource& bits) {
  const auto even = [&](int low, int high) { return 2 * static_cast<double>(bits.Int(low, high)); };
  const double radius = even(1, 3);
  std::vector<Point2> holes = DrawHole(bits, {0, 0}, radius);
  double right = radius;
  double height = radius;
  if (bits.Chance(128)) {
    const double other = even(1, 2);
    const double x = right + even(1, 2) + other;
    const double y = even(-2, 2);
    const auto rightmost = std::ranges::max_element(holes, {}, &Point2::x);
    const auto at = static_cast<std::size_t>(rightmost - holes.begin());
    holes = Bridged(holes, at, DrawHole(bits, {x, y}, other));
    right = x + other;
    height = std::max(height, std::fabs(y) + other);
  }
  right += even(1, 3);
  height += even(1, 3);
  const double left = -radius - even(1, 3);
  const double middle = (left + right) / 2;
  return Bridged({{left, -height},
                  {left, 0},
                  {left, height},
                  {middle, height},
                  {right, height},
                  {right, 0},
                  {right, -height},
                  {middle, -height}},
                 static_cast<std::size_t>(bits.Int(0, 2)), holes);
}

// Whether no vertex of the ring lies in the triangle, its border included, but at its corners.
bool IsEmpty(const std::vector<Point2>& ring, const std::array<Point2, 3>& v) {
  const int facing = exact::Facing(v);
  return std::ranges::none_of(ring, [&](Point2 p) {
    if (p == v[0] || p == v[1] || p == v[2]) return false;
    return facing * exact::EdgeSign(v[0], v[1], p) >= 0 &&
           facing * exact::EdgeSign(v[1], v[2], p) >= 0 &&
           facing * exact::EdgeSign(v[2], v[0], p) >= 0;
  });
}

// Cuts ears off the mesh's vertices, taken as an outline of that facing, until none is left. Ears
// without area are cut when they are met, or only where no other is left; not all are kept.
void CutEars(BitSource& bits, PlanarMesh& mesh, int facing) {
  std::vector<Point2> places = mesh.vertices;
  Ring ring;
  for (std::size_t i = 0; i < places.size(); ++i) ring.push_back(static_cast<std::int32_t>(i));
  const bool takes_flat = bits.Chance(128);
  auto k = static_cast<std::size_t>(bits.Int(0, static_cast<std::int64_t>(ring.size()) - 1));
  std::size_t tried = 0;
  while (ring.size() >= 3 && tried < 2 * ring.size()) {
    const std::size_t n = ring.size();
    const std::size_t ends[] = {(k + n - 1) % n, k % n, (k + 1) % n};
    const std::array<Point2, 3> ear{places[ends[0]], places[ends[1]], places[ends[2]]};
    const int turn = facing * exact::Facing(ear);
    const bool is_flat = turn == 0 && (takes_flat || tried >= n);
    k = (k + 1) % n;
    ++tried;
    if (!is_flat && (turn <= 0 || !IsEmpty(places, ear))) continue;
    if (turn != 0 || bits.Chance(128)) {
      mesh.triangles.push_back({ring[ends[0]], ring[ends[1]], ring[ends[2]]});
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ends[1]));
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(ends[1]));
    tried = 0;
  }
}

}  // namespace

static Case RoundedArrangements(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Arrangement drawn = DrawArrangement(builder);
  for (const Point2 p : drawn.vertices) builder.Add(p);
  const bool is_closed = bits.Chance(128);
  for (std::size_t f = is_closed ? 0 : 1; f < drawn.faces.size(); ++f) {
    const Ring& face = drawn.faces[f];
    for (std::size_t k = 2; k < face.size(); ++k) {
      builder.AddTriangle(face[0], face[k - 1], face[k]);
    }
  }
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kRoundedArrangementsDomain{
    .number = 77,
    .bits = 0x6474fca426d57fe3,
    .name = "rounded-arrangements",
    .summary = "lines whose crossings are rounded: flat and inverted triangles in a mesh",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .overlaps = true,
    .draw = RoundedArrangements};

static Case EqualAfterSnap(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Point2 p = OnLattice(builder, builder.Sample());
  const std::vector<double> xs = DrawPlaces(builder, p.x);
  const std::vector<double> ys = DrawPlaces(builder, p.y);
  for (const double y : ys) {
    for (const double x : xs) AddSnappedTo(builder, {x, y});
  }
  const double least = 1;  // of a cell's side, or the snap has closed it
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      const auto a = static_cast<std::int32_t>(j * xs.size() + i);
      const auto c = static_cast<std::int32_t>((j + 1) * xs.size() + i);
      builder.AddTriangle(a, c, a + 1);
      const bool is_open = xs[i + 1] - xs[i] >= least && ys[j + 1] - ys[j] >= least;
      if (!is_open || bits.Chance(128)) {
        builder.AddTriangle(a + 1, c, c + 1);
        continue;
      }
      // A vertex that only the snap puts on the diagonal; else it lies a step off it.
      Point2 middle = OnLattice(builder, {(xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2});
      if (builder.profile().snap.IsNone()) middle.x = builder.lattice().Move(middle.x, 1);
      const std::int32_t m = AddSnappedTo(builder, middle);
      builder.AddTriangle(a + 1, c, m);
      builder.AddTriangle(c, c + 1, m);
      builder.AddTriangle(c + 1, a + 1, m);
    }
  }
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kEqualAfterSnapDomain{
    .number = 78,
    .bits = 0xe1c418da1cbc6224,
    .name = "equal-after-snap",
    .summary = "grids of vertices that only the snap makes equal or collinear",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .mesh = true,
    .draw = EqualAfterSnap};

static Case EarcutMeshes(BitSource& bits, const SubjectInfo& info) {
  constexpr std::array<Point2, 4> kTurns{{{1, 0}, {1, 0}, {1, 1}, {2, 1}}};
  CaseBuilder builder(bits, info);
  const Point2 p = OnLattice(builder, builder.Sample());
  const Point2 turn = bits.OneOf(std::span<const Point2>(kTurns));
  PlanarMesh mesh;
  for (const Point2 q : DrawOutline(bits)) {
    mesh.AddVertex(
        OnLattice(builder, {p.x + turn.x * q.x - turn.y * q.y, p.y + turn.y * q.x + turn.x * q.y}));
  }
  CutEars(bits, mesh, exact::Facing({Point2{0, 0}, Point2{0, 1}, Point2{1, 1}}));
  if (mesh.triangles.empty()) mesh.triangles.push_back({0, 1, 2});
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kEarcutMeshesDomain{
    .number = 79,
    .bits = 0xa66c9628c808f0f4,
    .name = "earcut-meshes",
    .summary = "polygons cut into ears, their holes joined by bridges of repeated vertices",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .draw = EarcutMeshes};

}  // namespace rasterproof::props
