// Bugs of rasterizers without a subpixel grid, and of those that take clip space.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "library/exact_sign.h"
#include "reference/homogeneous.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

template <class T>
int SignOf(T e) {
  return (e > 0) - (e < 0);
}

// The direct form, every operation rounded once to T.
template <class T>
T Direct(Point2 a, Point2 b, Point2 p) {
  const T dx = static_cast<T>(b.x) - static_cast<T>(a.x);
  const T dy = static_cast<T>(b.y) - static_cast<T>(a.y);
  return (static_cast<T>(p.x) - static_cast<T>(a.x)) * dy -
         (static_cast<T>(p.y) - static_cast<T>(a.y)) * dx;
}

// The same as compilers contract it: fma(-c, d, a b).
float Contracted(Point2 a, Point2 b, Point2 p) {
  const auto f = [](double x) { return static_cast<float>(x); };
  const float dx = f(b.x) - f(a.x);
  const float dy = f(b.y) - f(a.y);
  return std::fma(-(f(p.y) - f(a.y)), dx, (f(p.x) - f(a.x)) * dy);
}

// The exact sign where |E| is within `band` roundings of the products' size, else that of `form`.
template <class T>
int FilteredSign(T e, T size, T band, Point2 a, Point2 b, Point2 p) {
  return std::fabs(e) > band * size ? SignOf(e) : library::EdgeSign(a, b, p);
}

template <class T>
T SizeOf(Point2 a, Point2 b, Point2 p) {
  return static_cast<T>(std::fabs((p.x - a.x) * (b.y - a.y)) +
                        std::fabs((p.y - a.y) * (b.x - a.x)));
}

// The filter of float32, each edge's band by the first of its samples.
int SignByFirstBand(Point2 a, Point2 b, Point2 p) {
  struct Band {
    Point2 a;
    Point2 b;
    float size = 0;
  };
  thread_local std::array<Band, 3> bands;
  thread_local std::size_t oldest = 0;
  const auto known = std::ranges::find_if(bands, [&](const Band& band) {
    return band.a.x == a.x && band.a.y == a.y && band.b.x == b.x && band.b.y == b.y;
  });
  const bool is_known = known != bands.end();
  Band& band = is_known ? *known : bands[oldest];
  if (!is_known) {
    band = {a, b, SizeOf<float>(a, b, p)};
    oldest = (oldest + 1) % 3;
  }
  const auto e = Direct<float>(a, b, p);
  if (!std::isfinite(e) || std::fabs(e) < 0x1p-100F) return library::EdgeSign(a, b, p);
  return FilteredSign<float>(e, band.size, 0x1p-21F, a, b, p);
}

std::vector<Mutant> Signs() {
  return {
      {"real-float32", "signs are those of the direct form in float32", "",
       Signing([](Point2 a, Point2 b, Point2 p) { return SignOf(Direct<float>(a, b, p)); }),
       "float-edges"},
      {"real-float64", "signs are those of the direct form in float64", "",
       Signing([](Point2 a, Point2 b, Point2 p) { return SignOf(Direct<double>(a, b, p)); }),
       "float-edges"},
      {"real-contracted", "the direct form in float32 is contracted to one fma", "DRTK #9",
       Signing([](Point2 a, Point2 b, Point2 p) { return SignOf(Contracted(a, b, p)); }),
       "float-edges"},
      {"real-contracted-one-side", "edges that rise are contracted, the others are exact",
       "contraction in one of two functions that should agree",
       Signing([](Point2 a, Point2 b, Point2 p) {
         return b.y < a.y ? SignOf(Contracted(a, b, p)) : library::EdgeSign(a, b, p);
       })},
      {"real-filter-too-narrow", "the float32 filter's band is half a rounding wide", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         return FilteredSign<float>(Direct<float>(a, b, p), SizeOf<float>(a, b, p), 0x1p-25F, a, b,
                                    p);
       })},
      {"real-filter-band-kept", "the float32 filter keeps an edge's band from its first sample", "",
       [] {
         RealStages stages = Signing(SignByFirstBand);
         stages.area = {};
         return stages;
       }()},
      {"real-filter-relative", "the filter is relative to the value, not to its products", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         const double e = Direct<double>(a, b, p);
         return FilteredSign<double>(e, std::fabs(e), 0x1p-20, a, b, p);
       })},
      {"real-epsilon", "edge values within 10^-6 of zero count as zero", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         return std::fabs(Direct<double>(a, b, p)) < 1e-6 ? 0 : library::EdgeSign(a, b, p);
       }),
       "edge-precision"},
      {"real-underflow", "a product that underflows counts as zero", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         const auto tiny = [](double x) { return std::fabs(x) < 0x1p-126; };
         const bool lost = tiny((p.x - a.x) * (b.y - a.y)) && tiny((p.y - a.y) * (b.x - a.x));
         return lost ? 0 : library::EdgeSign(a, b, p);
       })},
      {"real-overflow", "an edge value that overflows float32 counts as outside", "xemu #2510",
       Signing([](Point2 a, Point2 b, Point2 p) {
         return std::isfinite(Direct<float>(a, b, p)) ? library::EdgeSign(a, b, p) : -1;
       })},
      {"real-differences-rounded", "exact products of differences that were rounded to float32", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         const auto f = [](double x) { return double{static_cast<float>(x)}; };
         const double ab = f(p.x - a.x) * f(b.y - a.y);
         const double cd = f(p.y - a.y) * f(b.x - a.x);
         return SignOf(ab - cd);
       }),
       "float-edges"},
  };
}

