// Wrapping, dropping and all stages in their order against their second definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "model/drop.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "model/wrap.h"
#include "subjects/mutants/placing.h"
#include "tests/model/hard_numbers.h"
#include "tests/model/second_definition.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

using second::Value;

// Multiples of the input's step at both ends of its range, of the ranges beside it and far off.
std::vector<double> Integers(const FixedInput& fixed) {
  std::vector<double> all{0,
                          fixed.Step(),
                          -fixed.Step(),
                          0x1p60,
                          -0x1p60,
                          0x1.8p1000,
                          std::numeric_limits<double>::max()};
  for (const double spans : {-64.0, -3.0, -1.0, 0.0, 1.0, 2.0, 63.0}) {
    for (const double end : {fixed.Least(), fixed.Least() + fixed.Span() / 2, fixed.Largest()}) {
      for (const int steps : {-1, 0, 1}) {
        all.push_back(spans * fixed.Span() + end + steps * fixed.Step());
      }
    }
  }
  return all;
}

TEST(WrapByRationals, IsWrappedForEveryInput) {
  for (int integer_bits = 1; integer_bits <= kMaxIntegerBits; ++integer_bits) {
    for (int fraction_bits = 0; fraction_bits <= kMaxSubpixelBits; ++fraction_bits) {
      for (const int kind : {0, 1, 2, 3}) {
        const FixedInput fixed{integer_bits, fraction_bits, kind % 2 == 0, kind / 2 == 0};
        for (const double x : Integers(fixed)) {
          const double wrapped = Wrapped(x, fixed);
          ASSERT_EQ(mpq_class(wrapped), second::Wrapped(mpq_class(x), fixed))
              << std::hexfloat << x << ", " << integer_bits << "." << fraction_bits << ", "
              << fixed.is_signed << fixed.wraps;
          ASSERT_TRUE(!fixed.wraps || fixed.InRange(wrapped)) << std::hexfloat << x;
        }
      }
    }
  }
}

