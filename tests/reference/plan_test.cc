#include "reference/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "exact/coverage.h"
#include "model/target_profile.h"
#include "reference/plan_scene.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

constexpr Needs kCoverageOnly;

Scene WindowScene(int width, int height, const std::vector<Point2>& points,
                  std::vector<Triangle> triangles) {
  Scene scene;
  scene.name = "plan";
  scene.width = width;
  scene.height = height;
  scene.precision = Precision::kFloat64;
  for (const Point2& p : points) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles = std::move(triangles);
  return scene;
}

CoverageCounts DrawPlan(const Plan& plan, const Scene& scene, const Profile& profile,
                        const DrawOptions& options = {}) {
  CoverageCounts counts(scene.width, scene.height, profile.pattern.samples());
  plan.draw(scene, profile, options, counts);
  return counts;
}

const PlanReason& Reason(const Plan& plan, const std::string& stage) {
  const auto found = std::ranges::find(plan.reasons, stage, &PlanReason::stage);
  EXPECT_NE(found, plan.reasons.end()) << stage;
  return *found;
}

/// Samples at the pixels' corners, which the spans do not serve.
Profile AtCorners() {
  Profile profile;
  profile.pattern.locations = {{0, 0}};
  return profile;
}

std::string ArithmeticFor(double side_in_units, int lattice, const Profile& profile = AtCorners()) {
  const double step = std::ldexp(1.0, -lattice);
  const double side = side_in_units * step;
  const Scene scene = WindowScene(64, 64, {{0, 0}, {side, step}, {0, side}}, {{0, 1, 2}});
  return MakePlan(scene, profile, {}, kCoverageOnly).arithmetic;
}

TEST(PlanTest, TakesEachArithmeticUpToItsSharpValueAndNotOneStepFurther) {
  // The largest box side in lattice steps: the square must not exceed the largest integer.
  EXPECT_EQ(ArithmeticFor(46340, 12), "int32 direct");
  EXPECT_EQ(ArithmeticFor(46341, 12), "int64 direct");
  EXPECT_EQ(ArithmeticFor(3037000499, 26), "int64 direct");
  EXPECT_EQ(ArithmeticFor(3037000500, 26), "wide exact");
  EXPECT_EQ(ArithmeticFor(46340, 12, Profile{}), "spans-exact");
  // Each value is sharp: one step further the product does not fit.
  EXPECT_GT(std::int64_t{46341} * 46341, std::int64_t{std::numeric_limits<std::int32_t>::max()});
  EXPECT_GT(std::uint64_t{3037000500} * 3037000500, std::uint64_t{1} << 63);
}

TEST(PlanTest, LooksAtCoordinatesAndLatticeNotOnlyAtBoxes) {
  // A box of two steps far out: the coordinates themselves do not fit int32.
  const auto far = [](double at, double step) {
    const Scene scene =
        WindowScene(8, 8, {{at, step}, {at + 2 * step, 0}, {at, 2 * step}}, {{0, 1, 2}});
    return MakePlan(scene, AtCorners(), {}, kCoverageOnly).arithmetic;
  };
  EXPECT_EQ(far(0x1p16, 0x1p-9), "int32 direct");
  EXPECT_EQ(far(0x1p23, 0x1p-9), "int64 direct");
  EXPECT_EQ(far(0x1p46, 0x1p-7), "int64 direct");
  // Steps below 2^-31 leave int32, below 2^-62 int64.
  const auto tiny = [](int lattice) {
    const double step = std::ldexp(1.0, -lattice);
    const Scene scene = WindowScene(8, 8, {{0, step}, {2 * step, 0}, {0, 2 * step}}, {{0, 1, 2}});
    return MakePlan(scene, AtCorners(), {}, kCoverageOnly).arithmetic;
  };
  EXPECT_EQ(tiny(31), "int32 direct");
  EXPECT_EQ(tiny(32), "int64 direct");
  EXPECT_EQ(tiny(62), "int64 direct");
  EXPECT_EQ(tiny(63), "wide exact");
}

/// A random point on the lattice 2^-s in a box of `steps` steps; corners and sides more often.
Point2 LatticePoint(RandomValues& random, double left, double top, std::uint64_t steps, int s) {
  const auto coordinate = [&](double low) {
    std::uint64_t n = (random.Bits(63) % (steps + 1));
    if (random.Integer(0, 3) == 0) n = random.Coin() ? 0 : steps;
    return low + std::ldexp(static_cast<double>(n), -s);
  };
  return {coordinate(left), coordinate(top)};
}