std::vector<Mutant> SetUps() {
  return {
      {"real-facing-float32", "facing is that of the area in float32", "SwiftShader eeb8184",
       RealStages{
           {.area = [](const Points& v) { return SignOf(Direct<float>(v[0], v[1], v[2])); }}},
       "facing-arithmetic"},
      {"real-flushes-subnormals", "subnormal coordinates are flushed to zero", "FTZ and DAZ",
       RealStages{{.place =
                       [](Point2& p, const Scene&) {
                         const auto flushed = [](double x) {
                           return std::fabs(x) < 0x1p-126 ? 0.0 : x;
                         };
                         p = {flushed(p.x), flushed(p.y)};
                       }}},
       "subnormals"},
      {"real-drops-far", "a triangle with a vertex beyond 2^24 pixels is dropped", "",
       RealStages{{.leaves_out =
                       [](const PointStages::Placed& t, const Scene&) {
                         return std::ranges::any_of(t.v, [](Point2 p) {
                           return std::fabs(p.x) > 0x1p24 || std::fabs(p.y) > 0x1p24;
                         });
                       }}},
       "lost-triangles"},
      {"real-snaps", "vertices are snapped though the profile has no grid", "",
       RealStages{{.place =
                       [](Point2& p, const Scene&) {
                         const auto snapped = [](double x) {
                           return std::fabs(x) < 0x1p40 ? std::nearbyint(x * 65536) / 65536 : x;
                         };
                         p = {snapped(p.x), snapped(p.y)};
                       }}},
       "subpixel-bits"},
      {"real-denominator", "triangles of less area than 10^-8 are dropped", "pytorch3d #508",
       RealStages{{.leaves_out =
                       [](const PointStages::Placed& t, const Scene&) {
                         return std::fabs(Direct<double>(t.v[0], t.v[1], t.v[2])) < 1e-8;
                       }}},
       "lost-triangles"},
  };
}

