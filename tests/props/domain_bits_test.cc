// A name stands for the same case for good and under every compiler: in a bug report it must mean
// one case. A recipe that draws otherwise gets a new number (props/domains/domain.h).
// A recipe that draws twice in a call's arguments, or on both sides of an operator, breaks this:
// C++ leaves the order of such draws open, and g++ and clang differ. Draw into named values, or in
// braces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
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

// What was once drawn for a number. A line is never changed: a recipe that draws otherwise adds one
// with its new number, and the old one stays, so that nobody takes its number again. A domain that
// is added to the table or taken from it changes none of them: no other case is another by that.
struct Golden {
  std::uint16_t number;
  std::string_view name;
  std::uint64_t hash;
};

constexpr auto kGolden = std::to_array<Golden>({
    {1, "uniform-subpixel", 0x690c8ef9c3c44a28},
    {2, "vertices-on-samples", 0x4143ee6228f2987e},
    {3, "axis-aligned", 0x7b57ac5dbf0e0ef3},
    {4, "edges-through-samples", 0x82501df505f3892},
    {5, "near-edge", 0xfcc525f375a435f6},
    {6, "hardest-sample", 0x6b7a4bd57c50acc8},
    {7, "hardest-vertex", 0xe4edd05b6b7a9e96},
    {8, "ulp-extremes", 0x98d5e16434f09c93},
    {9, "needles", 0xee886acb3d800398},
    {10, "caps", 0x5c03bfae181c0847},
    {11, "far-slivers", 0x29a3c3a3a3c7aaf5},
    {12, "offset-cancellation", 0xb9036bf66ef85de3},
    {13, "subnormal", 0x213afcb9dc59e470},
    {14, "product-overflow", 0x43d60954733de661},
    {15, "largest-and-smallest", 0x671b80373c51d995},
    {16, "mixed-magnitude", 0xe65728365063bf51},
    {17, "coordinate-limits", 0x27d0e2f7d6e7d38c},
    {18, "range-ends", 0xfcb7fc6849ab4df6},
    {19, "far-negative-corners", 0xf5ccd248e0025ed9},
    {20, "rounded-differences", 0xb852f3049d66f8b},
    {21, "sub-pixel-triangles", 0x8544d5ee2e675b6e},
    {22, "deciding-snap-ties", 0x86386b3ce65959c},
    {23, "full-coverage", 0x9d026271490022d},
    {24, "snap-ties", 0x4f204425accba998},
    {25, "degenerate", 0xf51c7d032c605b01},
    {26, "signed-zeros", 0x1250c27886f2730e},
    {27, "non-finite", 0xed0bc9be91ef3ee5},
    {28, "vertex-orders", 0xf04acac1f4f81f4e},
    {29, "shared-edge", 0xba92d18cbd162a38},
    {30, "fans", 0x84546d08f18b4ac2},
    {31, "strips", 0x2b2adddecf528e9},
    {32, "grids", 0xd418d8ca2e6e7f1e},
    {33, "triangulations", 0x12a312b80d8dd965},
    {34, "covering-fans", 0xc8f525f5c7780bdc},
    {35, "subdivisions", 0xa427f0df502f79dc},
    {36, "t-junctions", 0x9c6b96ddf18cd688},
    {37, "closed-mesh", 0x5eb09dd8a82086f0},
    {38, "long-rows", 0x5a6f72d35c827e89},
    {39, "target-sizes", 0x435d30aee11c791e},
    {40, "perspective", 0x52c48773dd390dbd},
    {41, "mixed-w", 0xcb0e8109c5b814c3},
    {42, "closed-around-eye", 0xdc882a2f6468c39d},
    {43, "near-repeats", 0x72b9650315360868},
    {44, "sparse-indices", 0x6ea3043e9d4d20be},
    {45, "shared-snap-ties", 0x7b85fab785e1cef0},
    {46, "perspective-meshes", 0x564e3a674814dac5},
    {47, "meshes-around-eye", 0x747cb0a58ed36f7f},
    {48, "folds", 0x17152c45d17b1a49},
    {49, "closed-folds", 0x37f644e123a94f2},
    {50, "wrapped-coordinates", 0xdb2de020fca18e05},
    {51, "primitive-extent-ends", 0x4b825be7a150b730},
    {52, "guard-band-ends", 0xf29edd887529558a},
    {53, "target-size-ends", 0x6c2cc600d67e26bf},
    {54, "least-areas", 0xd1209486a3b9d6eb},
    {55, "rows-and-columns", 0xc30d7c15af224857},
    {56, "square-grid-lines", 0xb56d2a924af36037},
    {57, "square-crossings", 0x28c4ff9079ed50a5},
    {58, "square-interiors", 0xe7ac4a70d01393ff},
    {59, "many-triangles", 0x9feb28654f82ff68},
    {60, "crowds", 0x593877c183869e9},
    {61, "accumulator-ends", 0xee77b2363a7f18b8},
    {62, "underflowing-products", 0xe1fe6215c87eb040},
    {63, "near-rectangles", 0x8bca6fc67aad1354},
    {64, "non-finite-depths", 0xea505ce0d86ea282},
    {65, "one-vertex-behind", 0xdd2aa0a9c694445e},
    {66, "hardest-rays", 0xf016da7c25b1ac56},
    {67, "accumulator-ends", 0xd5730c5f4c9f0cae},
    {68, "near-rectangles", 0xa2a6e262bc44f529},
    {69, "many-triangles", 0x6bebb1b4cd9b1361},
    {70, "far-sides", 0xc281c76bcbcd063b},
    {71, "every-size", 0x20f9aaa81e80e3b6},
    {72, "off-grid-moves", 0xdd9e7a71873f94e},
    {73, "off-grid-fragments", 0x5f0ae0e14b9bfa22},
    {74, "tilted-grids", 0x75c54053ab381a27},
    {75, "diagonal-needles", 0x861ed94f01c9779},
    {76, "tile-borders", 0x68ed867fed5683a4},
    {77, "rounded-arrangements", 0x6474fca426d57fe3},
    {78, "equal-after-snap", 0xe1c418da1cbc6224},
    {79, "earcut-meshes", 0xa66c9628c808f0f4},
    {80, "cameras", 0x261bb691300ae61d},
    {81, "scaled-viewports", 0x5ecbd54bc8e28841},
    {82, "tessellation-cracks", 0xebf9e87df878dca5},
    {83, "soups", 0xcdf398c147a47290},
    {84, "coplanar-depths", 0x369a7d4c50f53811},
    {85, "frame-sweeps", 0x80bdc8317ff6a1e},
    {86, "every-lane", 0x2792612688570953},
    {87, "far-tile-corners", 0x1b676092fe08e0ae},
    {88, "pattern-lines", 0xe99927507394bffd},
    {89, "turned-by-snap", 0x9e56e5bf5d724cf9},
    {90, "far-corners", 0x6300680f30d05176},
    {91, "aliased-indices", 0xb897b7c8653ed4d8},
    {92, "fine-meshes", 0x1a64e26cf8bc1459},
    {93, "least-w", 0xd7427ce52bb2e7d0},
    {94, "eye-planes", 0xd6a7f0e352989e42},
    {95, "near-beside-far", 0xc2b6b4ad8fa55f1f},
    {96, "closed-around-eye", 0x2dca34b871b0039a},
    {97, "meshes-around-eye", 0xaa883c3ecb1f2a70},
    {98, "off-grid-fragments", 0x6bcb625f925c8caa},
    {99, "least-areas", 0x72f7c7b9484cb03},
    {100, "every-size", 0x5d18162ac0d222f8},
    {101, "tilted-grids", 0xdd1e1a31db590f8d},
    {102, "cameras", 0xc1eeda5302d3ae3a},
    {103, "frame-sweeps", 0x9aad71cdd65589ab},
    {104, "w-ratios", 0x3864d20a1c832489},
    {105, "clip-slivers", 0xda432442477f27d7},
});