Profile RandomProfile(RandomValues& random) {
  Profile profile;
  if (random.Coin()) {
    profile.snap = {random.Integer(0, 12), static_cast<SnapRule>(random.Integer(0, 4))};
  }
  if (random.Coin()) profile.pattern.locations = {{0.5, 0.5}, {0, 0}, {0.125, 0.875}};
  if (random.Coin()) profile.y_axis = YAxis::kUp;
  if (random.Coin()) {
    profile.tie_rule = {static_cast<std::int8_t>(random.Coin() ? 1 : -1),
                        static_cast<std::int8_t>(random.Coin() ? 1 : -1), random.Coin(),
                        random.Integer(0, 5) == 0};
  }
  return profile;
}

DrawOptions RandomOptions(RandomValues& random) {
  DrawOptions options;
  options.cull = static_cast<Cull>(random.Integer(0, 2));
  if (random.Coin())
    options.scissor = PixelRect{random.Integer(-2, 5), 1, 12, random.Integer(2, 20)};
  if (random.Integer(0, 7) == 0) options.threads = 3;
  if (random.Integer(0, 7) == 0) options.tile = 4;
  return options;
}

// Whatever is kept that the plan leaves out, the counts are the same.
void ExpectVariantsAlike(const Plan& plan, const Scene& scene, const Profile& profile,
                         const DrawOptions& options) {
  ASSERT_FALSE(plan.variants.empty());
  const CoverageCounts planned = DrawPlan(plan, scene, profile, options);
  for (const PlanVariant& variant : plan.variants) {
    CoverageCounts counts(scene.width, scene.height, profile.pattern.samples());
    variant.draw(scene, profile, options, counts);
    EXPECT_EQ(counts, planned) << variant.kept;
  }
}

TEST(PlanTest, DrawsWhatTheOracleSaysOnEveryLattice) {
  RandomValues random(31);
  std::map<std::string, int> arithmetic;
  std::map<std::string, int> left_out;
  for (int n = 0; n < Cases(6000); ++n) {
    const int s = random.Integer(0, n % 3 == 0 ? 8 : 34);
    const std::uint64_t steps = (std::uint64_t{14} << s) + random.Bits(s);
    const double left = random.Coin() ? 0.5 : -3;
    std::vector<Point2> points;
    for (int k = 0; k < 4; ++k) points.push_back(LatticePoint(random, left, 0.25, steps, s));
    if (random.Integer(0, 15) == 0) points[3].x = random.AnyFinite<float>();
    const Scene scene = WindowScene(16, 16, points, {{0, 1, 2}, {2, 1, 3}, {0, 0, 3}});
    const Profile profile = n % 2 == 0 ? Profile{} : RandomProfile(random);
    const DrawOptions options = n % 4 == 0 ? DrawOptions{} : RandomOptions(random);
    const Plan plan = MakePlan(scene, profile, options, kCoverageOnly);
    ASSERT_EQ(DrawPlan(plan, scene, profile, options), exact::Coverage(scene, profile, options))
        << "case " << n << ", " << plan.arithmetic;
    if (n % 4 == 1) ExpectVariantsAlike(plan, scene, profile, options);
    ++arithmetic[plan.arithmetic];
    for (const PlanReason& reason : plan.reasons) {
      EXPECT_FALSE(reason.why.empty());
      if (reason.choice == "left out") ++left_out[reason.stage];
    }
  }
  for (const char* name : {"int32 direct", "int64 direct", "spans-exact", "wide exact"}) {
    EXPECT_GE(arithmetic[name], Cases(48)) << name;
  }
  for (const char* stage : {"snap", "clip", "cull", "barycentrics", "depth", "wireframe"}) {
    EXPECT_GE(left_out[stage], Cases(48)) << stage;
  }
}

TEST(PlanTest, TakesSpansForPixelCentresUnderTheTopLeftRule) {
  RandomValues random(37);
  for (int n = 0; n < Cases(120); ++n) {
    Scene scene = WindowScene(20, 17, {}, {});
    for (std::int32_t i = 0; i < 3 * (n % 3 == 0 ? 63 : 64); i += 3) {
      for (int k = 0; k < 3; ++k) {
        const bool any = random.Integer(0, 30) == 0;
        const float x = any ? random.AnyFinite<float>() : random.LogUniform<float>(-20, 8);
        const float y = any ? random.AnyFinite<float>() : random.LogUniform<float>(-20, 8);
        scene.vertices.push_back({.x = x, .y = y});
      }
      scene.triangles.push_back({i, i + 1, i + 2});
    }
    if (n % 10 == 9) scene.vertices[7].x = std::nextafter(scene.vertices[7].x, 1e9);  // no float32
    Profile profile;
    if (n % 2 == 1) profile.snap = {8, SnapRule::kNearestEven};
    const DrawOptions options = RandomOptions(random);
    const Plan plan = MakePlan(scene, profile, options, kCoverageOnly);
    ASSERT_EQ(DrawPlan(plan, scene, profile, options), exact::Coverage(scene, profile, options))
        << "case " << n << ", " << plan.arithmetic;
    ExpectVariantsAlike(plan, scene, profile, options);
    EXPECT_EQ(plan.arithmetic, "spans-exact");
  }
}

