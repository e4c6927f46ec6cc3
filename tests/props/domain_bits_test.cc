// The cases of a seed are the same under every compiler: a seed in a bug report must mean one case.
// A recipe that draws twice in a call's arguments, or on both sides of an operator, breaks this:
// C++ leaves the order of such draws open, and g++ and clang differ. Draw into named values, or in
// braces.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "props/codec/codec.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kSeed = 1;
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

std::vector<SubjectInfo> Infos() {
  SubjectInfo clip = RealInfo();
  clip.takes_window = false;
  clip.takes_clip = true;
  return {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(8), SnappedInfo(4), clip};
}

// Promises all that some domain is about.
SubjectInfo PromisingInfo() {
  SubjectInfo info = SnappedInfo(8);
  info.profile.fixed = FixedInput{11, 4, true, true};
  info.profile.max_extent = MaxExtent{64, 32};
  info.profile.no_clip = WindowBox{-256, -256, 256, 256};
  info.profile.targets.emplace_back();
  info.profile.targets.back().max_width = 32;
  info.profile.targets.back().snap = {2};
  return info;
}

std::uint64_t HashOf(const Domain& domain) {
  Hash hash;
  SubjectInfo free = SnappedInfo(8);
  free.profile.freedom.snap_tolerance = 0.6;
  const std::vector<SubjectInfo> promising{PromisingInfo(), free};
  for (const SubjectInfo& info : domain.is_promised == nullptr ? Infos() : promising) {
    if (!Suits(domain, info)) continue;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      PhiloxSource bits(kSeed, i);
      hash.Add(domain.draw(bits, info));
    }
  }
  return hash.value();
}

std::uint64_t HashOfCodecExamples() {
  Hash hash;
  for (const CodecExample& example : CodecExamples()) {
    for (const SubjectInfo& info : Infos()) hash.Add(DecodeCase(example.bytes, info));
  }
  return hash.value();
}

// A changed recipe changes its line, and that line only; the failure prints the new one.
const std::map<std::string_view, std::uint64_t>& Golden() {
  static const std::map<std::string_view, std::uint64_t> golden{
      {"uniform-subpixel", 0x1494aadc56b138f3},
      {"centres", 0x2178bd396025dcd3},
      {"axis-aligned", 0x4d077ddd59f13303},
      {"edges-through-centres", 0x3686f96e904e16f5},
      {"near-edge", 0x576f814106fb08fb},
      {"hardest-pixel", 0x85223c00dc89c62f},
      {"hardest-vertex", 0x2a1a231d7789832c},
      {"f64-killer", 0xe416a3014bc64f9a},
      {"needles", 0x25d1b00c7f4e45cf},
      {"caps", 0x50c2b026aec8b286},
      {"sliver-1e30", 0x655a5128c837e9c7},
      {"offset-cancellation", 0x9e044c079749e04e},
      {"subnormal", 0xd4a3fee14cbcfdf3},
      {"overflow-products", 0x54c28e64960b99b4},
      {"both-ends", 0x9c0c3ae8b60620b7},
      {"mixed-magnitude", 0x8444917a86ee342c},
      {"guard-band", 0x974dfb42cd68eb7},
      {"snap-ties", 0x1f00a8efb99db1fe},
      {"degenerate", 0x9a57e26f14ed736c},
      {"signed-zeros", 0xb83b8bfbe76085a1},
      {"non-finite", 0x9112086cfdbdd83f},
      {"windings", 0x8f4c8b342f6ecee},
      {"shared-edge", 0xed6be618407fbd72},
      {"fans", 0x5be72391805a075b},
      {"strips", 0xad9e7c715ee0f61f},
      {"grids", 0xa81c93c43f544cc5},
      {"triangulations", 0xb3e3c8eda1e7f1f0},
      {"subdivisions", 0xcc88466e919d700f},
      {"t-junctions", 0x5569042d2525d8bf},
      {"closed-mesh", 0xabaabef9ee23f35},
      {"long-walk", 0x90b845c08c1fbb7d},
      {"size-ladder", 0xacbbaa7d59743cf},
      {"perspective", 0xf20c58c1a51c01be},
      {"w-mixed", 0x21e374b0bc6c8f82},
      {"closed-around-eye", 0x7c899fa7e6d13906},
      {"shared-snap-ties", 0xbaa76ab0e296de0e},
      {"range-ends", 0xef1d65f2bac87a70},
      {"tiny-ends", 0x9b4c1e855d07cb07},
      {"sub-pixel", 0x92273b60fcf3495e},
      {"deciding-ties", 0x74470f21d10dec6e},
      {"full-targets", 0x6397510bcbeff90d},
      {"far-negative-corners", 0x1ee96610e9d44a16},
      {"covering-fans", 0x9b726aa059a568b6},
      {"wrapped-coordinates", 0xfabbadb6b9cdd84d},
      {"extent-ends", 0xd5d891f584c51d35},
      {"no-clip-ends", 0x6af4e7cc0bf789ab},
      {"target-ends", 0x9ac0171ff55ad36c},
      {"near-repeats", 0xeaf8df9bfe302900},
      {"sparse-indices", 0x5f8f39b3cbfd5e3d},
      {"folds", 0x481d5c251d7c1fb3},
      {"closed-folds", 0xec7cf8ae2ef50427},
      {"perspective-meshes", 0x167eb923a4328f5e},
      {"meshes-around-eye", 0x31f92320d626d3d6},
      {"codec examples", 0x26b8358fee1609a6},
  };
  return golden;
}

void ExpectGolden(std::string_view name, std::uint64_t hash) {
  const auto found = Golden().find(name);
  EXPECT_TRUE(found != Golden().end() && found->second == hash)
      << "{\"" << name << "\", 0x" << std::hex << hash << "},";
}

TEST(DomainBits, AreTheSameUnderEveryCompiler) {
  for (const Domain& domain : Domains()) ExpectGolden(domain.name, HashOf(domain));
  ExpectGolden("codec examples", HashOfCodecExamples());
  EXPECT_EQ(Golden().size(), Domains().size() + 1);
}

}  // namespace
}  // namespace rasterproof::props
