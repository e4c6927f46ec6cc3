#include "props/codec/codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/fixed_input.h"
#include "core/ulp.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/near_edge.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

std::vector<std::uint8_t> RandomBytes(std::uint64_t index, std::size_t count) {
  PhiloxSource random(1, index);
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.Bits(8));
  return bytes;
}

TEST(Codec, MakesAValidCaseOfEveryByteString) {
  for (const SubjectInfo& info : {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(4)}) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const Case c = DecodeCase(RandomBytes(i, i % 100), info);
      ASSERT_TRUE(Takes(info, c.scene));
      ASSERT_FALSE(c.scene.triangles.empty());
      for (const Triangle& t : c.scene.triangles) {
        for (const std::int32_t index : t) {
          ASSERT_TRUE(index >= 0 && index < static_cast<std::int32_t>(c.scene.vertices.size()));
        }
      }
      for (const Vertex& v : c.scene.vertices) {
        if (c.scene.precision == Precision::kFloat32) {
          ASSERT_TRUE(IsFloat32(v.x) && IsFloat32(v.y));
        }
      }
    }
  }
}

TEST(Codec, GivesTheSameCaseForTheSameBytes) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    std::vector<std::uint8_t> bytes = RandomBytes(i, 80);
    bytes[0] &= 0x7f;  // spelled out: no NaN, which is not equal to itself
    EXPECT_EQ(DecodeCase(bytes, RealInfo()), DecodeCase(bytes, RealInfo()));
  }
}

// On a grid a step beyond the largest number is an infinity, which lies at no anchor.
TEST(Codec, ReadsBackTheLargestNumbers) {
  for (const Precision input : {Precision::kFloat32, Precision::kFloat64}) {
    SubjectInfo info = SnappedInfo(4);
    info.input = input;
    const double most = input == Precision::kFloat32 ? double{std::numeric_limits<float>::max()}
                                                     : std::numeric_limits<double>::max();
    info.profile.coordinate_limit = most;
    Case c = DecodeCase(RandomBytes(1, 0), info);
    c.options = {};
    c.scene.precision = input;
    c.scene.vertices = {{most, -most}, {-most, most}, {0.5, most}};
    c.scene.triangles = {{0, 1, 2}};
    EXPECT_EQ(DecodeCase(EncodeCase(c, info), info).scene.vertices, c.scene.vertices);
  }
}

TEST(Codec, PutsHardPlacesOneByteApart) {
  // A square from the centre of pixel 0 to that of pixel 10, split by its diagonal.
  const std::vector<std::uint8_t> quad{0,  11, 11, 1, 9, 0, 9, 0, 9, 0, 29, 0, 29, 0,
                                       29, 0,  29, 0, 9, 0, 1, 0, 0, 0, 3,  0, 0};
  const NearEdgeCounts on = CountNearEdges(DecodeCase(quad, RealInfo()));
  EXPECT_GT(on.on_edge, 20U);
  EXPECT_EQ(on.within_1, 0U);
  std::vector<std::uint8_t> moved = quad;
  moved[5] = 128;  // the first vertex's x: one step
  const NearEdgeCounts beside = CountNearEdges(DecodeCase(moved, RealInfo()));
  EXPECT_LT(beside.on_edge, on.on_edge);
  EXPECT_GT(beside.within_1, 0U);
}

TEST(Codec, FindsADoubleCoveredEdgeWithinHundredsOfRandomStrings) {
  auto subject = testing::Inclusive(RealInfo());
  std::uint64_t executions = 0;
  for (; executions < 2000; ++executions) {
    std::vector<std::uint8_t> bytes = RandomBytes(executions, 60);
    bytes[0] = 0;  // the spelled-out part, no recipe
    const Case c = DecodeCase(bytes, RealInfo());
    if (testing::CoverageIsTheModels(subject, c).outcome == Outcome::kViolated) break;
  }
  RecordProperty("executions", std::to_string(executions));
  EXPECT_LT(executions, 400U);
}

TEST(Codec, NamesADomainByItsNumberWhateverOthersThereAre) {
  const std::vector<std::uint8_t> rest = RandomBytes(5, 80);
  const auto named = [&](std::uint8_t number) {
    std::vector<std::uint8_t> bytes{192, number};
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return DecodeCase(bytes, RealInfo());
  };
  const Domain& near_edge = *FindDomain("near-edge");
  ByteSource bits(rest);
  const Case drawn = near_edge.draw(bits, RealInfo());
  EXPECT_EQ(named(static_cast<std::uint8_t>(near_edge.number)).scene.vertices,
            drawn.scene.vertices);
  EXPECT_EQ(named(static_cast<std::uint8_t>(near_edge.number)).scene.name, "near-edge");
  // No domain's number, and that of one that the subject does not take: spelled out.
  ByteSource spelled(rest);
  const Case lattice = LatticeCase(spelled, RealInfo());
  ASSERT_EQ(DomainOfNumber(255), nullptr);
  EXPECT_EQ(named(255), lattice);
  EXPECT_EQ(named(0), lattice);
  EXPECT_EQ(named(static_cast<std::uint8_t>(FindDomain("mixed-w")->number)), lattice);
}

