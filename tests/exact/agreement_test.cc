// The three deciders on the same cases, over all families. A share by default; all of it, 10
// million signs and 100,000 triangle coverages, with RASTERPROOF_AGREEMENT=full in the environment.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "tests/exact/families.h"

namespace rasterproof::exact {
namespace {

constexpr int kFullSigns = 10'000'000;
constexpr int kFullTriangles = 100'000;
#ifdef __SANITIZE_ADDRESS__
constexpr int kShare = 400;  // sanitizers take ten times as long
#else
constexpr int kShare = 40;
#endif

bool Full() {
  const char* value = std::getenv("RASTERPROOF_AGREEMENT");
  return value != nullptr && std::string_view(value) == "full";
}

class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void PrintTiers(const char* what, std::uint64_t n, double seconds, const TierCounts& t) {
  std::printf(
      "%s: %llu compared in %.1f s; tiers: filter %llu, stable %llu, exact %llu, symbolic %llu\n",
      what, static_cast<unsigned long long>(n), seconds, static_cast<unsigned long long>(t.filter),
      static_cast<unsigned long long>(t.stable), static_cast<unsigned long long>(t.exact),
      static_cast<unsigned long long>(t.symbolic));
}

TEST(Agreement, OfThreeDecidersOnSigns) {
  const int n = Full() ? kFullSigns : kFullSigns / kShare;
  const Stopwatch watch;
  const TierScope scope;
  Draw draw(1);
  for (int k = 0; k < n; ++k) {
    const auto family = static_cast<Family>(k % kFamilies);
    const auto [a, b, p] = draw.EdgeAndPoint(family);
    const int fast = EdgeSign(a, b, p);
    const int integers = EdgeSign(a, b, p, Decider::kIntegers);
    const int cgal = EdgeSign(a, b, p, Decider::kCgal);
    if (fast == integers && integers == cgal) continue;
    std::printf("%s %d: fast %d, integers %d, cgal %d: (%a, %a) -> (%a, %a) at (%a, %a)\n",
                std::string(FamilyName(family)).c_str(), k, fast, integers, cgal, a.x, a.y, b.x,
                b.y, p.x, p.y);
    FAIL();
  }
  PrintTiers("signs", static_cast<std::uint64_t>(n), watch.Seconds(), scope.Counts());
  EXPECT_GT(scope.Counts().filter, 0U);
  EXPECT_GT(scope.Counts().stable, 0U);
  EXPECT_GT(scope.Counts().exact, 0U);
}

TEST(Agreement, OfThreeDecidersOnTriangleCoverages) {
  const int n = Full() ? kFullTriangles : kFullTriangles / kShare;
  const Stopwatch watch;
  const TierScope scope;
  Draw draw(2);
  std::uint64_t triangles = 0;
  std::uint64_t samples = 0;
  std::uint64_t covered = 0;
  for (int k = 0; triangles < static_cast<std::uint64_t>(n); ++k) {
    const auto family = static_cast<Family>(k % kFamilies);
    Scene scene = draw.SmallScene(family, k % 3 == 0);
    scene.width = std::min(scene.width, 6);
    scene.height = std::min(scene.height, 6);
    const Profile profile = draw.AnyProfile();
    const DrawOptions options = draw.AnyOptions();
    const CoverageCounts fast = Coverage(scene, profile, options);
    ASSERT_EQ(fast, Coverage(scene, profile, options, Decider::kIntegers))
        << FamilyName(family) << " " << k;
    ASSERT_EQ(fast, Coverage(scene, profile, options, Decider::kCgal))
        << FamilyName(family) << " " << k;
    triangles += scene.triangles.size();
    samples += fast.size() * scene.triangles.size();
    for (std::size_t i = 0; i < fast.size(); ++i) covered += fast.Count(i);
  }
  PrintTiers("triangle coverages", triangles, watch.Seconds(), scope.Counts());
  std::printf("samples asked %llu, covered %llu\n", static_cast<unsigned long long>(samples),
              static_cast<unsigned long long>(covered));
  EXPECT_GT(scope.Counts().symbolic, 0U);
  EXPECT_GT(covered, 0U);
}

}  // namespace
}  // namespace rasterproof::exact