constexpr std::uint64_t kGoldenCode = 0x9e9b57d48ef36170;

std::string LineOf(const Domain& domain, std::uint64_t hash) {
  std::ostringstream line;
  line << "{" << domain.number << ", \"" << domain.name << "\", 0x" << std::hex << hash << "},";
  return line.str();
}

TEST(DomainBits, OfANumberAreTheSameForGoodAndUnderEveryCompiler) {
  for (const Domain& domain : Domains()) {
    const std::uint64_t hash = HashOf(domain);
    const auto golden = std::ranges::find(kGolden, domain.number, &Golden::number);
    if (golden == kGolden.end()) {
      ADD_FAILURE() << "a new domain, or a new number of one: add " << LineOf(domain, hash);
      continue;
    }
    EXPECT_EQ(golden->name, domain.name) << "number " << domain.number << " is " << golden->name
                                         << "'s for good: give " << domain.name << " a new one";
    EXPECT_EQ(golden->hash, hash) << domain.name
                                  << " draws otherwise than it did: give it a new number in "
                                  << "its row, leave its old line here and add one: "
                                  << LineOf(domain, hash);
  }
}

TEST(DomainBits, OfTheFuzzCodeAreTheSameForGoodAndUnderEveryCompiler) {
  EXPECT_EQ(HashOfTheCode(), kGoldenCode) << "inputs that fuzzers saved stand for other cases";
}

}  // namespace
}  // namespace rasterproof::props
