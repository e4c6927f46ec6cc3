// The kernel of clip space on every domain, sink and instruction set, against the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/rational.h"
#include "library/kernels/clip_errors.h"
#include "library/kernels/kernel.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/library/clip_scenes.h"
#include "tests/props/faulty_subjects.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::library::kernels {
namespace {

OwnedClipScene OwnedOf(const Scene& scene) {
  OwnedClipScene owned;
  owned.width = scene.width;
  owned.height = scene.height;
  for (const Vertex& v : scene.vertices) {
    owned.vertices.push_back({static_cast<float>(v.x), static_cast<float>(v.y),
                              static_cast<float>(v.z), static_cast<float>(v.w)});
  }
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) owned.indices.push_back(static_cast<std::uint32_t>(index));
  }
  return owned;
}

Scene SceneOf(const OwnedClipScene& owned) {
  Scene scene;
  scene.width = owned.width;
  scene.height = owned.height;
  scene.clip_space = true;
  for (const ClipVertex& v : owned.vertices) scene.vertices.push_back({v.x, v.y, v.z, v.w});
  for (std::size_t k = 0; k + 2 < owned.indices.size(); k += 3) {
    const auto index = [&](std::size_t i) { return static_cast<std::int32_t>(owned.indices[i]); };
    scene.triangles.push_back({index(k), index(k + 1), index(k + 2)});
  }
  return scene;
}

void ExpectCounts(const Surface& surface, const CoverageCounts& expected, const std::string& name) {
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::size_t k = expected.Index(x, y, 0);
      const std::uint64_t counts = expected.front[k] | std::uint64_t{expected.back[k]} << 32;
      ASSERT_EQ(surface.At(x, y), counts) << name << " (" << x << ", " << y << ")";
    }
  }
}

void ExpectExact(const OwnedClipScene& owned, const std::string& name) {
  const CoverageCounts expected = exact::Coverage(SceneOf(owned), Profile{});
  for (const Target target : SupportedTargets()) {
    Surface surface(Sink::kFacing, owned.width, owned.height);
    DrawClip(target, owned.View(), surface);
    ExpectCounts(surface, expected, name + " " + std::string(NameOf(target)));
  }
}

