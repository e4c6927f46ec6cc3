// Closed surfaces, and clip space: in front of the eye, around it, behind it.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/hardest_ray.h"

namespace rasterproof::props {
namespace {

struct Surface {
  std::int32_t vertices = 0;
  std::vector<Triangle> triangles;
};

Surface Tetrahedron() { return {4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}}; }

// Poles 0 and 1, n vertices around.
Surface Bipyramid(std::int32_t n) {
  Surface surface{n + 2, {}};
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t a = 2 + i;
    const std::int32_t b = 2 + (i + 1) % n;
    surface.triangles.push_back({0, a, b});
    surface.triangles.push_back({1, b, a});
  }
  return surface;
}

Surface Torus(std::int32_t columns, std::int32_t rows) {
  Surface surface{columns * rows, {}};
  for (std::int32_t j = 0; j < rows; ++j) {
    for (std::int32_t i = 0; i < columns; ++i) {
      const std::int32_t right = (i + 1) % columns;
      const std::int32_t below = (j + 1) % rows;
      const std::int32_t a = j * columns + i;
      const std::int32_t b = j * columns + right;
      const std::int32_t c = below * columns + i;
      const std::int32_t d = below * columns + right;
      surface.triangles.push_back({a, b, c});
      surface.triangles.push_back({b, d, c});
    }
  }
  return surface;
}

Surface DrawSurface(BitSource& bits) {
  const std::int64_t kind = bits.Int(0, 3);
  if (kind == 0) return Tetrahedron();
  if (kind == 1) return Torus(static_cast<std::int32_t>(bits.Int(3, 5)), 3);
  return Bipyramid(static_cast<std::int32_t>(bits.Int(3, 8)));
}

void AddTriangles(CaseBuilder& builder, const Surface& surface) {
  for (const Triangle& t : surface.triangles) builder.AddTriangle(t[0], t[1], t[2]);
}

// A direction that lies inside no smaller cone: the place of vertex v on a surface around the
// origin. Poles are opposite each other, the others go round between them.
std::array<double, 3> AroundOrigin(std::int32_t v, const Surface& surface) {
  if (v == 0) return {0, -1, 0.1};
  if (v == 1) return {0, 1, 0.1};
  const double turn = 2.0 * (v - 2) / std::max(1, surface.vertices - 2);
  return {CosPi(turn), 0.1 * SinPi(3 * turn), SinPi(turn)};
}

// The clip-space vertex that projects to the window place p, with this w.
void AddProjected(CaseBuilder& builder, Point2 p, double w) {
  if (w == 0) {
    builder.AddRaw({p.x, p.y, 0, w});  // a direction
    return;
  }
  builder.AddRaw({p.x * w, p.y * w, 0, w});
}

double DrawMixedW(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const bool is_float32 = builder.lattice().precision() == Precision::kFloat32;
  switch (bits.Int(0, 7)) {
    case 0:
      return 0.0;
    case 1:
      return -0.0;
    case 2:  // w -> 0
      return builder.LogUniform(is_float32 ? -149 : -1074, -20);
    case 3:  // just behind or before the eye
      return builder.Sign() * 0x1p-12;
    case 4:
      return builder.Sign();
    default:
      return builder.LogUniform(-12, 3);
  }
}

// A few triangles at places of the window, each vertex with a w of its own.
Case ClipTriangles(BitSource& bits, const SubjectInfo& info, double (*draw_w)(CaseBuilder&)) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const auto triangles = static_cast<std::int32_t>(bits.Int(1, 4));
  for (std::int32_t t = 0; t < triangles; ++t) {
    for (int v = 0; v < 3; ++v) {
      const double w = draw_w(builder);
      AddProjected(builder, builder.Place(), builder.lattice().RoundToPrecision(w));
    }
    builder.AddTriangle(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return builder.Done(Finish::kAnyOrder);
}

}  // namespace

