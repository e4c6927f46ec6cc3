// Values of the library: bit by bit what plain loops define, by every instruction set; within the
// stated bound of the oracle's rationals; and correctly rounded where that is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "core/channel.h"
#include "core/error.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "exact/values.h"
#include "library/rasterize.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr int kValuesWidth = 83;
constexpr int kValuesHeight = 37;
constexpr int kTestChannels = 3;
constexpr std::size_t kTestPitch = 90;
constexpr float kUntouched = -77;
constexpr std::array kSetsOfValues{InstructionSet::kScalar, InstructionSet::kSse4,
                                   InstructionSet::kAvx2, InstructionSet::kAvx512,
                                   InstructionSet::kNeon};

struct ValueMesh {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  std::vector<float> numbers;
  RasterSpace space = RasterSpace::kClip;

  RasterMesh Mesh() const { return {positions, indices, space}; }
};

struct Planes {
  std::vector<float> values, dx, dy;

  Planes()
      : values(kTestPitch * kTestChannels * kValuesHeight, kUntouched), dx(values), dy(values) {}
};

RasterValues In(const ValueMesh& mesh, Planes& planes, RasterInterpolation interpolation,
                RasterRounding rounding) {
  RasterValues values{.numbers = mesh.numbers,
                      .channels = kTestChannels,
                      .interpolation = interpolation,
                      .rounding = rounding,
                      .width = kValuesWidth,
                      .height = kValuesHeight,
                      .pitch = kTestPitch,
                      .values = planes.values,
                      .dx = planes.dx,
                      .dy = planes.dy};
  if (rounding == RasterRounding::kNearest) values.dx = values.dy = {};
  return values;
}

// w alike, of ratios to 2^60, near 0, of both signs; numbers anyhow, equal, cancelling, 0.
ValueMesh RandomValueMesh(std::uint64_t seed, RasterSpace space) {
  reference::RandomValues random(seed);
  ValueMesh mesh;
  mesh.space = space;
  for (int t = 0; t < 24; ++t) {
    const int kind = random.Integer(0, 4);
    const int numbers = random.Integer(0, 4);
    const double about = random.Uniform(-2, 2);
    for (int k = 0; k < 3; ++k) {
      double w = 1;
      if (kind == 1) w = std::ldexp(1 + random.Uniform(0, 1), random.Integer(-30, 30));
      if (kind == 2) w = random.Uniform(-0.5, 2);
      if (kind == 3) w = std::ldexp(random.Uniform(0, 1), -20) + (k == 0 ? 0 : 1);
      const double x = kind == 4 ? 20 + random.Uniform(0, 2) : random.Uniform(-20, 100);
      const double y = kind == 4 ? 10 + random.Uniform(0, 2) : random.Uniform(-20, 50);
      if (space == RasterSpace::kWindow) w = 1;
      mesh.positions.push_back(static_cast<float>(x * w));
      mesh.positions.push_back(static_cast<float>(y * w));
      mesh.positions.push_back(0);
      if (space != RasterSpace::kWindow) mesh.positions.push_back(static_cast<float>(w));
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
      for (int c = 0; c < kTestChannels; ++c) {
        const double number = numbers == 0   ? about + c
                              : numbers == 1 ? 1e6 + random.Uniform(-1, 1)
                              : numbers == 2 ? 0
                              : numbers == 3 ? random.Integer(-1, 1) * std::ldexp(1, -80)
                                             : random.Uniform(-2, 2);
        mesh.numbers.push_back(static_cast<float>(number));
      }
    }
  }
  return mesh;
}

std::vector<std::uint32_t> IdsOf(const ValueMesh& mesh) {
  std::vector<std::uint32_t> ids(std::size_t{kValuesWidth} * kValuesHeight);
  const RasterTarget target{.output = RasterOutput::kIds,
                            .width = kValuesWidth,
                            .height = kValuesHeight,
                            .pitch = 4 * kValuesWidth,
                            .memory = std::as_writable_bytes(std::span(ids))};
  Clear(target);
  Rasterize(mesh.Mesh(), target);
  return ids;
}