TEST(PlanTest, FollowsEverySnapForm) {
  RandomValues random(36);
  int differs = 0;
  for (int n = 0; n < Cases(1500); ++n) {
    std::vector<Point2> points;
    for (int k = 0; k < 3; ++k) points.push_back(LatticePoint(random, -3, 0.25, 18 << 9, 9));
    const Scene scene = WindowScene(16, 16, points, {{0, 1, 2}});
    Profile profile = RandomProfile(random);
    profile.snap.bits = random.Integer(0, 8);
    const Profile plain = profile;
    profile.snap.form = n % 2 == 0 ? SnapForm::kFloat32Difference : SnapForm::kExactDifference;
    profile.snap.origin = std::ldexp(random.Integer(0, 255), -8);
    const Plan plan = MakePlan(scene, profile, {}, kCoverageOnly);
    const CoverageCounts expected = exact::Coverage(scene, profile);
    ASSERT_EQ(DrawPlan(plan, scene, profile), expected) << "case " << n << ", " << plan.arithmetic;
    differs += expected == exact::Coverage(scene, plain) ? 0 : 1;
  }
  EXPECT_GE(differs, Cases(100));
}

TEST(PlanTest, ClipSpaceHasNoDifferencesToSnap) {
  Scene scene = WindowScene(8, 8, {{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  scene.clip_space = true;
  Profile profile = *PresetProfile("gl-canonical");
  profile.snap.form = SnapForm::kExactDifference;
  const Plan plan = MakePlan(scene, profile, {}, kCoverageOnly);
  EXPECT_THROW(DrawPlan(plan, scene, profile), InputError);
}

TEST(PlanTest, TakesNoProfileThatItWouldNotHonour) {
  const Scene window = WindowScene(8, 8, {{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  Scene clip = window;
  clip.clip_space = true;
  Profile crossing;
  crossing.scanline_rounding = {8, SnapRule::kFloor};
  EXPECT_THROW(MakePlan(window, crossing, {}, kCoverageOnly), InputError);
  EXPECT_THROW(MakePlan(clip, crossing, {}, kCoverageOnly), InputError);
  Profile extent;
  extent.max_primitive_extent = MaxPrimitiveExtent{2, 2};
  EXPECT_THROW(MakePlan(clip, extent, {}, kCoverageOnly), InputError);
  extent.transform.emplace();
  EXPECT_NO_THROW(MakePlan(clip, extent, {}, kCoverageOnly));
  Profile by_target;
  by_target.by_target_size = {{.max_width = 16, .max_height = 16, .snap = {4}}};
  EXPECT_THROW(MakePlan(window, by_target, {}, kCoverageOnly), InputError);
  EXPECT_NO_THROW(MakePlan(window, TargetProfile(by_target, 8, 8), {}, kCoverageOnly));
}

TEST(PlanTest, DrawsWhatTheOracleSaysAtTheSharpValues) {
  RandomValues random(32);
  struct Boundary {
    std::uint64_t steps;
    int lattice;
  };
  for (const Boundary b : {Boundary{46340, 12}, Boundary{46341, 12}, Boundary{3037000499, 28},
                           Boundary{3037000500, 28}}) {
    for (int n = 0; n < Cases(400); ++n) {
      std::vector<Point2> points;
      for (int k = 0; k < 3; ++k) points.push_back(LatticePoint(random, 0, 0, b.steps, b.lattice));
      // The box's diagonal is a separate corner case: the largest product there is.
      if (n % 4 == 0) {
        points[0] = {0, 0};
        points[1] = {std::ldexp(static_cast<double>(b.steps), -b.lattice),
                     std::ldexp(static_cast<double>(b.steps), -b.lattice)};
      }
      const Scene scene = WindowScene(17, 17, points, {{0, 1, 2}});
      const Plan plan = MakePlan(scene, AtCorners(), {}, kCoverageOnly);
      ASSERT_EQ(DrawPlan(plan, scene, AtCorners()), exact::Coverage(scene, AtCorners()))
          << b.steps << " steps, " << plan.arithmetic;
    }
  }
}

TEST(PlanTest, DrawsWhatTheOracleSaysForAnyFloatAtAll) {
  RandomValues random(33);
  for (int n = 0; n < Cases(3000); ++n) {
    std::vector<Point2> points;
    for (int k = 0; k < 4; ++k) {
      points.push_back(
          n % 2 == 0 ? Point2{random.AnyFinite<double>(), random.AnyFinite<double>()}
                     : Point2{random.LogUniform<float>(-20, 8), random.LogUniform<float>(-20, 8)});
    }
    Scene scene = WindowScene(9, 9, points, {{0, 1, 2}, {1, 3, 2}});
    const double bad = std::numeric_limits<double>::quiet_NaN();
    if (n % 5 == 0) (random.Coin() ? scene.vertices[3].x : scene.vertices[3].y) = bad;
    const Profile profile = n % 3 == 0 ? RandomProfile(random) : Profile{};
    const Plan plan = MakePlan(scene, profile, {}, kCoverageOnly);
    ASSERT_EQ(DrawPlan(plan, scene, profile), exact::Coverage(scene, profile)) << "case " << n;
  }
}

TEST(PlanTest, SaysWhatItLeavesOutAndWhy) {
  const Scene scene = WindowScene(16, 16, {{1, 1}, {9.5, 2.25}, {3, 12}}, {{0, 1, 2}});
  Profile gl = *PresetProfile("gl-canonical");
  gl.pattern = AtCorners().pattern;
  const Plan plan = MakePlan(scene, gl, {}, kCoverageOnly);
  EXPECT_EQ(plan.arithmetic, "int32 direct");
  EXPECT_NE(Reason(plan, "edge arithmetic").why.find("2^31"), std::string::npos);
  for (const char* stage :
       {"snap", "clip", "cull", "perspective", "barycentrics", "depth", "wireframe"}) {
    EXPECT_EQ(Reason(plan, stage).choice, "left out") << stage;
  }
  DrawOptions options;
  options.cull = Cull::kBack;
  options.scissor = PixelRect{0, 0, 8, 8};
  Scene off_grid = scene;
  off_grid.vertices[0].x = 1 + 0x1p-10;
  const Plan full = MakePlan(off_grid, gl, options, Needs{true, true, true});
  for (const char* stage : {"snap", "clip", "cull", "barycentrics", "depth", "wireframe"}) {
    EXPECT_EQ(Reason(full, stage).choice, "kept") << stage;
  }
}

TEST(PlanTest, ClipSpaceGetsHomogeneousEdgesOrAnExactSnapOfTheQuotient) {
  RandomValues random(35);
  for (int n = 0; n < Cases(1500); ++n) {
    Scene scene = WindowScene(8, 8, std::vector<Point2>(4), {{0, 1, 2}, {2, 1, 3}});
    scene.clip_space = true;
    Profile profile;
    const bool snapped = n % 2 == 0;
    if (snapped) {
      profile.snap = {random.Integer(0, 8), static_cast<SnapRule>(random.Integer(0, 4))};
    }
    for (Vertex& v : scene.vertices) {
      // Small integers over small integers: many quotients fall on ties of the grid.
      v = {double(random.Integer(-9, 60)), double(random.Integer(-9, 60)), 0,
           double(random.Integer(snapped ? 1 : -4, 7))};
      if (n % 5 == 0) v.x = std::nextafter(v.x, 1e9);
    }
    const Plan plan = MakePlan(scene, profile, {}, kCoverageOnly);
    EXPECT_EQ(plan.arithmetic, snapped ? "spans-exact" : "homogeneous exact");
    ASSERT_EQ(DrawPlan(plan, scene, profile), exact::Coverage(scene, profile)) << "case " << n;
  }
}

TEST(PlanTest, AVertexBehindTheEyeCannotBeSnapped) {
  Scene scene = WindowScene(8, 8, {{0, 0}, {4, 0}, {0, 4}}, {{0, 1, 2}});
  scene.clip_space = true;
  scene.vertices[1].w = -1;
  const Profile gl = *PresetProfile("gl-canonical");
  const Plan plan = MakePlan(scene, gl, {}, kCoverageOnly);
  EXPECT_THROW(DrawPlan(plan, scene, gl), InputError);
  scene.vertices[1] = {1e300, 0, 0, 1e-300};
  EXPECT_THROW(DrawPlan(plan, scene, gl), InputError);
}

TEST(PlanTest, CountsOfAnotherShapeAreRefused) {
  for (const double x : {2.0, 1e30}) {
    const Scene scene = WindowScene(8, 8, {{0, 0}, {x, 0}, {0, 4}}, {{0, 1, 2}});
    CoverageCounts counts(8, 7);
    EXPECT_THROW(MakePlan(scene, Profile{}, {}, kCoverageOnly).draw(scene, Profile{}, {}, counts),
                 InputError);
  }
}

}  // namespace
}  // namespace rasterproof::reference