TEST(DropByRationals, IsExceedsBesideEveryExtent) {
  std::size_t larger = 0;
  std::size_t all = 0;
  for (const double extent : {0.0, 0x1p-1074, 0.1, 1.0, 64.0, 1023.0, 65536.0, 0x1p60, 1e308,
                              std::numeric_limits<double>::max()}) {
    for (const double low : second::EndsOfTheRange()) {
      for (const double high : second::AndNeighbours(low + extent)) {
        if (!std::isfinite(high)) continue;
        const std::array<Point2, 3> v{{{low, 2}, {high, -1}, {low, 0.5}}};
        const std::array<Point2, 3> turned{{{0.5, high}, {0, low}, {-1, high}}};
        for (const auto& [corners, most] : {std::pair{v, MaxPrimitiveExtent{extent, 8}},
                                            std::pair{turned, MaxPrimitiveExtent{8, extent}}}) {
          std::array<std::array<mpq_class, 2>, 3> exact;
          for (std::size_t k = 0; k < 3; ++k) exact[k] = {corners[k].x, corners[k].y};
          const bool expected = second::IsLarger(exact, most);
          ASSERT_EQ(Exceeds(corners, most), expected)
              << std::hexfloat << low << " to " << high << ", extent " << extent;
          larger += expected ? 1 : 0;
          ++all;
        }
      }
    }
  }
  EXPECT_GT(larger, all / 20);
  EXPECT_LT(larger, all - all / 20);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int Int(int least, int most) {
    const std::uint64_t span = static_cast<std::uint64_t>(std::int64_t{most} - least + 1);
    return static_cast<int>(least + static_cast<std::int64_t>(engine_() % span));
  }
  bool Coin() { return Int(0, 1) == 1; }
  template <class T>
  T Of(const std::vector<T>& values) {
    return values[static_cast<std::size_t>(Int(0, static_cast<int>(values.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

Snap AnySnap(Random& random) {
  if (random.Int(0, 4) == 0) return {};
  return {random.Int(0, kMaxSubpixelBits), static_cast<SnapRule>(random.Int(0, 4)),
          static_cast<SnapForm>(random.Int(0, 2)), random.Int(0, 255) / 256.0};
}

std::vector<TargetModel> AnyTargets(Random& random) {
  std::vector<TargetModel> models(static_cast<std::size_t>(random.Int(0, 3)));
  for (TargetModel& model : models) {
    model = {random.Int(1, 6), random.Int(1, 6), AnySnap(random), {}, {}};
    if (random.Int(0, 4) == 0) model.max_width = model.max_height = kMaxTargetSide;
    model.pattern.locations = {{random.Int(0, 255) / 256.0, 0.5}};
    model.tie_rule.y_first = random.Coin();
  }
  return models;
}

// What an entry of `by_target_size` says, or the profile itself.
struct Said {
  Snap snap;
  SamplePattern lattice;
  TieRule tie_rule;

  friend bool operator==(const Said&, const Said&) = default;
};

Said SaidOn(const Profile& profile, int width, int height) {
  for (const TargetModel& model : profile.by_target_size) {
    if (width <= model.max_width && height <= model.max_height) {
      return {model.snap, model.pattern, model.tie_rule};
    }
  }
  return {profile.snap, profile.pattern, profile.tie_rule};
}

TEST(TargetProfileBySizes, IsTheFirstEntryThatFits) {
  Random random(1);
  for (int k = 0; k < Cases(500); ++k) {
    Profile profile;
    profile.snap = AnySnap(random);
    profile.by_target_size = AnyTargets(random);
    for (int width = 1; width <= 7; ++width) {
      for (int height = 1; height <= 7; ++height) {
        const Said expected = SaidOn(profile, width, height);
        const Profile mutants = subjects::mutants::ModelOn(profile, width, height);
        for (const Profile& model :
             {static_cast<Profile>(TargetProfile(profile, width, height)), mutants}) {
          ASSERT_EQ((Said{model.snap, model.pattern, model.tie_rule}), expected)
              << "profile " << k << ", " << width << " x " << height;
        }
      }
    }
  }
}

Profile AnyProfile(Random& random) {
  Profile profile;
  profile.snap = AnySnap(random);
  profile.by_target_size = AnyTargets(random);
  if (random.Coin()) profile.max_primitive_extent = MaxPrimitiveExtent{random.Int(0, 64) / 4.0, 8};
  if (random.Coin()) {
    profile.guard_band = WindowBox{-3, -5, random.Int(-2, 80) / 8.0, 1024};
  }
  if (random.Coin()) {
    const auto division = static_cast<Division>(random.Int(0, 1));
    const auto viewport = static_cast<ViewportForm>(random.Int(0, 3));
    profile.transform =
        Transform{static_cast<Precision>(random.Int(0, 1)), division, viewport, random.Coin()};
  } else if (random.Coin()) {
    profile.fixed = FixedInput{random.Int(1, 12), random.Int(0, 8), random.Coin(), random.Coin()};
  }
  return profile;
}

// A coordinate that the profile's input holds: a multiple of its step, or any near the grid.
double AnyCoordinate(Random& random, const Profile& profile) {
  if (random.Int(0, 40) == 0) return random.Of<double>({HUGE_VAL, -HUGE_VAL, NAN});
  const int bits = profile.fixed ? profile.fixed->fraction_bits : random.Int(0, 20);
  const double most = std::ldexp(1.0, random.Int(0, 10));
  const int units = static_cast<int>(std::ldexp(most, bits));
  return std::ldexp(random.Int(-units, units), -bits);
}

Scene AnyScene(Random& random, const Profile& profile) {
  Scene scene;
  scene.width = random.Int(1, 7);
  scene.height = random.Int(1, 7);
  scene.precision = Precision::kFloat64;
  scene.clip_space = profile.transform.has_value();
  for (int k = 0; k < 6; ++k) {
    const double w = scene.clip_space ? random.Int(-1, 12) / 4.0 : 1;
    scene.vertices.push_back(
        {AnyCoordinate(random, profile), AnyCoordinate(random, profile), k / 8.0, w});
    scene.triangles.push_back({random.Int(0, 5), random.Int(0, 5), random.Int(0, 5)});
  }
  return scene;
}

// A coordinate through all stages: `snaps` false stops before the grid.
Value Placed(double x, const Vertex& v, bool is_y, const Scene& scene, const Profile& profile,
             bool snaps) {
  const int size = is_y ? scene.height : scene.width;
  Value at = scene.clip_space ? second::InWindow(x, v, *profile.transform, size, is_y)
                              : second::FromDouble(x);
  if (at.kind != Value::Kind::kFinite) return at;
  if (profile.fixed) at.number = second::Wrapped(at.number, *profile.fixed);
  const Snap snap = SaidOn(profile, scene.width, scene.height).snap;
  if (snaps) at.number = second::Snapped(at.number, snap);
  return at;
}

using Place = std::array<Value, 2>;

std::vector<Place> Places(const Scene& scene, const Profile& profile, bool snaps) {
  std::vector<Place> places;
  for (const Vertex& v : scene.vertices) {
    places.push_back({Placed(v.x, v, false, scene, profile, snaps),
                      Placed(v.y, v, true, scene, profile, snaps)});
  }
  return places;
}

bool IsPlace(const Value& value, double x) {
  const Value other = second::FromDouble(x);  // the sign of a zero is no place
  return value.kind == other.kind && value.number == other.number &&
         (value.kind != Value::Kind::kInfinite || value.negative == other.negative);
}

bool IsFinitePlace(const Place& place) {
  return place[0].kind == Value::Kind::kFinite && place[1].kind == Value::Kind::kFinite;
}

// Whether the triangle is dropped: nothing is said of one that is not finite.
bool IsDropped(const Triangle& t, const std::vector<Place>& places, const Profile& profile) {
  std::array<std::array<mpq_class, 2>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place& place = places[static_cast<std::size_t>(t[k])];
    corners[k] = {place[0].number, place[1].number};
  }
  return profile.max_primitive_extent && second::IsLarger(corners, *profile.max_primitive_extent);
}

TEST(PlacingByRationals, IsSnapSceneStageByStage) {
  Random random(2);
  int dropped = 0;
  for (int k = 0; k < Cases(20000); ++k) {
    const Profile profile = AnyProfile(random);
    const Scene scene = AnyScene(random, profile);
    const std::vector<Place> places = Places(scene, profile, true);
    const Scene placed = SnapScene(scene, {profile, scene});
    ASSERT_FALSE(placed.clip_space);
    ASSERT_EQ(placed.vertices.size(), places.size());
    for (std::size_t v = 0; v < places.size(); ++v) {
      ASSERT_TRUE(IsPlace(places[v][0], placed.vertices[v].x)) << "scene " << k << ", " << v;
      ASSERT_TRUE(IsPlace(places[v][1], placed.vertices[v].y)) << "scene " << k << ", " << v;
      ASSERT_EQ(placed.vertices[v].z, scene.vertices[v].z);
      ASSERT_EQ(placed.vertices[v].w, 1);
    }
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const Triangle& own = scene.triangles[t];
      const bool is_finite = std::ranges::all_of(
          own, [&](std::int32_t n) { return IsFinitePlace(places[static_cast<std::size_t>(n)]); });
      if (!is_finite) continue;
      const bool is_dropped = IsDropped(own, places, profile);
      ASSERT_EQ(placed.triangles[t], is_dropped ? (Triangle{own[0], own[0], own[0]}) : own)
          << "scene " << k << ", triangle " << t;
      dropped += is_dropped ? 1 : 0;
    }
  }
  EXPECT_GT(dropped, Cases(2000));
}

TEST(PlacingByRationals, IsUnclippedBeforeAndAfterTheGrid) {
  Random random(3);
  int unclipped = 0;
  for (int k = 0; k < Cases(20000); ++k) {
    Profile profile = AnyProfile(random);
    profile.transform.reset();
    const WindowBox box{-random.Int(0, 64) / 8.0, -64, random.Int(0, 64) / 8.0, 64};
    profile.guard_band = box;
    Scene scene = AnyScene(random, profile);
    scene.triangles.resize(1);
    if (!std::ranges::all_of(scene.vertices, IsFinite)) continue;
    bool expected = true;
    for (const bool snaps : {false, true}) {
      const std::vector<Place> places = Places(scene, profile, snaps);
      // A triangle that is dropped has one place, its first corner's.
      const bool is_dropped = IsDropped(scene.triangles[0], places, profile);
      for (const std::int32_t n : scene.triangles[0]) {
        const Place& at = places[static_cast<std::size_t>(is_dropped ? scene.triangles[0][0] : n)];
        expected = expected && IsFinitePlace(at) && at[0].number >= box.x0 &&
                   at[0].number <= box.x1 && at[1].number >= box.y0 && at[1].number <= box.y1;
      }
    }
    ASSERT_EQ(IsUnclipped(scene, {profile, scene}), expected) << "scene " << k;
    unclipped += expected ? 1 : 0;
  }
  EXPECT_GT(unclipped, Cases(1000));
}

}  // namespace
}  // namespace rasterproof