struct ValueCorners {
  std::array<double, 3> x, y, w, a;

  ValueCorners(const ValueMesh& mesh, std::uint32_t triangle, int channel) : x(), y(), w(), a() {
    const bool is_window = mesh.space == RasterSpace::kWindow;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = mesh.indices[std::size_t{3} * triangle + k];
      const float* const v = &mesh.positions[(is_window ? 3 : 4) * vertex];
      x[k] = v[0];
      y[k] = v[1];
      w[k] = is_window ? 1 : v[3];
      a[k] = mesh.numbers[kTestChannels * vertex + static_cast<std::size_t>(channel)];
    }
  }
  exact::HomogeneousTriangle Triangle() const {
    const auto corner = [&](std::size_t k) {
      return exact::HomogeneousPoint{exact::Rational(x[k]), exact::Rational(y[k]),
                                     exact::Rational(w[k])};
    };
    return {corner(0), corner(1), corner(2)};
  }
};

struct Shown {
  float value = 0, dx = 0, dy = 0;
};

// The definition: planes in double, rounded; then float32 from the left to the right.
Shown Defined(const ValueCorners& v, bool is_clip, RasterInterpolation interpolation, int column,
              int row) {
  const bool is_linear = interpolation == RasterInterpolation::kLinear;
  std::array<std::array<double, 3>, 3> beta;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    beta[i] = {v.y[j] * v.w[k] - v.w[j] * v.y[k], v.w[j] * v.x[k] - v.x[j] * v.w[k],
               v.x[j] * v.y[k] - v.y[j] * v.x[k]};
  }
  std::array<double, 3> n{};
  std::array<double, 3> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] += beta[i][k] * (is_linear ? v.a[i] * v.w[i] : v.a[i]);
      d[k] += beta[i][k];
    }
  }
  const bool divides = is_clip && !is_linear;
  if (!divides) d = {0, 0, beta[0][0] * v.x[0] + beta[0][1] * v.y[0] + beta[0][2] * v.w[0]};
  const auto most = [](const std::array<double, 3>& line) {
    return std::fabs(line[0]) * kValuesWidth + std::fabs(line[1]) * kValuesHeight +
           std::fabs(line[2]);
  };
  const double reach = std::max(most(n), most(d));
  const double scale = divides ? std::ldexp(1, 100 - std::ilogb(reach)) : 1 / d[2];
  std::array<float, 3> fn{};
  std::array<float, 3> fd{};
  for (std::size_t k = 0; k < 3; ++k) {
    fn[k] = static_cast<float>(n[k] * scale);
    fd[k] = static_cast<float>(d[k] * scale);
  }
  const float x = static_cast<float>(column) + 0.5F;
  const float y = static_cast<float>(row) + 0.5F;
  const float top = (fn[2] + fn[1] * y) + fn[0] * x;
  if (!divides) return {top, fn[0], fn[1]};
  const float bottom = (fd[2] + fd[1] * y) + fd[0] * x;
  const float value = top / bottom;
  return {value, (fn[0] - value * fd[0]) / bottom, (fn[1] - value * fd[1]) / bottom};
}

template <class Visit>
void ForEachPixel(const ValueMesh& mesh, const Visit& visit) {
  const std::vector<std::uint32_t> ids = IdsOf(mesh);
  for (int y = 0; y < kValuesHeight; ++y) {
    for (int x = 0; x < kValuesWidth; ++x) {
      for (int c = 0; c < kTestChannels; ++c) {
        const std::size_t at = static_cast<std::size_t>(c * kValuesHeight + y) * kTestPitch +
                               static_cast<std::size_t>(x);
        visit(ids[static_cast<std::size_t>(y * kValuesWidth + x)], c, x, y, at);
      }
    }
  }
}

std::uint32_t Bits(float value) { return std::bit_cast<std::uint32_t>(value); }

class RasterizeValuesTest
    : public testing::TestWithParam<std::tuple<RasterSpace, RasterInterpolation>> {
 protected:
  static ValueMesh Drawn(std::uint64_t seed) {
    return RandomValueMesh(seed, std::get<0>(GetParam()));
  }
  static RasterInterpolation Interpolated() { return std::get<1>(GetParam()); }
};

