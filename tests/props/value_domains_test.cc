// Two deciders of interpolated values on triangles of every domain, w <= 0 included: the oracle's,
// and planes by elimination.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/channel.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "exact/values.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/judging/values/value_channels.h"
#include "props/run/property_domains.h"
#include "tests/exact/naive_values.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kValueSeed = 21;
// Of a mesh, these many of its triangles, spread over it.
constexpr std::size_t kTrianglesOfACase = 4;

// A subject of each profile, precision and space, so that every domain suits some of them.
std::vector<SubjectInfo> SubjectsOfAllKinds() {
  std::vector<SubjectInfo> all;
  for (const std::string_view name : {"real", "gl-canonical", "d3d11", "vulkan", "webgpu"}) {
    for (const Precision input : {Precision::kFloat32, Precision::kFloat64}) {
      for (const bool clip : {false, true}) {
        SubjectInfo info;
        info.profile = *PresetProfile(name);
        info.profile.values.flat = info.profile.values.linear = true;
        info.profile.values.inverse_w = true;
        info.input = input;
        info.takes_window = !clip;
        info.takes_clip = clip;
        all.push_back(info);
      }
    }
  }
  return all;
}

struct Compared {
  std::uint64_t numbers = 0;
  std::uint64_t behind = 0;   // of them, of triangles with a w <= 0
  std::uint64_t nothing = 0;  // no value: on a horizon, or no area
};

// The pixel's centre under the middle of the triangle, an own corner, and the middle of a side.
std::array<Point2, 3> Places(const std::array<Vertex, 3>& v) {
  std::array<Point2, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = {v[i].x / v[i].w, v[i].y / v[i].w};
    if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y)) corners[i] = {0.5, 0.5};
  }
  const Point2 middle{corners[0].x / 3 + corners[1].x / 3 + corners[2].x / 3,
                      corners[0].y / 3 + corners[1].y / 3 + corners[2].y / 3};
  return {{{std::floor(middle.x) + 0.5, std::floor(middle.y) + 0.5},
           corners[0],
           {corners[1].x / 2 + corners[2].x / 2, corners[1].y / 2 + corners[2].y / 2}}};
}

// Returns where the two differ, or nothing.
std::string CompareTriangle(const Scene& scene, const Triangle& t,
                            std::span<const Channel> channels, std::size_t nth, Compared& all) {
  const std::array<Vertex, 3> v = Corners(scene, t);
  if (!std::ranges::all_of(v, IsFinite)) return {};
  const bool is_behind = std::ranges::any_of(v, [](const Vertex& at) { return at.w <= 0; });
  const exact::NaiveRows rows = exact::NaiveRowsOf(v);
  const Point2 p = Places(v)[nth % 3];
  const exact::Interpolant interpolant(exact::ClipTriangle(v), p);
  for (const Channel& channel : channels) {
    if (channel.interpolation == Interpolation::kFlat) continue;
    std::array<double, 3> a{1, 1, 1};
    for (std::size_t i = 0; i < 3 && !channel.values.empty(); ++i) {
      a[i] = channel.values[static_cast<std::size_t>(t[i])];
    }
    const auto exact = interpolant.Derivatives(channel.interpolation, exact::ToAttribute(a));
    const auto naive = exact::NaiveValueAt(rows, channel.interpolation,
                                           {mpq_class(a[0]), mpq_class(a[1]), mpq_class(a[2])}, p);
    if (exact.has_value() != naive.has_value()) return channel.name + ": one has no value";
    if (!exact) {
      ++all.nothing;
      continue;
    }
    if (!exact::Equal(*exact, *naive)) return channel.name + ": the values differ";
    all.numbers += 3;
    if (is_behind) all.behind += 3;
  }
  return {};
}

TEST(ValueDomains, TheOracleEqualsPlanesByElimination) {
  const std::uint64_t wanted = RunsMore() ? 1'200'000 : Cases<std::uint64_t>(20'000);
  const std::vector<SubjectInfo> subjects = SubjectsOfAllKinds();
  const std::uint64_t share = wanted / Domains().size() + 1;
  Compared all;
  std::size_t domains = 0;
  for (const Domain& domain : Domains()) {
    Compared here;
    std::vector<const SubjectInfo*> suited;
    for (const SubjectInfo& info : subjects) {
      if (Suits(domain, info)) suited.push_back(&info);
    }
    if (suited.empty()) continue;  // about a key that none of the subjects states
    for (std::uint64_t k = 0; here.numbers < share && k < share; ++k) {
      const SubjectInfo& info = *suited[k % suited.size()];
      const Scene scene = DrawCase(info, CaseName{std::string(domain.name), k, kValueSeed}).scene;
      const std::vector<Channel> channels = ChannelsFor(scene, info.profile.values);
      const std::size_t step = scene.triangles.size() / kTrianglesOfACase + 1;
      for (std::size_t t = 0; t < scene.triangles.size() && here.numbers < share; t += step) {
        ASSERT_EQ(CompareTriangle(scene, scene.triangles[t], channels, k + t, here), "")
            << domain.name << ":" << k << "@" << kValueSeed << ", triangle " << t << " of "
            << info.profile.name;
      }
    }
    if (here.numbers > 0) ++domains;
    all.numbers += here.numbers;
    all.behind += here.behind;
    all.nothing += here.nothing;
  }
  std::printf(
      "%llu values and derivatives of %zu domains of %zu, %llu with a w <= 0; "
      "%llu times nothing\n",
      static_cast<unsigned long long>(all.numbers), domains, Domains().size(),
      static_cast<unsigned long long>(all.behind), static_cast<unsigned long long>(all.nothing));
  EXPECT_GE(all.numbers, wanted * 8 / 10);
  EXPECT_GE(domains, Domains().size() * 8 / 10);
  EXPECT_GT(all.behind, all.numbers / 50);
}

}  // namespace
}  // namespace rasterproof::props
