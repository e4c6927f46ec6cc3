// Triangles that are no mesh, or two meshes that ought to be one: cracks, soups, coincident layers.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
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
namespace soups {

// An edge of a patch: so many parts, and how far its middle is displaced to the side.
struct PatchEdge {
  Segment ends;
  std::int64_t parts = 1;
  double bulge = 0;
};

// A line through a sample that is on the lattice may be that sample alone: it has no direction, and
// nothing is displaced from it.
double LengthOf(Point2 d) { return d == Point2{} ? 1 : Hypot(d.x, d.y); }

Point2 PlaceOn(const CaseBuilder& builder, const PatchEdge& edge, std::int64_t part) {
  const double t = static_cast<double>(part) / static_cast<double>(edge.parts);
  const Point2 d{edge.ends.b.x - edge.ends.a.x, edge.ends.b.y - edge.ends.a.y};
  const double off = 4 * t * (1 - t) * edge.bulge / LengthOf(d);
  return OnLattice(builder,
                   {edge.ends.a.x + t * d.x - off * d.y, edge.ends.a.y + t * d.y + off * d.x});
}

// The triangles between two edges, as a tessellator zips them.
void AddPatch(const CaseBuilder& builder, PlanarMesh& mesh, const PatchEdge& left,
              const PatchEdge& right) {
  std::int64_t i = 0, j = 0;
  std::int32_t on_left = mesh.AddVertex(PlaceOn(builder, left, 0));
  std::int32_t on_right = mesh.AddVertex(PlaceOn(builder, right, 0));
  while (i < left.parts || j < right.parts) {
    if ((i + 1) * right.parts <= (j + 1) * left.parts) {
      const std::int32_t next = mesh.AddVertex(PlaceOn(builder, left, ++i));
      mesh.triangles.push_back({on_left, next, on_right});
      on_left = next;
    } else {
      const std::int32_t next = mesh.AddVertex(PlaceOn(builder, right, ++j));
      mesh.triangles.push_back({on_left, next, on_right});
      on_right = next;
    }
  }
}

// A corner of a soup: a vertex again, its place under another index, or a new one.
std::int32_t DrawCorner(CaseBuilder& builder, std::vector<Point2>& places) {
  const auto count = static_cast<std::int64_t>(places.size());
  const std::int64_t kind = builder.bits().Int(0, 3);
  if (count > 0 && kind < 2) return static_cast<std::int32_t>(builder.bits().Int(0, count - 1));
  const Point2 place = count > 0 && kind == 2
                           ? builder.bits().OneOf(std::span<const Point2>(places))
                           : OnLattice(builder, builder.Place());
  places.push_back(place);
  return builder.Add(place);
}

// Depths on either side of [0, 1], and next to its ends.
constexpr std::array<double, 12> kDepths{0,   1,           0.5,         -0.0,   -0x1p-149, -1,
                                         2.5, 1 + 0x1p-23, 1 - 0x1p-24, 0x1p24, -1e30,     1e30};

struct Layer {
  std::array<Point2, 3> places;
  std::array<double, 3> depths;
};

// A plane, along which depths are rounded alone.
struct DepthPlane {
  double at_origin = 0;
  Point2 slope;

  std::array<double, 3> At(const std::array<Point2, 3>& places) const {
    std::array<double, 3> depths{};
    for (std::size_t k = 0; k < 3; ++k) {
      depths[k] = at_origin + slope.x * places[k].x + slope.y * places[k].y;
    }
    return depths;
  }
};

std::array<Point2, 3> DrawPlaces(CaseBuilder& builder) {
  std::array<Point2, 3> places;
  for (Point2& p : places) p = OnLattice(builder, builder.Place());
  return places;
}

// A triangle of the plane, or an earlier one again: turned, or an ulp nearer or farther.
Layer DrawLayer(CaseBuilder& builder, const DepthPlane& plane, const std::vector<Layer>& earlier) {
  const std::int64_t kind = builder.bits().Int(0, 3);
  if (earlier.empty() || kind == 0) {
    const std::array<Point2, 3> places = DrawPlaces(builder);
    return {places, plane.At(places)};
  }
  Layer again = builder.bits().OneOf(std::span<const Layer>(earlier));
  if (kind == 1) return again;
  if (kind == 2) {
    std::swap(again.places[0], again.places[1]);
    std::swap(again.depths[0], again.depths[1]);
    return again;
  }
  for (double& z : again.depths) z *= 1 + builder.Sign() * 0x1p-23;
  return again;
}

}  // namespace soups