TEST_P(RasterizeValuesTest, AreWhatPlainLoopsDefineByEveryInstructionSet) {
  int compared = 0;
  for (int seed = 0; seed < Cases(12); ++seed) {
    const ValueMesh mesh = Drawn(static_cast<std::uint64_t>(seed));
    for (const InstructionSet set : kSetsOfValues) {
      if (!IsSupported(set)) continue;
      Planes planes;
      RasterizeValues(mesh.Mesh(), In(mesh, planes, Interpolated(), RasterRounding::kFast), set);
      ForEachPixel(mesh, [&](std::uint32_t id, int c, int x, int y, std::size_t at) {
        Shown expected{kUntouched, kUntouched, kUntouched};
        if (id != kNoTriangle) {
          expected = Defined(ValueCorners(mesh, id, c), mesh.space != RasterSpace::kWindow,
                             Interpolated(), x, y);
          ++compared;
        }
        ASSERT_EQ(Bits(planes.values[at]), Bits(expected.value)) << x << ", " << y;
        ASSERT_EQ(Bits(planes.dx[at]), Bits(expected.dx)) << x << ", " << y;
        ASSERT_EQ(Bits(planes.dy[at]), Bits(expected.dy)) << x << ", " << y;
      });
    }
  }
  EXPECT_GT(compared, 1000);
}

struct Largest {
  double value = 0, derivative = 0;
  int judged = 0;
};

double ShareOf(float shown, const exact::Rational& exact, const exact::Rational& condition,
               double conditions, double lost) {
  const exact::Rational off = (exact::Rational(shown) - exact).Abs();
  return (off / (condition * exact::Rational(conditions * 0x1p-24) + lost)).ToDouble();
}

void Judge(const ValueCorners& v, Interpolation interpolation, int column, int row,
           const Shown& shown, Largest& largest) {
  const exact::Interpolant interpolant(v.Triangle(), {column + 0.5, row + 0.5});
  const exact::Attribute a = exact::ToAttribute(v.a);
  const auto exact = interpolant.Derivatives(interpolation, a);
  const auto condition = interpolant.Conditions(interpolation, a);
  const auto ones = interpolant.Conditions(interpolation, exact::Ones());
  if (!exact || !condition || condition->value.Sign() == 0) return;
  // C of equal numbers is twice sum M_i / |d|.
  const double off = kValueConditions * 0x1p-24 * ones->value.ToDoubleUp() / 2;
  if (off >= 0.5) return;
  ++largest.judged;
  largest.value = std::max(largest.value, ShareOf(shown.value, exact->value, condition->value,
                                                  kValueConditions / (1 - off), 0x1p-149));
  const double grown = kDerivativeConditions / ((1 - off) * (1 - off));
  largest.derivative =
      std::max({largest.derivative, ShareOf(shown.dx, exact->dx, condition->dx, grown, 0x1p-126),
                ShareOf(shown.dy, exact->dy, condition->dy, grown, 0x1p-126)});
}

Interpolation OracleOf(RasterInterpolation interpolation) {
  return interpolation == RasterInterpolation::kLinear ? Interpolation::kLinear
                                                       : Interpolation::kPerspective;
}

TEST_P(RasterizeValuesTest, StayWithinTheirBound) {
  Largest largest;
  for (int seed = 0; seed < Cases(16); ++seed) {
    const ValueMesh mesh = Drawn(static_cast<std::uint64_t>(100 + seed));
    Planes planes;
    RasterizeValues(mesh.Mesh(), In(mesh, planes, Interpolated(), RasterRounding::kFast));
    ForEachPixel(mesh, [&](std::uint32_t id, int c, int x, int y, std::size_t at) {
      if (id == kNoTriangle || (x + 3 * y) % 17 != 0) return;
      const Shown shown{planes.values[at], planes.dx[at], planes.dy[at]};
      Judge(ValueCorners(mesh, id, c), OracleOf(Interpolated()), x, y, shown, largest);
    });
  }
  std::printf("largest error / bound: value %.3f, derivative %.3f of %d\n", largest.value,
              largest.derivative, largest.judged);
  EXPECT_LE(largest.value, 1);
  EXPECT_LE(largest.derivative, 1);
  EXPECT_GT(largest.value, 0.1 / (kOneCaseIn > 1 ? 8 : 1));
  EXPECT_GT(largest.judged, 100);
}