ClipStages Becoming(std::vector<ClipTriangle> (*becomes)(const ClipTriangle&)) {
  return {{.clip = becomes}};
}
bool AnyBehind(const ClipTriangle& v) {
  return std::ranges::any_of(v, [](const Vertex& p) { return p.w <= 0; });
}
double DeterminantInDouble(const ClipTriangle& v) {
  return v[0].x * (v[1].y * v[2].w - v[1].w * v[2].y) -
         v[0].y * (v[1].x * v[2].w - v[1].w * v[2].x) +
         v[0].w * (v[1].x * v[2].y - v[1].y * v[2].x);
}
// The triangle with every vertex changed.
ClipTriangle Each(ClipTriangle v, void (*change)(Vertex&)) {
  std::ranges::for_each(v, change);
  return v;
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> RealClips() {
  return {
      {"clip-drops-behind", "a triangle with a vertex behind the eye is dropped", "",
       Becoming([](const ClipTriangle& v) {
         return AnyBehind(v) ? std::vector<ClipTriangle>{} : std::vector<ClipTriangle>{v};
       }),
       "clip-space", "ClipSpaceCoverageEqualsTheModel|ClosedSurfaceAroundTheEyeIsSeenEquallyOften"},
      {"clip-drops-by-first", "a triangle whose first vertex is behind the eye is dropped",
       "nvdiffrast #225", Becoming([](const ClipTriangle& v) {
         return v[0].w <= 0 ? std::vector<ClipTriangle>{} : std::vector<ClipTriangle>{v};
       }),
       "clip-space", "NeighboursAreClippedAlike"},
      {"clip-w-clamped", "w is clamped to 2^-10 from below", "",
       Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{Each(v, [](Vertex& p) { p.w = std::max(p.w, 0x1p-10); })};
       }),
       "clip-space", "ScalingClipVerticesKeepsCoverage"},
      {"clip-w-ignored", "vertices are not divided by w", "", Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{Each(v, [](Vertex& p) { p.w = 1; })};
       }),
       "clip-space", "LiftedTrianglesCoverLikeProjectedOnes"},
      {"clip-w-absolute", "the absolute value of w is taken", "",
       Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{Each(v, [](Vertex& p) { p.w = std::fabs(p.w); })};
       }),
       "clip-space"},
      {"clip-divides", "vertices in front of the eye are divided by w in float32", "",
       Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{Each(v, [](Vertex& p) {
           if (!(p.w > 0)) return;
           const auto f = [](double x) { return static_cast<float>(x); };
           p = {f(p.x) / f(p.w), f(p.y) / f(p.w), p.z, 1};
         })};
       }),
       "clip-space"},
      {"clip-mirror-image", "what lies behind the eye is drawn upside down as well", "",
       Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{v,
                                          Each(v, [](Vertex& p) { p = {-p.x, -p.y, p.z, -p.w}; })};
       }),
       "clip-space"},
      {"clip-near-eye", "a triangle with a w within 2^-20 of zero is dropped",
       "SwiftShader eeb8184", Becoming([](const ClipTriangle& v) {
         const bool near = std::ranges::any_of(
             v, [](const Vertex& p) { return std::fabs(p.w) < 0x1p-20 && p.w != 0; });
         return near ? std::vector<ClipTriangle>{} : std::vector<ClipTriangle>{v};
       }),
       "clip-space"},
      {"clip-reciprocal-overflows", "a triangle with a w whose reciprocal overflows is dropped", "",
       Becoming([](const ClipTriangle& v) {
         const bool overflows = std::ranges::any_of(v, [](const Vertex& p) {
           return p.w != 0 && std::isinf(1 / static_cast<float>(p.w));
         });
         return overflows ? std::vector<ClipTriangle>{} : std::vector<ClipTriangle>{v};
       }),
       "clip-space", "ClipSpaceCoverageEqualsTheModel"},
      {"clip-zero-w", "w = 0 is taken for 1", "", Becoming([](const ClipTriangle& v) {
         return std::vector<ClipTriangle>{Each(v, [](Vertex& p) { p.w = p.w == 0 ? 1 : p.w; })};
       }),
       "clip-space"},
      {"clip-facing-projected", "facing is that of the projected vertices", "",
       ClipStages{{.turns_over =
                       [](const ClipTriangle& v) {
                         return std::ranges::count_if(v, [](const Vertex& p) { return p.w < 0; }) %
                                    2 ==
                                1;
                       }}},
       "clip-space"},
      {"clip-facing-float64", "facing is the sign of the determinant in float64", "",
       ClipStages{{.turns_over =
                       [](const ClipTriangle& v) {
                         return (DeterminantInDouble(v) < 0) !=
                                (reference::ExactHomogeneousFacing(v[0], v[1], v[2]) > 0);
                       }}},
       "clip-space"},
  };
}

std::vector<Mutant> RealMutants() {
  std::vector<Mutant> table = Signs();
  for (Mutant& planted : SetUps()) table.push_back(std::move(planted));
  for (Mutant& planted : RealClips()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kRealMutants{MutantKind::kPlanted, 8, RealMutants};

}  // namespace rasterproof::subjects::mutants
