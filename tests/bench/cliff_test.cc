#include "bench/cliff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/contender.h"
#include "bench/exact_triangles.h"
#include "reference/exactness.h"
#include "reference/method.h"

namespace rasterproof::bench {
namespace {

__extension__ using Int128 = __int128;

std::optional<BenchCliff> CliffOf(SceneDrawer& drawer, std::string_view parameter) {
  static JudgedCases cases;
  return FindCliff(drawer, *FindParameter(parameter), cases);
}

BenchCliff CliffOf(std::string_view method, std::string_view parameter) {
  const auto contender = MakeMethodContender(*reference::FindMethod(method));
  return CliffOf(*DrawerOf(*contender), parameter).value_or(BenchCliff{});
}

double Isqrt(Int128 n) {
  auto root = static_cast<Int128>(std::sqrt(static_cast<double>(n)));
  while (root * root > n) --root;
  while ((root + 1) * (root + 1) <= n) ++root;
  return static_cast<double>(root);
}

// Wraps to two's complement of `bits` bits.
std::function<Int128(Int128)> Wrapping(int bits) {
  return [bits](Int128 x) {
    const Int128 range = Int128{1} << bits;
    const Int128 low = ((x % range) + range) % range;
    return low >= range / 2 ? low - range : low;
  };
}

// So many significant bits, to nearest even.
std::function<Int128(Int128)> Floating(int bits) {
  return [bits](Int128 x) {
    Int128 size = x < 0 ? -x : x;
    int shift = 0;
    while ((size >> shift) >> bits != 0) ++shift;
    if (shift == 0) return x;
    const Int128 half = Int128{1} << (shift - 1);
    const Int128 low = size & (2 * half - 1);
    Int128 kept = size >> shift;
    if (low > half || (low == half && kept % 2 != 0)) ++kept;
    size = kept << shift;
    return x < 0 ? -size : size;
  };
}

// Half-spaces in integers of 1/256 pixel, top-left, with errors to order. Without any it is sound
// for all that is tried here.
class Planted final : public SceneDrawer {
 public:
  using Step = std::function<Int128(Int128)>;
  static Int128 Exact(Int128 x) { return x; }
  struct Steps {
    Step coordinate = Exact;
    Step difference = Exact;
    Step product = Exact;
    Step sum = Exact;
    std::function<bool(Int128 larger_side)> is_lost = [](Int128) { return false; };
  };
  explicit Planted(Steps steps) : steps_(std::move(steps)) {
    method_.name = "planted";
    method_.coordinate_limit = 0x1p127;
  }

  const BenchMethod& method() const override { return method_; }
  const Profile& model() const override { return model_; }
  bool Takes(const Scene& scene) const override {
    return !scene.clip_space && std::ranges::all_of(scene.vertices, [](const Vertex& v) {
      return std::max(std::fabs(v.x), std::fabs(v.y)) <= 0x1p50;
    });
  }
  std::vector<std::optional<bool>> Covers(std::span<const HardCase* const> cases) override {
    std::vector<std::optional<bool>> covers;
    for (const HardCase* one : cases) covers.emplace_back(CoversIt(*one));
    return covers;
  }

 private:
  struct Place {
    Int128 x;
    Int128 y;
  };
  Place At(Point2 p) const {
    return {steps_.coordinate(static_cast<Int128>(p.x * 256)),
            steps_.coordinate(static_cast<Int128>(p.y * 256))};
  }
  Int128 Edge(Place a, Place b, Place p) const {
    const Step& d = steps_.difference;
    return steps_.sum(steps_.product(d(p.x - a.x) * d(b.y - a.y)) -
                      steps_.product(d(p.y - a.y) * d(b.x - a.x)));
  }
  bool CoversIt(const HardCase& of) const {
    std::array<Place, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = At(WindowPoint(of.scene.vertices[k]));
    const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (steps_.is_lost(std::max(x1 - x0, y1 - y0))) return false;
    const Int128 area = Edge(v[0], v[1], v[2]);
    if (area == 0) return false;
    if (area < 0) std::swap(v[1], v[2]);
    const Place p = At(CentreOf(of.x, of.y));
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = v[k];
      const Place b = v[(k + 1) % 3];
      const Int128 e = Edge(a, b, p);
      const bool is_top_left = b.y > a.y || (b.y == a.y && b.x < a.x);
      if (e < 0 || (e == 0 && !is_top_left)) return false;
    }
    return true;
  }