TEST_P(RasterizeValuesTest, AreCorrectlyRoundedByEveryInstructionSet) {
  int judged = 0;
  for (int seed = 0; seed < Cases(12); ++seed) {
    const ValueMesh mesh = Drawn(static_cast<std::uint64_t>(200 + seed));
    std::optional<std::vector<float>> first;
    for (const InstructionSet set : kSetsOfValues) {
      if (!IsSupported(set)) continue;
      Planes planes;
      RasterizeValues(mesh.Mesh(), In(mesh, planes, Interpolated(), RasterRounding::kNearest), set);
      if (!first) first = planes.values;
      ASSERT_EQ(planes.values, *first) << static_cast<int>(set);
    }
    ForEachPixel(mesh, [&](std::uint32_t id, int c, int x, int y, std::size_t at) {
      if (id == kNoTriangle || (x + 2 * y) % 11 != 0) return;
      const ValueCorners v(mesh, id, c);
      const auto exact = exact::Interpolant(v.Triangle(), {x + 0.5, y + 0.5})
                             .Value(OracleOf(Interpolated()), exact::ToAttribute(v.a));
      ASSERT_TRUE(exact.has_value());
      ASSERT_EQ(Bits((*first)[at]), Bits(exact->ToFloat() + 0.0F)) << x << ", " << y;
      ++judged;
    });
  }
  EXPECT_GT(judged, 500);
}

// All pixels of triangles whose values lie on middles of floats, or beside them.
TEST_P(RasterizeValuesTest, RoundTiesToEven) {
  ValueMesh mesh;
  mesh.space = std::get<0>(GetParam());
  for (int t = 0; t < 8; ++t) {
    constexpr std::array<std::array<float, 2>, 3> kPlaces{{{0, 0}, {64, 0}, {0, 64}}};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const float w = mesh.space == RasterSpace::kWindow ? 1.0F : std::ldexp(1.0F, 3 * t);
      mesh.positions.insert(mesh.positions.end(), {kPlaces[k][0] * w, kPlaces[k][1] * w, 0});
      if (mesh.space != RasterSpace::kWindow) mesh.positions.push_back(w);
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
      // Steps of 1/128 ulp at halves of pixels: one in 64 is a tie.
      for (int c = 0; c < kTestChannels; ++c) {
        mesh.numbers.push_back(1 + static_cast<float>((k == 1 ? 1 : 0) + t + c) * 0x1p-23F);
      }
    }
  }
  Planes planes;
  RasterizeValues(mesh.Mesh(), In(mesh, planes, Interpolated(), RasterRounding::kNearest));
  ForEachPixel(mesh, [&](std::uint32_t id, int c, int x, int y, std::size_t at) {
    if (id == kNoTriangle) return;
    const ValueCorners v(mesh, id, c);
    const auto exact = exact::Interpolant(v.Triangle(), {x + 0.5, y + 0.5})
                           .Value(OracleOf(Interpolated()), exact::ToAttribute(v.a));
    ASSERT_EQ(planes.values[at], exact->ToFloat());
  });
}

INSTANTIATE_TEST_SUITE_P(
    All, RasterizeValuesTest,
    testing::Values(std::tuple(RasterSpace::kWindow, RasterInterpolation::kLinear),
                    std::tuple(RasterSpace::kClip, RasterInterpolation::kPerspective),
                    std::tuple(RasterSpace::kClip, RasterInterpolation::kLinear)));