static Case TessellationCracks(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  // The common edge passes through a sample. Its places are rounded for either patch, and half of
  // the time a patch displaces them by as much as its factor lets it see.
  const Segment common = SegmentThrough(builder, builder.Sample());
  const Point2 d{common.b.x - common.a.x, common.b.y - common.a.y};
  const auto beside = [&](double sign) {
    const double off = sign * builder.Uniform(3, 16) / soups::LengthOf(d);
    return Segment{{common.a.x - off * d.y, common.a.y + off * d.x},
                   {common.b.x - off * d.y, common.b.y + off * d.x}};
  };
  const std::int64_t fewer = bits.Int(1, 16);
  const std::int64_t more = fewer + bits.Int(1, 16);
  const double bulge = bits.Chance(128) ? 0 : builder.Uniform(-2, 2);
  const soups::PatchEdge coarse{common, fewer, bulge};
  const soups::PatchEdge fine{common, more, bulge};
  PlanarMesh mesh;
  const soups::PatchEdge left{beside(-1), bits.Int(1, 8), 0};
  soups::AddPatch(builder, mesh, coarse, left);
  const soups::PatchEdge right{beside(+1), bits.Int(1, 8), 0};
  soups::AddPatch(builder, mesh, right, fine);
  mesh.AddTo(builder);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kTessellationCracksDomain{
    .number = 82,
    .bits = 0xebf9e87df878dca5,
    .name = "tessellation-cracks",
    .summary = "patches that divide their edge unequally: the oracle's count, not 1",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .overlaps = true,
    .draw = TessellationCracks};

static Case Soups(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  std::vector<Point2> places;
  std::vector<Triangle> faces;
  const std::int64_t count = bits.Int(3, 24);
  for (std::int64_t f = 0; f < count; ++f) {
    const std::int64_t kind = bits.Int(0, 3);
    Triangle face{};
    if (f > 0 && kind == 0) {  // an earlier face, as it was or its back
      face = bits.OneOf(std::span<const Triangle>(faces));
      if (bits.Chance(128)) std::swap(face[0], face[1]);
    } else {
      for (std::int32_t& corner : face) corner = soups::DrawCorner(builder, places);
    }
    faces.push_back(face);
    builder.AddTriangle(face[0], face[1], face[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSoupsDomain{
    .number = 83,
    .bits = 0xcdf398c147a47290,
    .name = "soups",
    .summary = "faces twice, crossing, of both windings, their vertices shared or repeated",
    .theme = DomainTheme::kMeshes,
    .draw = Soups};

static Case CoplanarDepths(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  soups::DepthPlane plane{bits.OneOf(std::span<const double>(soups::kDepths)), {}};
  if (bits.Chance(160)) plane.slope = {builder.LogUniform(-12, 0), builder.LogUniform(-12, 0)};
  std::vector<soups::Layer> layers;
  const std::int64_t count = bits.Int(2, 12);
  for (std::int64_t k = 0; k < count; ++k) {
    layers.push_back(soups::DrawLayer(builder, plane, layers));
    const soups::Layer& layer = layers.back();
    std::array<std::int32_t, 3> corners{};
    for (std::size_t v = 0; v < 3; ++v) {
      corners[v] = builder.AddRaw({layer.places[v].x, layer.places[v].y, layer.depths[v]});
    }
    builder.AddTriangle(corners[0], corners[1], corners[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kCoplanarDepthsDomain{
    .number = 84,
    .bits = 0x369a7d4c50f53811,
    .name = "coplanar-depths",
    .summary = "layers of one plane or an ulp off it, their z in [0, 1] and far outside",
    .theme = DomainTheme::kCalls,
    .in_theme = 871,
    .draw = CoplanarDepths};

}  // namespace rasterproof::props