TEST(ClipKernel, EqualsTheOracleOnEveryDomain) {
  SubjectInfo info = props::testing::RealInfo();
  info.takes_window = false;
  info.takes_clip = true;
  for (const props::Domain& domain : props::Domains()) {
    for (int i = 0; i < Cases(RunsMore() ? 2000 : 40); ++i) {
      props::PhiloxSource bits(1, static_cast<std::uint64_t>(i));
      const Case c = domain.draw(bits, info);
      if (!c.scene.clip_space || c.scene.precision != Precision::kFloat32) continue;
      if (static_cast<std::int64_t>(c.scene.width) * c.scene.height > 1 << 16) continue;
      ExpectExact(OwnedOf(c.scene), std::string(domain.name) + ":" + std::to_string(i));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ClipKernel, EqualsTheOracleOnEveryKindOfW) {
  for (int i = 0; i < Cases(RunsMore() ? 20'000 : 300); ++i) {
    const int side = i % 7 == 0 ? 75 : 13;
    ExpectExact(RandomClipScene(static_cast<std::uint64_t>(i), side, 1 + i % 37),
                "seed " + std::to_string(i));
    if (HasFatalFailure()) return;
  }
}

// Small ones, near ones and those in steps of fixed point.
TEST(ClipKernel, EqualsTheOracleBeforeTheEye) {
  for (int i = 0; i < Cases(RunsMore() ? 100'000 : 4000); ++i) {
    const int side = i % 20 == 0 ? 170 : i % 4 == 0 ? 63 : 8;
    ExpectExact(ScenesBeforeTheEye(static_cast<std::uint64_t>(i), side, 1 + i % 33),
                "seed " + std::to_string(i));
    if (HasFatalFailure()) return;
  }
}

TEST(ClipKernel, DrawsNothingOfWhatIsNotFinite) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  for (const float bad : {kInf, -kInf, std::nanf("")}) {
    for (int k = 0; k < 12; ++k) {
      OwnedClipScene owned;
      owned.width = owned.height = 8;
      owned.vertices = {{0, 0, 0, 1}, {8, 0, 0, 1}, {0, 8, 0, 1}};
      owned.indices = {0, 1, 2};
      const std::array members{&ClipVertex::x, &ClipVertex::y, &ClipVertex::w, &ClipVertex::z};
      owned.vertices[static_cast<std::size_t>(k % 3)].*members[static_cast<std::size_t>(k / 3)] =
          bad;
      const bool is_z = k >= 9;
      for (const NearPlane near_plane : {NearPlane::kNone, NearPlane::kZero, NearPlane::kMinusW}) {
        owned.near_plane = near_plane;
        for (const Target target : SupportedTargets()) {
          Surface mask(Sink::kMask, 8, 8);
          DrawClip(target, owned.View(), mask);
          EXPECT_EQ(mask.At(1, 1), is_z && near_plane == NearPlane::kNone ? 1U : 0U);
          Surface depth(Sink::kDepth, 8, 8);
          DrawClip(target, owned.View(), depth);
          EXPECT_EQ(depth.At(1, 1), std::bit_cast<std::uint32_t>(kInf));
        }
      }
    }
  }
}

// z / w beyond what float32 holds, before and behind.
TEST(ClipKernel, DepthsEndAtTheLargestNumber) {
  constexpr float kMost = std::numeric_limits<float>::max();
  OwnedClipScene owned;
  owned.width = owned.height = 8;
  owned.indices = {0, 1, 2};
  for (const float z : {1e30F, -1e30F}) {
    owned.vertices = {{0, 0, z, 1e-20F}, {8e-20F, 0, z, 1e-20F}, {0, 8e-20F, z, 1e-20F}};
    for (const Target target : SupportedTargets()) {
      Surface depth(Sink::kDepth, 8, 8);
      DrawClip(target, owned.View(), depth);
      EXPECT_EQ(depth.At(1, 1), std::bit_cast<std::uint32_t>(std::copysign(kMost, z)));
    }
  }
}

TEST(ClipKernel, DrawsNothingOfNoTriangles) {
  const OwnedClipScene owned;
  for (const Target target : SupportedTargets()) {
    Surface mask(Sink::kMask, 1, 1);
    DrawClip(target, owned.View(), mask);
    EXPECT_EQ(mask.At(0, 0), 0U);
  }
}

TEST(ClipKernel, LeavesDepthsWhereAVertexHasNone) {
  OwnedClipScene owned;
  owned.width = owned.height = 8;
  constexpr float kInf = std::numeric_limits<float>::infinity();
  // The edge opposite the corner with that z has a normal of positive components.
  owned.vertices = {{20, 20, -kInf, 1}, {-9, 8, 0, 1}, {8, -9, 0, 1}};
  for (const std::vector<std::uint32_t>& turn : {std::vector<std::uint32_t>{0, 1, 2}, {0, 2, 1}}) {
    owned.indices = turn;
    for (const Target target : SupportedTargets()) {
      Surface depth(Sink::kDepth, 8, 8);
      DrawClip(target, owned.View(), depth);
      for (int x = 0; x < 8; ++x) EXPECT_EQ(depth.At(x, 4), std::bit_cast<std::uint32_t>(kInf));
    }
  }
}

// Triangle by triangle: the kernel's own coverage without a near plane, which the tests above hold
// against the oracle, where the plane's side is right.
TEST(ClipKernel, NearPlaneIsOneMoreEdge) {
  std::int64_t kept = 0;
  std::int64_t cut = 0;
  std::int64_t on_plane = 0;
  for (int i = 0; i < Cases(RunsMore() ? 2000 : 60); ++i) {
    OwnedClipScene owned =
        RandomClipScene(1000 + static_cast<std::uint64_t>(i), i % 9 == 0 ? 60 : 13, 16);
    for (std::size_t t = 0; t < owned.indices.size() / 3; ++t) {
      const auto corners = owned.Corners(t);
      owned.near_plane = NearPlane::kNone;
      Surface whole(Sink::kFacing, owned.width, owned.height);
      DrawClip(Target::kScalar, owned.Only(t), whole);
      for (const NearPlane near_plane : {NearPlane::kZero, NearPlane::kMinusW}) {
        std::array<Rational, 3> n = Depths(corners);
        for (std::size_t k = 0; near_plane == NearPlane::kMinusW && k < 3; ++k) {
          n[k] += Rational(corners[k].w);
        }
        const Affine side(corners, n);
        owned.near_plane = near_plane;
        for (const Target target : SupportedTargets()) {
          Surface near(Sink::kFacing, owned.width, owned.height);
          DrawClip(target, owned.Only(t), near);
          for (int y = 0; y < owned.height; ++y) {
            for (int x = 0; x < owned.width; ++x) {
              const std::uint64_t covered = whole.At(x, y);
              const int sign = covered == 0 ? 0 : side.At(x, y).Sign();
              ASSERT_EQ(near.At(x, y), sign < 0 ? 0 : covered)
                  << NameOf(target) << " seed " << 1000 + i << " triangle " << t << " (" << x
                  << ", " << y << ")";
              if (covered != 0) ++(sign < 0 ? cut : sign > 0 ? kept : on_plane);
            }
          }
        }
      }
    }
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(cut, 1000);
  EXPECT_GT(on_plane, 20);
}

// Counts, bits, ids and depths are those of the triangles drawn one by one.
TEST(ClipKernel, EverySinkAndTargetKeepsTheSame) {
  for (int i = 0; i < Cases(60); ++i) {
    OwnedClipScene owned = RandomClipScene(2000 + static_cast<std::uint64_t>(i), 70, 35);
    owned.near_plane = static_cast<NearPlane>(i % 3);
    Surface depth(Sink::kDepth, owned.width, owned.height);
    DrawClip(Target::kScalar, owned.View(), depth);
    std::vector<std::uint64_t> counts(static_cast<std::size_t>(owned.width * owned.height));
    std::vector<std::uint64_t> ids(counts.size(), Surface::kNoTriangle);
    for (std::size_t t = 0; t < owned.indices.size() / 3; ++t) {
      Surface one(Sink::kFacing, owned.width, owned.height);
      DrawClip(Target::kScalar, owned.Only(t), one);
      for (std::size_t k = 0; k < counts.size(); ++k) {
        const auto x = static_cast<int>(k) % owned.width;
        const auto y = static_cast<int>(k) / owned.width;
        if (one.At(x, y) == 0) continue;
        ++counts[k];
        ids[k] = t;
      }
    }
    for (const Target target : SupportedTargets()) {
      for (const Sink sink : {Sink::kCount8, Sink::kMask, Sink::kId, Sink::kDepth}) {
        Surface surface(sink, owned.width, owned.height);
        DrawClip(target, owned.View(), surface);
        for (std::size_t k = 0; k < counts.size(); ++k) {
          const auto x = static_cast<int>(k) % owned.width;
          const auto y = static_cast<int>(k) / owned.width;
          const std::uint64_t expected = sink == Sink::kCount8 ? counts[k]
                                         : sink == Sink::kMask ? std::uint64_t{counts[k] > 0}
                                         : sink == Sink::kId   ? ids[k]
                                                               : depth.At(x, y);
          ASSERT_EQ(surface.At(x, y), expected)
              << NameOf(target) << " " << NameOf(sink) << " seed " << 2000 + i;
        }
      }
    }
  }
}

// The bound of kClipDepthError, in double from its definition.
double DepthBound(const std::array<ClipVertex, 3>& v, double z, int x, int y) {
  const auto normal = [&](std::size_t i, std::size_t j) {
    return std::array{double{v[j].y} * v[i].w - double{v[j].w} * v[i].y,
                      double{v[j].w} * v[i].x - double{v[j].x} * v[i].w,
                      double{v[j].x} * v[i].y - double{v[j].y} * v[i].x};
  };
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = normal((k + 1) % 3, (k + 2) % 3);
    reach += std::fabs(v[k].z) *
             (std::fabs(n[0]) * (x + 0.5) + std::fabs(n[1]) * (y + 0.5) + std::fabs(n[2]));
  }
  const auto n = normal(1, 2);
  const double sizes =
      std::fabs(n[0] * v[0].x) + std::fabs(n[1] * v[0].y) + std::fabs(n[2] * v[0].w);
  const Affine exact(v, Depths(v));
  const double determinant = std::fabs(exact.area.ToDouble());
  return 0x1p-24 * std::fabs(z) + 0x1p-150 +
         kClipDepthError * (reach + std::fabs(z) * sizes) / determinant;
}

// The largest error of a scene's depths over their bound, triangle by triangle.
struct DepthErrors {
  double worst = 0;
  double worst_beyond_rounding = 0;
  std::int64_t samples = 0;

  void Measure(const OwnedClipScene& owned) {
    for (std::size_t t = 0; t < owned.indices.size() / 3; ++t) {
      Surface depth(Sink::kDepth, owned.width, owned.height);
      DrawClip(SupportedTargets().back(), owned.Only(t), depth);
      const auto corners = owned.Corners(t);
      const Affine exact(corners, Depths(corners));
      for (int y = 0; y < owned.height; ++y) {
        for (int x = 0; x < owned.width; ++x) {
          const auto z = std::bit_cast<float>(static_cast<std::uint32_t>(depth.At(x, y)));
          if (std::isfinite(z)) Add(z, exact.At(x, y), corners, x, y);
        }
      }
    }
  }

  void Add(float z, const Rational& exact, const std::array<ClipVertex, 3>& v, int x, int y) {
    constexpr double kMost = std::numeric_limits<float>::max();
    if (exact.Abs() > Rational(kMost)) {
      EXPECT_EQ(std::fabs(z), kMost);
      return;
    }
    ++samples;
    const double error = (Rational(z) - exact).Abs().ToDouble();
    const double bound = DepthBound(v, exact.ToDouble(), x, y);
    const double rounding = 0x1p-24 * std::fabs(exact.ToDouble()) + 0x1p-150;
    worst = std::max(worst, error / bound);
    worst_beyond_rounding =
        std::max(worst_beyond_rounding, (error - rounding) / (bound - rounding));
  }
};

TEST(ClipKernel, DepthsStayWithinTheirBound) {
  DepthErrors any;
  for (int i = 0; i < Cases(RunsMore() ? 4000 : 150); ++i) {
    any.Measure(RandomClipScene(3000 + static_cast<std::uint64_t>(i), 13, 8));
  }
  reference::RandomValues random(12);
  DepthErrors slivers;
  const int count = RunsMore() ? 200 : kOneCaseIn > 1 ? 4 : 12;
  for (int i = 0; i < count; ++i) slivers.Measure(Slivers(random));
  std::cout << "largest error / bound of " << any.samples << " depths: " << any.worst
            << ", beyond the last rounding " << any.worst_beyond_rounding << "; of "
            << slivers.samples << " on slivers: " << slivers.worst << '\n';
  EXPECT_LE(any.worst, 1);
  EXPECT_LE(slivers.worst, 1);
  EXPECT_GT(any.samples, 1000);
  EXPECT_GT(slivers.samples, 10);
  EXPECT_GT(any.worst, 0.5) << "the search looks where there is no error";
}

// With the other facing the sample would not be theirs.
TEST(ClipKernel, FacingIsExactWhereRoundingLosesIt) {
  reference::RandomValues random(11);
  std::int64_t covered = 0;
  for (int i = 0; i < Cases(200); ++i) {
    const OwnedClipScene owned = Slivers(random);
    if (owned.indices.empty()) continue;
    ExpectExact(owned, "sliver " + std::to_string(i));
    if (HasFatalFailure()) return;
    const CoverageCounts counts = exact::Coverage(SceneOf(owned), Profile{});
    for (std::size_t k = 0; k < counts.size(); ++k) covered += counts.Count(k);
  }
  EXPECT_GT(covered, Cases(100));
}

// Where every w is 1 it is the exact kernel of window space.
TEST(ClipKernel, EqualsTheExactKernelWhereEveryWIsOne) {
  reference::RandomValues random(7);
  for (int i = 0; i < Cases(40); ++i) {
    OwnedClipScene owned;
    std::vector<KernelVertex> vertices;
    owned.width = 90;
    owned.height = 40;
    for (int k = 0; k < 3 * 50; ++k) {
      const auto x = static_cast<float>(random.Integer(-8 * 20, 8 * 110)) * 0.125F;
      const auto y = static_cast<float>(random.Integer(-8 * 20, 8 * 60)) * 0.125F;
      owned.vertices.push_back({x, y, 0, 1});
      vertices.push_back({x, y, 0});
      owned.indices.push_back(static_cast<std::uint32_t>(k));
    }
    Surface window(Sink::kFacing, owned.width, owned.height);
    Draw(Target::kScalar, {vertices, owned.indices, owned.width, owned.height}, window);
    for (const Target target : SupportedTargets()) {
      Surface clip(Sink::kFacing, owned.width, owned.height);
      DrawClip(target, owned.View(), clip);
      for (int y = 0; y < owned.height; ++y) {
        for (int x = 0; x < owned.width; ++x) ASSERT_EQ(clip.At(x, y), window.At(x, y));
      }
    }
  }
}

TEST(ClipKernel, RefusesASurfaceOfAnotherSize) {
  Surface surface(Sink::kMask, 8, 8);
  ClipScene scene;
  scene.width = 9;
  scene.height = 8;
  EXPECT_THROW(DrawClip(Target::kScalar, scene, surface), InputError);
}

}  // namespace
}  // namespace rasterproof::library::kernels
