// A name stands for the same case for good and under every compiler: in a bug report it must mean
// one case. A recipe that draws otherwise gets a new number (props/domains/domain.h).
// A recipe that draws twice in a call's arguments, or on both sides of an operator, breaks this:
// C++ leaves the order of such draws open, and g++ and clang differ. Draw into named values, or in
// braces.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sample_pattern.h"
#include "core/square_presets.h"
#include "props/codec/codec.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kBitsSeed = 1;
constexpr std::uint64_t kCases = 64;

// FNV-1a over whole words.
class Hash {
 public:
  void Add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }
  void Add(double x) { Add(x != x ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(x)); }
  void Add(const Case& c) {
    Add(static_cast<std::uint64_t>(c.scene.width));
    Add(static_cast<std::uint64_t>(c.scene.height));
    Add(static_cast<std::uint64_t>(c.scene.clip_space));
    Add(static_cast<std::uint64_t>(c.scene.precision));
    for (const Vertex& v : c.scene.vertices) {
      for (const double x : {v.x, v.y, v.z, v.w}) Add(x);
    }
    for (const Triangle& t : c.scene.triangles) {
      for (const std::int32_t index : t) Add(static_cast<std::uint64_t>(index));
    }
    Add(static_cast<std::uint64_t>(c.options.tile));
    Add(static_cast<std::uint64_t>(c.options.threads));
    Add(static_cast<std::uint64_t>(c.options.cull));
    const PixelRect whole{0, 0, c.scene.width, c.scene.height};
    const PixelRect scissor = c.options.scissor.value_or(whole);
    for (const int side : {scissor.x0, scissor.y0, scissor.x1, scissor.y1}) {
      Add(static_cast<std::uint64_t>(side));
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::vector<SubjectInfo> HashedInfos() {
  SubjectInfo clip = RealInfo();
  clip.takes_window = false;
  clip.takes_clip = true;
  return {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(8), SnappedInfo(4), clip};
}

// Contracts all that some domain is about.
SubjectInfo InfoWith() {
  SubjectInfo info = SnappedInfo(8);
  info.profile.fixed = FixedInput{11, 4, true, true};
  info.profile.max_primitive_extent = MaxPrimitiveExtent{64, 32};
  info.profile.guard_band = WindowBox{-256, -256, 256, 256};
  info.profile.by_target_size.emplace_back();
  info.profile.by_target_size.back().max_width = 32;
  info.profile.by_target_size.back().snap = {2};
  return info;
}

std::vector<SubjectInfo> StatingInfos(const Domain& domain) {
  SubjectInfo several = SnappedInfo(8);
  several.profile.pattern = *StandardPattern(4);
  if (domain.is_stated(several.profile)) {
    SubjectInfo most = RealInfo();
    most.profile.pattern = *StandardPattern(16);
    return {several, most};
  }
  several.profile.sample_positions = SamplePositions::kVary;
  if (domain.is_stated(several.profile)) {
    SubjectInfo fixed = RealInfo();
    fixed.profile.sample_positions = SamplePositions::kFixed;
    return {several, fixed};
  }
  SubjectInfo squares = RealInfo();
  squares.profile = *SquarePreset("voxel");
  if (domain.is_stated(squares.profile)) {
    SubjectInfo banded = SnappedInfo(8);
    banded.profile = *SquarePreset("d3d12-conservative-2");
    return {squares, banded};
  }
  SubjectInfo free = SnappedInfo(8);
  free.profile.freedom.snap_tolerance = 0.6;
  free.profile.translation_invariant = true;
  return {InfoWith(), free};
}

std::uint64_t HashOf(const Domain& domain) {
  Hash hash;
  for (const SubjectInfo& info :
       domain.is_stated == nullptr ? HashedInfos() : StatingInfos(domain)) {
    if (!Suits(domain, info)) continue;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      hash.Add(DrawCase(info, CaseName{std::string(domain.name), i, kBitsSeed}));
    }
  }
  return hash.value();
}

// Of the spelled-out part of the fuzz code: the domains stand for themselves.
std::uint64_t HashOfTheCode() {
  Hash hash;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    PhiloxSource random(kBitsSeed, i);
    std::vector<std::uint8_t> bytes(80);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.Bits(8));
    bytes[0] &= 0x7f;
    for (const SubjectInfo& info : HashedInfos()) hash.Add(DecodeCase(bytes, info));
  }
  return hash.value();
}

// Numbers that are no longer used, and whose they were: a recipe that draws otherwise gets a new
// number, and leaves its old one here, so that nobody takes it again.
constexpr auto kRetired =
    std::to_array<std::pair<std::uint16_t, std::string_view>>({{42, "closed-around-eye"},
                                                               {47, "meshes-around-eye"},
                                                               {54, "least-areas"},
                                                               {59, "many-triangles"},
                                                               {61, "accumulator-ends"},
                                                               {63, "near-rectangles"},
                                                               {71, "every-size"},
                                                               {73, "off-grid-fragments"},
                                                               {74, "tilted-grids"},
                                                               {80, "cameras"},
                                                               {85, "frame-sweeps"}});

constexpr std::uint64_t kGoldenCode = 0x9e9b57d48ef36170;

// As rows spell it.
std::string Hex(std::uint64_t bits) {
  std::ostringstream text;
  text << "0x" << std::hex << bits;
  return text.str();
}

TEST(DomainBits, OfANumberAreTheSameForGoodAndUnderEveryCompiler) {
  for (const Domain& domain : Domains()) {
    EXPECT_EQ(Hex(domain.bits), Hex(HashOf(domain)))
        << domain.name << " draws otherwise than its row says: give a recipe that changed a new "
        << "number, list the old one here, and write what is drawn into its row";
    for (const auto& [number, name] : kRetired) {
      EXPECT_NE(number, domain.number) << "number " << number << " is " << name
                                       << "'s for good: give " << domain.name << " a new one";
    }
  }
}

// A domain that is taken away leaves its number to kRetired. (Of the greatest nothing tells.)
TEST(DomainBits, ANumberIsADomainsOrRetired) {
  std::set<std::uint16_t> numbers;
  for (const Domain& domain : Domains()) numbers.insert(domain.number);
  for (const auto& [number, name] : kRetired) numbers.insert(number);
  EXPECT_EQ(numbers.size(), *numbers.rbegin());
  EXPECT_EQ(numbers.size(), Domains().size() + kRetired.size());
}

TEST(DomainBits, OfTheFuzzCodeAreTheSameForGoodAndUnderEveryCompiler) {
  EXPECT_EQ(HashOfTheCode(), kGoldenCode) << "inputs that fuzzers saved stand for other cases";
}

}  // namespace
}  // namespace rasterproof::props