static Case ClosedMesh(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Surface surface = DrawSurface(bits);
  for (std::int32_t v = 0; v < surface.vertices; ++v) builder.Add(builder.Place());
  AddTriangles(builder, surface);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kClosedMeshDomain{
    .number = 37,
    .bits = 0x5eb09dd8a82086f0,
    .name = "closed-mesh",
    .summary = "a closed surface folded flat: front minus back is zero everywhere",
    .theme = DomainTheme::kMeshes,
    .mesh = true,
    .overlaps = true,
    .draw = ClosedMesh};

static Case ClosedAroundEye(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const Surface surface = DrawSurface(bits);
  // Window = focal * (x, y) / depth + centre of the target: x and y of clip space carry both.
  const double focal = std::ldexp(1.0, static_cast<int>(bits.Int(1, 5)));
  const bool around = bits.Chance(160);
  for (std::int32_t v = 0; v < surface.vertices; ++v) {
    std::array<double, 3> p{builder.Uniform(-1, 1), builder.Uniform(-1, 1), builder.Uniform(-1, 1)};
    if (around) {
      const std::array<double, 3> outward = AroundOrigin(v, surface);
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = outward[axis] + 0.5 * p[axis];
    }
    const double w = bits.Chance(16) ? 0.0 : builder.lattice().RoundToPrecision(p[2]);
    builder.AddRaw(
        {focal * p[0] + w * builder.width() / 2, focal * p[1] + w * builder.height() / 2, 0, w});
  }
  AddTriangles(builder, surface);
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kClosedAroundEyeDomain{
    .number = 96,
    .bits = 0x2dca34b871b0039a,
    .listed = 411,
    .name = "closed-around-eye",
    .summary = "a closed surface around the eye, or cut by the plane of the eye",
    .theme = DomainTheme::kClip,
    .clip = true,
    .mesh = true,
    .draw = ClosedAroundEye};

static Case MeshesAroundEye(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const Surface surface = Bipyramid(static_cast<std::int32_t>(bits.Int(3, 8)));
  const double focal = std::ldexp(1.0, static_cast<int>(bits.Int(1, 5)));
  // Turned about the upright axis, and each vertex as far away as it likes: seen from the origin,
  // every triangle faces the same way and none hides another.
  const double turn = builder.Uniform(0, 2);
  const double c = CosPi(turn);
  const double s = SinPi(turn);
  for (std::int32_t v = 0; v < surface.vertices; ++v) {
    const std::array<double, 3> p = AroundOrigin(v, surface);
    const double distance = std::fabs(builder.LogUniform(-2, 3));
    const double x = distance * (c * p[0] - s * p[2]);
    const double depth = distance * (s * p[0] + c * p[2]);
    const double w = builder.lattice().RoundToFloat(depth);
    builder.AddRaw({focal * x + w * builder.width() / 2,
                    focal * distance * p[1] + w * builder.height() / 2, 0, w});
  }
  // Some are left out: the mesh then has an outline, which may pass behind the eye.
  const bool is_open = bits.Chance(96);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& v = surface.triangles[t];
    if (t == 0 || !is_open || !bits.Chance(64)) builder.AddTriangle(v[0], v[1], v[2]);
  }
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kMeshesAroundEyeDomain{
    .number = 97,
    .bits = 0xaa883c3ecb1f2a70,
    .listed = 662,
    .name = "meshes-around-eye",
    .summary = "closed around the eye, or open, and no triangle hides another",
    .theme = DomainTheme::kClip,
    .clip = true,
    .mesh = true,
    .draw = MeshesAroundEye};

static Case Perspective(BitSource& bits, const SubjectInfo& info) {
  return ClipTriangles(bits, info, [](CaseBuilder& builder) {
    // Powers of two keep the window place exact: ties stay ties.
    if (!builder.bits().Chance(128)) return std::fabs(builder.LogUniform(-4, 4));
    return std::ldexp(1.0, static_cast<int>(builder.bits().Int(-4, 4)));
  });
}

extern constinit const Domain kPerspectiveDomain{.number = 40,
                                                 .bits = 0x52c48773dd390dbd,
                                                 .name = "perspective",
                                                 .summary = "clip space, every w positive",
                                                 .theme = DomainTheme::kClip,
                                                 .clip = true,
                                                 .draw = Perspective};

static Case MixedW(BitSource& bits, const SubjectInfo& info) {
  return ClipTriangles(bits, info, [](CaseBuilder& builder) {
    return builder.bits().Chance(96) ? 1.0 : DrawMixedW(builder);
  });
}

extern constinit const Domain kMixedWDomain{
    .number = 41,
    .bits = 0xcb0e8109c5b814c3,
    .name = "mixed-w",
    .summary = "w -> 0, w == 0, and both signs of w in one triangle",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = MixedW};

static Case OneVertexBehind(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const auto triangles = static_cast<std::int32_t>(bits.Int(1, 2));
  for (std::int32_t t = 0; t < triangles; ++t) {
    const std::int64_t behind = bits.Int(0, 2);
    for (std::int64_t k = 0; k < 3; ++k) {
      const double w = bits.Chance(128) ? std::ldexp(1.0, static_cast<int>(bits.Int(-3, 3)))
                                        : std::fabs(builder.LogUniform(-4, 3));
      AddProjected(builder, builder.Place(),
                   builder.lattice().RoundToPrecision(k == behind ? -w : w));
    }
    builder.AddTriangle(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kOneVertexBehindDomain{
    .number = 65,
    .bits = 0xdd2aa0a9c694445e,
    .name = "one-vertex-behind",
    .summary = "one vertex of a triangle behind the eye, two in front",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = OneVertexBehind};

static Case HardestRays(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.UseClipSpace();
  const auto add = [&](const Ray& v) {
    const double scale = std::ldexp(1.0, -static_cast<int>(bits.Int(0, 24)));
    return builder.AddRaw({static_cast<double>(v.x) * scale, static_cast<double>(v.y) * scale, 0,
                           static_cast<double>(v.w) * scale});
  };
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 sample = builder.Sample();
    const HardRays rays = DrawHardestRays(bits, sample, builder.lattice().digits() - 1);
    const std::int32_t a = add(rays.a);
    const std::int32_t b = add(rays.b);
    const double w = std::fabs(builder.LogUniform(-4, 3));
    AddProjected(builder, builder.Place(), builder.lattice().RoundToPrecision(w));
    builder.AddTriangle(a, b, b + 1);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kHardestRaysDomain{
    .number = 66,
    .bits = 0xf016da7c25b1ac56,
    .name = "hardest-rays",
    .summary = "clip-space edges whose value at a sample is the smallest that is not zero",
    .theme = DomainTheme::kClip,
    .clip = true,
    .draw = HardestRays};

}  // namespace rasterproof::props
