// The widths of integer edge functions: the figures of a known unit, and every input of tiny ones.
#include "exact/edge_widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "gtest/gtest.h"
#include "tests/share.h"

namespace rasterproof::exact {
namespace {

EdgeUnit UnitOf(int integer_bits, int fraction_bits, int side, int tile, bool is_signed = true) {
  return {{integer_bits, fraction_bits, is_signed, false}, side, side, tile};
}

std::map<std::string, int> BitsOf(const EdgeUnit& unit) {
  std::map<std::string, int> bits;
  for (const EdgeWidth& width : EdgeWidths(unit)) bits[width.id] = width.bits;
  return bits;
}

TEST(EdgeWidths, AreTheKnownOnesOfSigned12Point4On4096) {
  const auto bits = BitsOf(UnitOf(12, 4, 4096, 8));
  const std::map<std::string, int> known = {
      {"direct-b-a", 17},       {"direct-p-a-box", 17},      {"direct-e-box", 33},
      {"area-e-vertex", 33},    {"direct-e-target", 34},     {"direct-e-corner", 34},
      {"affine-c", 32},         {"direct-e-pixel-past", 35}, {"stepped-e-tile-past", 35},
      {"stepped-step", 21},     {"stepped-tile-step", 24},   {"affine-c-product", 32},
      {"direct-p-a-target", 18}};
  for (const auto& [id, value] : known) {
    ASSERT_TRUE(bits.contains(id)) << id;
    EXPECT_EQ(bits.at(id), value) << id;
  }
}

TEST(SignedBits, AreThoseOfTwosComplement) {
  EXPECT_EQ(SignedBits(0, 0), 1);
  EXPECT_EQ(SignedBits(-1, 0), 1);
  EXPECT_EQ(SignedBits(0, 1), 2);
  EXPECT_EQ(SignedBits(-128, 127), 8);
  EXPECT_EQ(SignedBits(-128, 128), 9);
  EXPECT_EQ(SignedBits(-129, 0), 9);
}

// A second definition: the formulas as they are written, in 64 bits, at every input.
struct Ends {
  std::int64_t least = INT64_MAX;
  std::int64_t most = INT64_MIN;
  void Take(std::int64_t value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  int Bits() const {
    int bits = 1;
    while (least < -(std::int64_t{1} << (bits - 1)) || most >= std::int64_t{1} << (bits - 1)) {
      ++bits;
    }
    return bits;
  }
};

struct Axis {
  std::vector<std::int64_t> vertices;
  std::vector<std::pair<std::int64_t, std::int64_t>> points;
};

using PlainEnds = std::map<std::string, Ends>;

void TakeEdge(const Axis& of, std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by,
              const std::string& place, PlainEnds& ends) {
  for (const auto& [px, py] : of.points) {
    const std::int64_t e = (px - ax) * (by - ay) - (py - ay) * (bx - ax);
    ends["direct-e-" + place].Take(e);
    ends["biased-e-" + place].Take(e);
    ends["biased-e-" + place].Take(e - 1);
    ends["direct-p-a-" + place].Take(px - ax);
    ends["direct-p-a-" + place].Take(py - ay);
    ends["direct-product-" + place].Take((px - ax) * (by - ay));
    ends["direct-product-" + place].Take((py - ay) * (ax - bx));
    ends["affine-product-" + place].Take((by - ay) * px);
    ends["affine-product-" + place].Take((ax - bx) * py);
    ends["affine-sum-" + place].Take((by - ay) * px + (ax - bx) * py);
    ends["affine-c"].Take(ay * bx - ax * by);
    ends["affine-c-product"].Take(ay * bx);
    ends["direct-b-a"].Take(bx - ax);
  }
}

// By every edge between grid points of the format, at every point of the place.
PlainEnds ByEveryInput(const Axis& axis, const std::string& place) {
  PlainEnds ends;
  for (const std::int64_t ax : axis.vertices) {
    for (const std::int64_t ay : axis.vertices) {
      for (const std::int64_t bx : axis.vertices) {
        for (const std::int64_t by : axis.vertices) TakeEdge(axis, ax, ay, bx, by, place, ends);
      }
    }
  }
  return ends;
}

std::vector<std::int64_t> Every(std::int64_t step, std::int64_t first, std::int64_t last) {
  std::vector<std::int64_t> list;
  for (std::int64_t n = first; n <= last; n += step) list.push_back(n);
  return list;
}

using PlainPoints = std::vector<std::pair<std::int64_t, std::int64_t>>;

PlainPoints Squared(const std::vector<std::int64_t>& list) {
  PlainPoints points;
  for (const std::int64_t x : list) {
    for (const std::int64_t y : list) points.emplace_back(x, y);
  }
  return points;
}

// The samples of the pixels [first, end) on both axes that lie at `last` or before it.
PlainPoints SamplesUpTo(const EdgeUnit& unit, int first, int end, std::int64_t last) {
  PlainPoints points;
  for (const Point2& l : unit.pattern.locations) {
    for (int i = first; i < end; ++i) {
      for (int j = first; j < end; ++j) {
        const auto x = static_cast<std::int64_t>(std::ldexp(i + l.x, unit.UnitBits()));
        const auto y = static_cast<std::int64_t>(std::ldexp(j + l.y, unit.UnitBits()));
        if (x <= last && y <= last) points.emplace_back(x, y);
      }
    }
  }
  return points;
}

void ExpectTheWidthsOfEveryInput(const EdgeUnit& unit, std::int64_t step, std::int64_t first,
                                 std::int64_t last) {
  const std::int64_t pixel = std::int64_t{1} << unit.UnitBits();
  const std::int64_t tile = unit.tile * pixel;
  const std::int64_t tiles = (unit.width + unit.tile - 1) / unit.tile;
  const int side = unit.width;
  const std::map<std::string, PlainPoints> places = {
      {"box", SamplesUpTo(unit, 0, side, last)},
      {"target", SamplesUpTo(unit, 0, side, INT64_MAX)},
      {"corner", Squared(Every(tile, 0, tiles * tile))},
      {"pixel-past", SamplesUpTo(unit, -1, side + 1, INT64_MAX)},
      {"tile-past", Squared(Every(tile, -tile, (tiles + 1) * tile))},
      {"offset", SamplesUpTo(unit, 0, 1, INT64_MAX)}};
  const auto bits = BitsOf(unit);
  int compared = 0;
  for (const auto& [place, points] : places) {
    for (const auto& [id, ends] : ByEveryInput({Every(step, first, last), points}, place)) {
      if (place == "offset" && id != "affine-product-offset" && id != "affine-sum-offset") continue;
      ASSERT_TRUE(bits.contains(id)) << id;
      EXPECT_EQ(bits.at(id), ends.Bits()) << id << ": " << ends.least << " to " << ends.most;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 5 * 9 + 2);
}

TEST(EdgeWidths, AreThoseOfEveryInputOfATinyFormat) {
  if (kOneCaseIn > 1) return ExpectTheWidthsOfEveryInput(UnitOf(2, 1, 4, 2), 1, -4, 3);
  ExpectTheWidthsOfEveryInput(UnitOf(3, 1, 4, 2), 1, -8, 7);
}

TEST(EdgeWidths, AreThoseOfEveryInputWithoutASign) {
  ExpectTheWidthsOfEveryInput(UnitOf(2, 1, 3, 2, false), 1, 0, 7);
}

TEST(EdgeWidths, OfWholePixelsCountInHalves) {
  ExpectTheWidthsOfEveryInput(UnitOf(3, 0, 4, 4), 2, -8, 6);
}

EdgeUnit WithSamples(EdgeUnit unit, std::vector<Point2> locations) {
  unit.pattern.locations = std::move(locations);
  return unit;
}

// A quarter of a pixel is finer than the vertices: their step is two units.
TEST(EdgeWidths, AreThoseOfEveryInputAtOtherSamples) {
  ExpectTheWidthsOfEveryInput(WithSamples(UnitOf(3, 0, 5, 2), {{0, 0}}), 1, -4, 3);
  if (kOneCaseIn > 1) return;
  ExpectTheWidthsOfEveryInput(WithSamples(UnitOf(2, 1, 4, 2), {{0.25, 0.75}}), 2, -8, 6);
  ExpectTheWidthsOfEveryInput(
      WithSamples(UnitOf(2, 1, 3, 2, false), {{0.75, 0.25}, {0, 0.5}, {0.5, 0}}), 2, 0, 14);
  if (!RunsMore()) return;
  ExpectTheWidthsOfEveryInput(WithSamples(UnitOf(3, 1, 4, 2), {{0.25, 0.75}}), 2, -16, 14);
  ExpectTheWidthsOfEveryInput(WithSamples(UnitOf(3, 1, 4, 2), {{0, 0}}), 1, -8, 7);
}

// No vertex reaches the sample at the pixel's far corner; the other one decides the box.
TEST(EdgeWidths, LeaveASampleOutThatNoVertexReaches) {
  ExpectTheWidthsOfEveryInput(WithSamples(UnitOf(1, 1, 1, 1), {{0.5, 0.5}, {0.75, 0.75}}), 2, -4,
                              2);
}

TEST(EdgeWidths, OfFourStandardSamplesCountInEighths) {
  EdgeUnit unit = UnitOf(12, 2, 4096, 8);
  EXPECT_EQ(unit.UnitBits(), 2);
  const int at_centres = BitsOf(unit).at("direct-e-target");
  unit.pattern = *StandardPattern(4);
  EXPECT_EQ(unit.UnitBits(), 3);
  EXPECT_EQ(BitsOf(unit).at("direct-e-target"), at_centres + 2);
}

// b -> a has -E: from -m to m, of which two's complement holds -m - 1 as well.
TEST(EdgeWidths, OfEHoldTheBiasOfTheTieRuleAsWell) {
  for (const EdgeUnit& unit :
       {UnitOf(12, 4, 4096, 8), UnitOf(2, 0, 2, 1), UnitOf(2, 1, 4, 1, false),
        WithSamples(UnitOf(6, 2, 64, 8), {{0.125, 0.875}, {0.5, 0}})}) {
    int compared = 0;
    const auto bits = BitsOf(unit);
    for (const auto& [id, n] : bits) {
      if (!id.starts_with("biased")) continue;
      EXPECT_EQ(n, bits.at("direct" + id.substr(6))) << id;
      ++compared;
    }
    EXPECT_EQ(compared, 5);
  }
}

TEST(EdgeWidths, OneBitLessLosesTheWitness) {
  for (const EdgeUnit& unit : {UnitOf(12, 4, 4096, 8), UnitOf(3, 1, 4, 2), UnitOf(24, 8, 600, 16),
                               UnitOf(31, 16, 65536, 64), UnitOf(4, 2, 9, 4, false),
                               WithSamples(UnitOf(6, 2, 64, 8), {{0.125, 0.875}, {0.5, 0}})}) {
    for (const EdgeWidth& width : EdgeWidths(unit)) {
      EXPECT_EQ(WrappedTo(width.extreme, width.bits), width.extreme) << width.id;
      EXPECT_NE(WrappedTo(width.extreme, width.bits - 1), width.extreme) << width.id;
      EXPECT_TRUE(width.extreme == width.least || width.extreme == width.most) << width.id;
      if (width.value.starts_with("E")) {
        const EdgeInteger bias = EdgeOf(width.witness) - width.extreme;
        EXPECT_TRUE(bias == 0 || (width.form == "biased" && bias == 1)) << width.id;
      }
    }
  }
}

// Whether the sample is covered, if E(a, b; p) of each edge is kept in so many bits.
bool IsCoveredInBits(const Scene& scene, int x, int y, int unit_bits, int bits) {
  const auto units = [&](double v) { return static_cast<std::int64_t>(std::ldexp(v, unit_bits)); };
  const std::int64_t px = units(x + 0.5);
  const std::int64_t py = units(y + 0.5);
  int positive = 0;
  int negative = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& a = scene.vertices[k];
    const Vertex& b = scene.vertices[(k + 1) % 3];
    const EdgeInteger e =
        WrappedTo(EdgeOf({units(a.x), units(a.y), units(b.x), units(b.y), px, py}), bits);
    positive += e > 0 ? 1 : 0;
    negative += e < 0 ? 1 : 0;
  }
  return positive == 3 || negative == 3;
}

// A planted narrowing: the witness's own sample is decided wrongly by one bit less, and rightly by
// the width that is told. No sample may lie on an edge, or a tie rule would speak.
TEST(WitnessScene, IsDrawnWronglyByARegisterOfOneBitLess) {
  for (const EdgeUnit& unit : {UnitOf(12, 4, 64, 8), UnitOf(6, 2, 64, 8), UnitOf(5, 3, 64, 4)}) {
    for (const EdgeWidth& width : EdgeWidths(unit)) {
      if (width.id != "direct-e-box" && width.id != "direct-e-target") continue;
      const Scene scene = WitnessScene(unit, width);
      const std::int64_t pixel = std::int64_t{1} << unit.UnitBits();
      const int x = static_cast<int>(width.witness.px / pixel);
      const int y = static_cast<int>(width.witness.py / pixel);
      const auto truth = Coverage(scene, Profile{});
      const bool is_covered = truth.Count(truth.Index(x, y)) != 0;
      EXPECT_EQ(IsCoveredInBits(scene, x, y, unit.UnitBits(), width.bits), is_covered) << width.id;
      EXPECT_NE(IsCoveredInBits(scene, x, y, unit.UnitBits(), width.bits - 1), is_covered)
          << width.id << " of " << unit.input.integer_bits << '.' << unit.input.fraction_bits;
    }
  }
}

TEST(InputsBeyondBits, HaveTheWrongSignInARegisterOfSoManyBits) {
  for (const EdgeUnit& unit :
       {UnitOf(12, 4, 4096, 8), UnitOf(12, 0, 4096, 8, false), UnitOf(7, 2, 64, 8)}) {
    std::map<std::string, int> widest;
    for (const EdgeWidth& width : EdgeWidths(unit)) widest[width.id] = width.bits;
    std::map<std::string, int> beyond;
    for (const EdgeWidth& input : InputsBeyondBits(unit)) {
      const int bits = input.bits - 1;
      EXPECT_EQ(SignedBits(input.extreme, input.extreme), input.bits) << input.id;
      EXPECT_NE(WrappedTo(input.extreme, bits) > 0, input.extreme > 0) << input.id;
      ++beyond[input.id.substr(0, input.id.find("-beyond-"))];
      if (input.form != "area") continue;
      EXPECT_EQ(EdgeOf(input.witness), input.extreme) << input.id;
      const Scene scene = WitnessScene(unit, input);
      const double unit_of_area = std::ldexp(1, -2 * unit.UnitBits());
      const auto& v = scene.vertices;
      EXPECT_EQ((v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x),
                static_cast<double>(input.extreme) * unit_of_area);
    }
    for (const std::string id : {"area-e-vertex", "direct-e-box", "stepped-e-target"}) {
      EXPECT_EQ(beyond[id], widest[id] - 1 - kFewestEdgeBits) << id;
    }
  }
}

// An area of 4095^2, in quarters of a pixel, is 4 in 12 bits: the extreme input passes there.
TEST(InputsBeyondBits, FindWhatTheExtremeInputMisses) {
  const EdgeUnit unit = UnitOf(12, 0, 64, 8, false);
  const std::vector<EdgeWidth> widths = EdgeWidths(unit);
  const auto area = std::ranges::find(widths, "area-e-vertex", &EdgeWidth::id);
  EXPECT_EQ(WrappedTo(area->extreme, 12) > 0, area->extreme > 0);
  const std::vector<EdgeWidth> inputs = InputsBeyondBits(unit);
  const auto beyond = std::ranges::find(inputs, "area-e-vertex-beyond-12", &EdgeWidth::id);
  ASSERT_NE(beyond, inputs.end());
  EXPECT_NE(WrappedTo(beyond->extreme, 12) > 0, beyond->extreme > 0);
}

TEST(EdgeWidths, WantASampleInTheRange) {
  EXPECT_THROW(EdgeWidths(UnitOf(1, 0, 4, 2)), InputError);
  EXPECT_NO_THROW(EdgeWidths(UnitOf(1, 1, 4, 2, false)));
}

}  // namespace
}  // namespace rasterproof::exact