// A column of ties of which the denominator is another at each pixel: with w 1, 2^k, 1 the corner
// in the middle has the weight 1/2 where x is 2^k / (1 + 2^k) of its own.
TEST(RasterizeValues, RoundTiesInPerspectiveToEven) {
  int ties = 0;
  for (int k = 1; k <= 6; ++k) {
    for (int column = 2; column < 60; ++column) {
      const float w = std::ldexp(1.0F, k);
      const float x = (static_cast<float>(column) + 0.5F) * (1 + 1 / w);
      ValueMesh mesh{{0, 0, 0, 1, x * w, 0, 0, w, 0, 64, 0, 1}, {0, 1, 2}, {}, RasterSpace::kClip};
      for (int corner = 0; corner < 3; ++corner) {
        for (int c = 0; c < kTestChannels; ++c) {  // 1 + 2^-24, 1 + 3 2^-24, ...
          mesh.numbers.push_back(1 + static_cast<float>(c + (corner == 1 ? 1 : 0)) * 0x1p-23F);
        }
      }
      for (const int channels : {1, kTestChannels}) {
        for (const InstructionSet set : kSetsOfValues) {
          if (!IsSupported(set)) continue;
          ValueMesh shown = mesh;
          Planes planes;
          RasterValues values =
              In(shown, planes, RasterInterpolation::kPerspective, RasterRounding::kNearest);
          if (channels == 1) shown.numbers = {mesh.numbers[0], mesh.numbers[3], mesh.numbers[6]};
          values.numbers = shown.numbers;
          values.channels = channels;
          RasterizeValues(shown.Mesh(), values, set);
          for (int c = 0; c < channels; ++c) {
            const std::size_t at = static_cast<std::size_t>(c * kValuesHeight) * kTestPitch +
                                   static_cast<std::size_t>(column);
            ASSERT_EQ(planes.values[at], 1 + static_cast<float>((c + 1) / 2 * 2) * 0x1p-23F)
                << k << ", " << column << ", " << static_cast<int>(set);
            ++ties;
          }
        }
      }
    }
  }
  EXPECT_GT(ties, 1000);
}

TEST(RasterizeValues, NumbersThatAreNotFiniteGiveNaN) {
  ValueMesh mesh{{0, 0, 0, 20, 0, 0, 0, 20, 0}, {0, 1, 2}, {}, RasterSpace::kWindow};
  mesh.numbers = {1, 2, 3, 1, std::numeric_limits<float>::infinity(), 3, 1, 2, 3};
  for (const RasterRounding rounding : {RasterRounding::kFast, RasterRounding::kNearest}) {
    Planes planes;
    RasterizeValues(mesh.Mesh(), In(mesh, planes, RasterInterpolation::kLinear, rounding));
    EXPECT_EQ(planes.values[0], 1);
    EXPECT_TRUE(std::isnan(planes.values[kTestPitch * kValuesHeight]));
    EXPECT_EQ(planes.values[2 * kTestPitch * kValuesHeight], 3);
  }
}

TEST(RasterizeValues, RefusesWhatIsNotAsItsDomainSays) {
  const ValueMesh mesh = RandomValueMesh(1, RasterSpace::kClip);
  Planes planes;
  const RasterValues good =
      In(mesh, planes, RasterInterpolation::kPerspective, RasterRounding::kFast);
  const auto refused = [&](const auto& spoil) {
    RasterValues values = good;
    spoil(values);
    EXPECT_THROW(RasterizeValues(mesh.Mesh(), values), InputError);
  };
  EXPECT_NO_THROW(RasterizeValues(mesh.Mesh(), good));
  refused([](RasterValues& v) { v.channels = 0; });
  refused([](RasterValues& v) { v.channels = kMostRasterChannels + 1; });
  refused([](RasterValues& v) { v.channels = 2; });
  refused([](RasterValues& v) { v.width = 0; });
  refused([](RasterValues& v) { v.pitch = kValuesWidth - 1; });
  refused([](RasterValues& v) { v.values = v.values.first(v.values.size() - kTestPitch); });
  refused([](RasterValues& v) { v.dy = {}; });
  refused([](RasterValues& v) { v.rounding = RasterRounding::kNearest; });
  refused([](RasterValues& v) { v.rounding = static_cast<RasterRounding>(9); });
  refused([](RasterValues& v) { v.interpolation = static_cast<RasterInterpolation>(9); });
}

}  // namespace
}  // namespace rasterproof