// The subjects that a code is for: of floats of both kinds, of a grid, of fixed point, of clip
// space.
std::vector<SubjectInfo> InfosToEncodeFor() {
  std::vector<SubjectInfo> infos{RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(4)};
  infos.push_back(SnappedInfo(4));
  infos.back().profile.fixed = FixedInput{.integer_bits = 12, .fraction_bits = 4};
  infos.push_back(RealInfo(Precision::kFloat64));
  infos.back().takes_clip = true;
  infos.push_back(RealInfo());
  infos.back().takes_clip = true;
  infos.back().takes_window = false;
  infos.push_back(RealInfo());
  infos.back().takes_culling = infos.back().takes_scissor = infos.back().takes_tiles = false;
  return infos;
}

std::string HexOf(const std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t kMostShown = 256;
  std::string text;
  for (const std::uint8_t byte : std::span(bytes).first(std::min(bytes.size(), kMostShown))) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += kDigits[byte / 16];
    text += kDigits[byte % 16];
  }
  return text;
}

TEST(EncodeCase, GivesBackEveryCaseOfEveryDomain) {
  constexpr std::uint64_t kCases = 64;
  std::uint64_t encoded = 0;
  for (const SubjectInfo& info : InfosToEncodeFor()) {
    for (const Domain& domain : Domains()) {
      if (!Suits(domain, info)) continue;
      for (std::uint64_t i = 0; i < kCases; ++i) {
        const Case c = DrawCase(info, CaseName{std::string(domain.name), i, 1});
        const std::vector<std::uint8_t> bytes = EncodeCase(c, info);
        ++encoded;
        EXPECT_TRUE(SameCase(DecodeCase(bytes, info), c)) << c.origin << " " << HexOf(bytes);
      }
    }
  }
  EXPECT_GT(encoded, 64U * 100U);
}

TEST(EncodeCase, SpellsOutWhatTheCodeCanSpell) {
  for (const SubjectInfo& info : {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(4)}) {
    for (std::uint64_t i = 0; i < 500; ++i) {
      std::vector<std::uint8_t> given = RandomBytes(i, 100);
      given[0] = 0;
      Case c = DecodeCase(given, info);
      c.options = {};
      if (c.scene.vertices.size() > 16) continue;  // repeated ones
      const std::vector<std::uint8_t> bytes = EncodeCase(c, info);
      EXPECT_EQ(bytes[0], 0) << HexOf(given);
      EXPECT_TRUE(SameCase(DecodeCase(bytes, info), c)) << HexOf(given);
    }
  }
}

TEST(EncodeCase, KeepsEveryBitOfTheRawCode) {
  Case c;
  c.profile = RealInfo(Precision::kFloat64).profile;
  c.scene.name = "named";
  c.scene.width = 65536;
  c.scene.height = 3;
  c.scene.precision = Precision::kFloat64;
  c.scene.vertices = {{-0.0, 0x1p-1074, 7}, {0x1.fffffffffffffp1023, 0.1}, {-3, 4, -0.0}};
  c.scene.triangles = {{0, 1, 2}, {2, 2, 0}};
  c.options = {Cull::kBack, PixelRect{-5, 1, 2147483647, 2}, 64, 3};
  c.origin = "somewhere:1@2";
  const SubjectInfo info = RealInfo(Precision::kFloat64);
  EXPECT_TRUE(SameCase(DecodeCase(EncodeCase(c, info), info), c));
}

TEST(EncodeCase, KeepsOfANaNTheBitsThatTheSubjectsFloatsHave) {
  // Found by the fuzz target codec: z is a double's NaN, for a subject of float32.
  std::vector<std::uint8_t> bytes{255, 0, 1 + 4, 0, 7, 0, 7, 0, 1, 1};
  bytes.insert(bytes.end(), 16, 0);
  for (const int byte : {1, 2, 3, 4, 5, 6, 0xf8, 0x7f}) {
    bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  const Case c = DecodeCase(bytes, RealInfo());
  ASSERT_EQ(c.scene.vertices.size(), 1U);
  EXPECT_TRUE(std::isnan(c.scene.vertices[0].z));
  EXPECT_TRUE(SameCase(DecodeCase(EncodeCase(c, RealInfo()), RealInfo()), c));
}

TEST(EncodeCase, IsTotalBackwards) {
  for (const SubjectInfo& info : InfosToEncodeFor()) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
      std::vector<std::uint8_t> bytes = RandomBytes(i, 2 + i % 90);
      bytes[0] = 255;
      bytes[1] = 0;
      const Case c = DecodeCase(bytes, info);
      ASSERT_TRUE(Takes(info, c.scene)) << HexOf(bytes);
      ASSERT_TRUE(SameCase(DecodeCase(EncodeCase(c, info), info), c)) << HexOf(bytes);
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