  Steps steps_;
  BenchMethod method_;
  Profile model_;
};

double FirstFailing(Planted::Steps steps, std::string_view parameter = "grid-8") {
  Planted planted(std::move(steps));
  const auto cliff = CliffOf(planted, parameter);
  return cliff ? cliff->first_failing : -1;
}

// Legal adversary: what is sound has no cliff on any grid.
TEST(FindCliff, OfASoundMethodIsNone) {
  for (const std::string_view parameter : {"grid-0", "grid-1", "grid-4", "grid-8", "extent"}) {
    EXPECT_TRUE(std::isnan(FirstFailing({}, parameter))) << parameter;
  }
  for (const std::string_view method : {"spans-exact", "filtered-exact"}) {
    for (const Parameter& parameter : Parameters()) {
      EXPECT_TRUE(std::isnan(CliffOf(method, parameter.name).first_failing))
          << method << " " << parameter.name;
    }
  }
}

// Ten overflows, each found at its exact value.
TEST(FindCliff, FindsAnAccumulatorThatWraps) {
  for (const int bits : {17, 24, 32, 41}) {
    // The largest |E| of a box of side n is n^2.
    EXPECT_EQ(FirstFailing({.sum = Wrapping(bits)}), Isqrt((Int128{1} << (bits - 1)) - 1) + 1)
        << bits;
  }
  EXPECT_EQ(FirstFailing({.sum = Wrapping(32)}), 46341);
}

TEST(FindCliff, FindsDifferencesThatWrap) {
  for (const int bits : {14, 21}) {
    EXPECT_EQ(FirstFailing({.difference = Wrapping(bits)}), std::ldexp(1, bits - 1)) << bits;
  }
  // 16.16: a side of 32768 pixels, as finding 5 is of.
  EXPECT_EQ(FirstFailing({.difference = Wrapping(24)}, "extent"), 32768);
}

TEST(FindCliff, FindsCoordinatesThatWrap) {
  // The sample lies 384 steps from 0, corners up to that many steps from the sample.
  EXPECT_EQ(FirstFailing({.coordinate = Wrapping(16)}), 32768 - 384);
}

TEST(FindCliff, FindsALargestPrimitive) {
  EXPECT_EQ(FirstFailing({.is_lost = [](Int128 side) { return side > 5000; }}), 5001);
}

// The least box in which two products that differ by E round to another sign, by trying all.
double LeastBoxByTryingAll(int bits) {
  const auto round = Floating(bits);
  const auto sign = [](Int128 x) { return x < 0 ? -1 : x > 0 ? 1 : 0; };
  for (Int128 n = 3;; ++n) {
    for (Int128 other = 1; other <= n; ++other) {
      for (Int128 u = 0; u <= n; ++u) {
        for (Int128 v = std::max(Int128{0}, u * other / n - 1); v <= u * other / n + 1; ++v) {
          const Int128 e = round(round(u * other) - round(v * n));
          if (sign(e) != sign(u * other - v * n)) return static_cast<double>(n);
        }
      }
    }
  }
}

TEST(FindCliff, FindsProductsThatRound) {
  for (const int bits : {10, 11, 16}) {
    const auto rounds = Floating(bits);
    EXPECT_EQ(FirstFailing({.product = rounds, .sum = rounds}), LeastBoxByTryingAll(bits)) << bits;
  }
  EXPECT_EQ(FirstFailing({.product = Floating(24), .sum = Floating(24)}), 4098);
}

TEST(FindCliff, FindsWhatFailsAtOneValueAlone) {
  Planted planted({.is_lost = [](Int128 side) { return side == 4097; }});
  const auto cliff = CliffOf(planted, "grid-8");
  ASSERT_TRUE(cliff);
  EXPECT_EQ(cliff->first_failing, 4097);
  EXPECT_EQ(cliff->held_to, 4096);
  // As llvmpipe does on one pixel (finding 1): a window between powers of two, bisected to its end.
  EXPECT_EQ(FirstFailing({.is_lost = [](Int128 side) { return side > 4200 && side < 7900; }}),
            4201);
  // Between what is tried it is missed: that is why nothing is stated there.
  EXPECT_TRUE(std::isnan(FirstFailing({.is_lost = [](Int128 side) { return side == 5000; }})));
}

TEST(FindCliff, KeepsACaseThatFails) {
  const BenchCliff cliff = CliffOf("f32-direct", "grid-8");
  ASSERT_TRUE(cliff.scene);
  EXPECT_EQ(cliff.scene->triangles.size(), 1U);
  const auto drawer = MakeMethodContender(*reference::FindMethod("f32-direct"));
  const HardCase one{*cliff.scene, cliff.x, cliff.y, 0, std::nullopt};
  const std::array cases{&one};
  const bool covers = DrawerOf(*drawer)->Covers(cases).front().value();
  EXPECT_NE(covers, ExactTriangles(one.scene, Profile{}).Covers(0, one.x, one.y));
}

TEST(ExactnessTable, IsWhatTheSearchFinds) {
  for (const auto& row : reference::kExactnessTable) {
    const BenchCliff values = CliffOf(row.method, "values");
    EXPECT_GT(values.first_failing, static_cast<double>(row.values)) << row.method;
    if (row.values != reference::kFloat32Affine) {
      EXPECT_EQ(values.first_failing, static_cast<double>(row.values) + 1) << row.method;
    }
    const auto contender = MakeMethodContender(*reference::FindMethod(row.method));
    for (const std::string_view name : {"grid-0", "grid-1", "grid-4", "grid-8"}) {
      const Parameter& parameter = *FindParameter(name);
      const double proved = ProvedTo(contender->method(), parameter);
      EXPECT_GT(proved, 0) << row.method << " " << name;
      const BenchCliff cliff = CliffOf(row.method, name);
      if (std::isnan(cliff.first_failing)) {
        EXPECT_EQ(row.signs, reference::kFloat64Differences) << row.method << " " << name;
        continue;
      }
      EXPECT_GT(cliff.first_failing, proved) << row.method << " " << name;
    }
  }
  EXPECT_EQ(CliffOf("f32-direct", "grid-8").first_failing, 4098);
  EXPECT_EQ(CliffOf("f32-direct-fma", "grid-8").first_failing, 4097);
  EXPECT_EQ(CliffOf("f32-kahan", "grid-8").first_failing, 0x1p24 + 1);
  EXPECT_EQ(CliffOf("f64-direct", "grid-8").first_failing, 94906267);
}

// Where coordinates are taken for themselves the hardest sample lies far from the origin.
TEST(FindCliff, OfTheAffineFormIsNearerThanThatOfDifferences) {
  const BenchCliff cliff = CliffOf("f32-affine", "grid-8");
  EXPECT_GT(cliff.first_failing, 2048);
  EXPECT_LT(cliff.first_failing, 4096);
}

TEST(DeclaredLimits, HoldFromBothSides) {
  // Within 16384 pixels it draws, a step beyond it does not.
  const auto tiles =
      MakeRivalContender({library::rivals::Traversal::kTiles, library::rivals::Arithmetic::kInt32},
                         library::kernels::Target::kScalar, library::kernels::Sink::kFacing);
  const double limit = ProvedTo(tiles->method(), *FindParameter("grid-8"));
  EXPECT_EQ(limit, 16384 * 256 - 384);
  EXPECT_EQ(CliffOf(*DrawerOf(*tiles), "grid-8")->first_failing, limit + 1);
  // Beyond what they state these fall back to exact spans.
  for (const std::string_view name : {"i32-snap4", "i64-snap8"}) {
    EXPECT_TRUE(std::isnan(CliffOf(name, "grid-8").first_failing)) << name;
    EXPECT_TRUE(std::isnan(CliffOf(name, "extent").first_failing)) << name;
  }
}

}  // namespace
}  // namespace rasterproof::bench
