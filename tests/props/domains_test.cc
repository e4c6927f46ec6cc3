#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/fixed_input.h"
#include "core/ulp.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/domains/input_lattice.h"
#include "props/property.h"
#include "props/run/near_edge.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kDomainsSeed = 1;

SubjectInfo ClipInfo() {
  SubjectInfo info = RealInfo();
  info.takes_window = false;
  info.takes_clip = true;
  return info;
}

SubjectInfo MultisampledInfo() {
  SubjectInfo info = SnappedInfo(8);
  info.profile.pattern.locations = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  return info;
}

std::vector<SubjectInfo> Infos() {
  return {RealInfo(),         RealInfo(Precision::kFloat64),
          SnappedInfo(8),     SnappedInfo(4),
          SnappedInfo(0),     SnappedInfo(16),
          MultisampledInfo(), ClipInfo()};
}

Case Draw(const Domain& domain, const SubjectInfo& info, std::uint64_t index) {
  PhiloxSource bits(kDomainsSeed, index);
  return domain.draw(bits, info);
}

// NaN is equal to itself here.
bool SameBits(const Case& a, const Case& b) {
  const auto bits = [](const Case& c) {
    std::vector<std::uint64_t> all;
    for (const Vertex& v : c.scene.vertices) {
      for (const double x : {v.x, v.y, v.z, v.w}) all.push_back(std::bit_cast<std::uint64_t>(x));
    }
    return all;
  };
  return bits(a) == bits(b) && a.scene.triangles == b.scene.triangles &&
         a.scene.width == b.scene.width && a.scene.height == b.scene.height &&
         a.options == b.options && a.profile == b.profile;
}

void ExpectValid(const Case& c, const SubjectInfo& info) {
  const Scene& scene = c.scene;
  EXPECT_TRUE(scene.width >= 1 && scene.width <= kMaxTargetSide);
  EXPECT_TRUE(scene.height >= 1 && scene.height <= kMaxTargetSide);
  EXPECT_LE(std::int64_t{scene.width} * scene.height, 1 << 17);  // small enough to run often
  EXPECT_TRUE(Takes(info, scene));
  EXPECT_EQ(c.profile, info.profile);
  EXPECT_FALSE(scene.triangles.empty());
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) {
      ASSERT_TRUE(index >= 0 && index < static_cast<std::int32_t>(scene.vertices.size()));
    }
  }
  for (const Vertex& v : scene.vertices) {
    if (!scene.clip_space) {
      EXPECT_EQ(v.w, 1);
    }
    if (scene.precision == Precision::kFloat32) {
      for (const double x : {v.x, v.y, v.z, v.w}) EXPECT_TRUE(IsFloat32(x)) << x;
    }
  }
  EXPECT_GE(c.options.tile, 0);
  EXPECT_GE(c.options.threads, 1);
  if (!c.options.scissor) return;
  const PixelRect& r = *c.options.scissor;
  EXPECT_TRUE(0 <= r.x0 && r.x0 <= r.x1 && r.x1 <= scene.width);
  EXPECT_TRUE(0 <= r.y0 && r.y0 <= r.y1 && r.y1 <= scene.height);
}

TEST(Domains, HaveDifferentNamesThatAreFoundAgain) {
  std::set<std::string_view> names;
  std::set<std::uint16_t> numbers;
  for (const Domain& domain : Domains()) {
    EXPECT_TRUE(numbers.insert(domain.number).second) << domain.name;
    EXPECT_TRUE(names.insert(domain.name).second) << domain.name;
    EXPECT_EQ(FindDomain(domain.name), &domain);
    EXPECT_FALSE(domain.summary.empty());
  }
  EXPECT_EQ(FindDomain("no such domain"), nullptr);
}

TEST(Domains, AreAllUsedByTheCatalogueAndAllThatItNamesExist) {
  std::set<std::string_view> used;
  for (const Property& property : Catalog()) {
    EXPECT_FALSE(property.domains.empty()) << property.name;
    for (const std::string_view name : property.domains) {
      EXPECT_NE(FindDomain(name), nullptr) << property.name << " names " << name;
      used.insert(name);
    }
  }
  for (const Domain& domain : Domains()) EXPECT_TRUE(used.contains(domain.name)) << domain.name;
}

TEST(Domains, DrawTheSameCaseFromTheSameSeedAndAnotherFromAnotherIndex) {
  for (const SubjectInfo& info : Infos()) {
    for (const Domain& domain : Domains()) {
      if (!Suits(domain, info)) continue;
      for (std::uint64_t i = 0; i < 5; ++i) {
        EXPECT_TRUE(SameBits(Draw(domain, info, i), Draw(domain, info, i))) << domain.name;
      }
      bool differ = false;
      for (std::uint64_t i = 1; i < 5; ++i) {
        differ = differ || !SameBits(Draw(domain, info, 0), Draw(domain, info, i));
      }
      EXPECT_TRUE(differ) << domain.name;
    }
  }
}

TEST(Domains, MakeAValidCaseOfEveryBitString) {
  std::vector<std::vector<std::uint8_t>> strings{
      {}, std::vector<std::uint8_t>(4096, 0xff), std::vector<std::uint8_t>(4096, 0x55)};
  PhiloxSource random(kDomainsSeed, 7);
  for (int i = 0; i < 12; ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.Int(1, 300)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.Bits(8));
    strings.push_back(bytes);
  }
  for (const SubjectInfo& info : Infos()) {
    for (const Domain& domain : Domains()) {
      if (!Suits(domain, info)) continue;
      SCOPED_TRACE(domain.name);
      for (const auto& bytes : strings) {
        ByteSource source(bytes);
        ExpectValid(domain.draw(source, info), info);
      }
      for (std::uint64_t i = 0; i < 20; ++i) ExpectValid(Draw(domain, info, i), info);
    }
  }
}

// The same choice again and again puts places on top of each other; directions have no length then.
TEST(Domains, MakeFiniteCasesWhereEveryChoiceIsTheSame) {
  std::vector<SubjectInfo> infos = Infos();
  infos.push_back(SnappedInfo(4));
  infos.back().profile.fixed = FixedInput{11, 4, true, true};
  infos.push_back(SnappedInfo(4));
  infos.back().profile.fixed = FixedInput{5, 0, false, true};
  for (const SubjectInfo& info : infos) {
    for (const Domain& domain : Domains()) {
      if (!Suits(domain, info) || domain.non_finite) continue;
      for (int byte = 0; byte < 256; byte += 5) {
        const std::vector<std::uint8_t> bytes(4096, static_cast<std::uint8_t>(byte));
        ByteSource source(bytes);
        const Case c = domain.draw(source, info);
        const bool is_finite = std::ranges::all_of(c.scene.vertices, IsFinite);
        ASSERT_TRUE(is_finite || domain.beyond_limits) << domain.name << " of bytes " << byte;
      }
    }
  }
}

TEST(Domains, ThatNeedClipSpaceSuitOnlySubjectsThatTakeIt) {
  int clip = 0;
  for (const Domain& domain : Domains()) {
    if (domain.is_stated != nullptr) continue;  // tests/props/profile_keys_test.cc
    EXPECT_EQ(Suits(domain, RealInfo()), !domain.clip) << domain.name;
    EXPECT_TRUE(Suits(domain, ClipInfo())) << domain.name;
    clip += domain.clip ? 1 : 0;
  }
  EXPECT_GE(clip, 3);
}

TEST(Domains, KeepWindowPlacesWhenTheyGoThroughClipSpace) {
  int scaled = 0;
  for (const std::string_view name : {"uniform-subpixel", "subnormal", "largest-and-smallest"}) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Case window = Draw(*FindDomain(name), RealInfo(), i);
      const Case clip = Draw(*FindDomain(name), ClipInfo(), i);
      ASSERT_EQ(window.scene.vertices.size(), clip.scene.vertices.size());
      ASSERT_TRUE(clip.scene.clip_space);
      for (std::size_t v = 0; v < window.scene.vertices.size(); ++v) {
        const Vertex& c = clip.scene.vertices[v];
        EXPECT_EQ(c.x / c.w, window.scene.vertices[v].x) << name;
        EXPECT_EQ(c.y / c.w, window.scene.vertices[v].y) << name;
        scaled += c.w != 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(scaled, 50);
}

TEST(Domains, PutVerticesOnTheSubpixelGridUnlessTheyAreAboutSnapping) {
  for (const int bits : {0, 4, 8, 16}) {
    const SubjectInfo info = SnappedInfo(bits);
    for (const Domain& domain : Domains()) {
      if (domain.clip || domain.off_grid) continue;
      for (std::uint64_t i = 0; i < 40; ++i) {
        for (const Vertex& v : Draw(domain, info, i).scene.vertices) {
          EXPECT_EQ(SnapCoordinate(v.x, info.profile.snap), v.x) << domain.name;
          EXPECT_EQ(SnapCoordinate(v.y, info.profile.snap), v.y) << domain.name;
        }
      }
    }
  }
}

TEST(Domains, LeaveTheLimitOnlyIfTheySaySo) {
  for (const SubjectInfo& info : {SnappedInfo(8), SnappedInfo(4)}) {
    for (const Domain& domain : Domains()) {
      if (domain.clip) continue;
      int beyond = 0;
      for (std::uint64_t i = 0; i < 60; ++i) {
        beyond += WithinLimits(Draw(domain, info, i).scene, info.profile) ? 0 : 1;
      }
      if (domain.beyond_limits) {
        EXPECT_GT(beyond, 10) << domain.name;
      } else {
        EXPECT_EQ(beyond, 0) << domain.name;
      }
    }
  }
}

struct Shares {
  NearEdgeCounts counts;
  int cases_near = 0;
};

Shares NearEdgeShares(const Domain& domain, const SubjectInfo& info, int cases) {
  Shares shares;
  for (int i = 0; i < cases; ++i) {
    const NearEdgeCounts counts = CountNearEdges(Draw(domain, info, static_cast<std::uint64_t>(i)));
    shares.counts += counts;
    shares.cases_near += counts.on_edge + counts.within_256 != 0 ? 1 : 0;
  }
  return shares;
}

TEST(NearEdgeDomains, ComeNearAnEdgeInNearlyEveryCase) {
  constexpr int kCases = 100;
  for (const SubjectInfo& info : Infos()) {
    for (const Domain& domain : Domains()) {
      if (!domain.near_edge || !Suits(domain, info) || domain.name == "long-rows") continue;
      EXPECT_GE(NearEdgeShares(domain, info, kCases).cases_near, 97)
          << domain.name << " at " << info.profile.snap.bits << " bits";
    }
  }
  EXPECT_EQ(NearEdgeShares(*FindDomain("long-rows"), RealInfo(), 12).cases_near, 12);
}

TEST(NearEdgeDomains, PutSamplesOnTheEdgeAndWithinOneStep) {
  struct Least {
    std::string_view domain;
    double on_edge;
    double within_1;
  };
  // About half of what was measured over these 1000 cases of float32, the same under every
  // compiler (domain_bits_test.cc); so that a dead branch shows.
  const std::vector<Least> least{
      {"vertices-on-samples", 0.07, 0},
      {"axis-aligned", 0.17, 0},
      {"edges-through-samples", 0.07, 0},
      {"near-edge", 0.01, 0.004},
      {"hardest-vertex", 0, 0.015},
      {"ulp-extremes", 0, 0.01},
      {"caps", 0.02, 0.004},
      {"shared-edge", 0.015, 0.005},
      {"fans", 0.05, 0.013},
      {"strips", 0.12, 0},
      {"grids", 0.12, 0},
      {"triangulations", 0.03, 0.004},
      {"subdivisions", 0.014, 0},
      {"t-junctions", 0.02, 0.001},
  };
  for (const Least& l : least) {
    const NearEdgeCounts counts = NearEdgeShares(*FindDomain(l.domain), RealInfo(), 1000).counts;
    const auto share = [&](std::uint64_t n) {
      return static_cast<double>(n) / static_cast<double>(counts.samples);
    };
    EXPECT_GE(share(counts.on_edge), l.on_edge) << l.domain;
    EXPECT_GE(share(counts.within_1), l.within_1) << l.domain;
  }
}

TEST(NearEdgeCounts, TellOnTheEdgeFromOneStepAndFrom256) {
  Case c;
  c.scene.width = c.scene.height = 4;
  c.scene.vertices = {{0.5, -8}, {0.5, 8}, {-9, 0}};
  c.scene.triangles = {{0, 1, 2}};
  const NearEdgeCounts on = CountNearEdges(c);
  EXPECT_EQ(on.on_edge, 4U);  // the left column
  EXPECT_EQ(on.within_256, 0U);
  c.scene.vertices[0].x = c.scene.vertices[1].x = 0.5 + 0x1p-24;  // one ulp of 0.5
  const NearEdgeCounts one = CountNearEdges(c);
  EXPECT_EQ(one.on_edge, 0U);
  EXPECT_EQ(one.within_1, 4U);
  c.scene.vertices[0].x = c.scene.vertices[1].x = 0.5 + 17 * 0x1p-24;
  const NearEdgeCounts seventeen = CountNearEdges(c);
  EXPECT_EQ(seventeen.within_16, 0U);
  EXPECT_EQ(seventeen.within_256, 4U);
  c.scene.vertices[0].x = c.scene.vertices[1].x = 0.75;
  EXPECT_EQ(CountNearEdges(c).within_256, 0U);
  EXPECT_GT(CountNearEdges(c).samples, 0U);
  c.profile.snap.bits = 4;  // then a quarter of a pixel is four subpixels
  EXPECT_EQ(CountNearEdges(c).within_1, 0U);
  EXPECT_EQ(CountNearEdges(c).within_16, 8U);  // 4 from one column, 12 from the next
}

TEST(MeshDomains, AreEmbeddedUnlessTheyAreClosedOrCracked) {
  for (const SubjectInfo& info : Infos()) {
    for (const Domain& domain : Domains()) {
      if (!domain.mesh || domain.overlaps || domain.clip || !info.takes_window) continue;
      for (std::uint64_t i = 0; i < 40; ++i) {
        const Case c = Draw(domain, info, i);
        EXPECT_EQ(c.options.cull, Cull::kNone);
        EXPECT_FALSE(c.options.scissor);
        const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
        bool front = false, back = false;
        for (std::size_t s = 0; s < counts.size(); ++s) {
          ASSERT_LE(counts.Count(s), 1U) << domain.name << " case " << i;
          front = front || counts.front[s] != 0;
          back = back || counts.back[s] != 0;
        }
        EXPECT_FALSE(front && back) << domain.name << " case " << i;
      }
    }
  }
}

TEST(MeshDomains, OfGridsAreJitteredInAThirdOfTheCases) {
  int jittered = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Case c = Draw(*FindDomain("grids"), RealInfo(), i);
    const auto off_half_pixels = [](const Vertex& v) { return std::fmod(2 * v.x, 1) != 0; };
    jittered += std::ranges::any_of(c.scene.vertices, off_half_pixels) ? 1 : 0;
  }
  EXPECT_GT(jittered, 33);
}

TEST(MeshDomains, WithTJunctionsCrackInSomeCases) {
  const Domain& domain = *FindDomain("t-junctions");
  int cracked = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Case c = Draw(domain, RealInfo(), i);
    const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
    for (std::size_t s = 0; s < counts.size(); ++s) {
      if (counts.Count(s) == 1) continue;
      ++cracked;
      break;
    }
  }
  EXPECT_GT(cracked, 0);
}

TEST(MeshDomains, ThatAreClosedHaveSignedCoverageZeroEverywhere) {
  const Domain& domain = *FindDomain("closed-mesh");
  std::uint64_t covered = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Case c = Draw(domain, SnappedInfo(8), i);
    const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
    for (std::size_t s = 0; s < counts.size(); ++s) {
      ASSERT_EQ(counts.Signed(s), 0);
      covered += counts.Count(s) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 1000U);
}

TEST(UlpExtremes, MakesFloat64EdgeFunctionsWrongOnFloat32Input) {
  auto naive = testing::NaiveFloat64(RealInfo());
  const auto wrong_cases = [&](std::string_view name) {
    int wrong = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Case c = Draw(*FindDomain(name), RealInfo(), i);
      const Verdict verdict = testing::CoverageIsTheModels(naive, c);
      wrong += verdict.outcome == Outcome::kViolated ? 1 : 0;
    }
    return wrong;
  };
  EXPECT_GE(wrong_cases("ulp-extremes"), 40);
  EXPECT_EQ(wrong_cases("uniform-subpixel"), 0);
}

TEST(InputLattice, StepsFromNeighbourToNeighbour) {
  const InputLattice float32(Profile{}, Precision::kFloat32);
  EXPECT_EQ(float32.Step(1.0), 0x1p-23);
  EXPECT_EQ(float32.Step(0.0), 0x1p-149);
  EXPECT_EQ(float32.Move(1.0, 1), 1 + 0x1p-23);
  EXPECT_EQ(float32.Move(0.0, -1), -0x1p-149);
  EXPECT_EQ(float32.GridBits(512), 15);
  Profile snapped;
  snapped.snap.bits = 8;
  snapped.coordinate_limit = 1000.001;
  const InputLattice fixed(snapped, Precision::kFloat32);
  EXPECT_EQ(fixed.Step(1.0), 0x1p-8);
  EXPECT_EQ(fixed.Move(1.0, -1), 1 - 0x1p-8);
  EXPECT_EQ(fixed.Step(0x1p20), 0x1p-3);  // float32 has no subpixels left there
  EXPECT_EQ(fixed.Round(0.501), 0.5);
  EXPECT_EQ(fixed.limit(), 1000.0);
  EXPECT_EQ(fixed.RoundWithinLimit(-1e30), -1000.0);
  EXPECT_EQ(fixed.GridBits(512), 8);
}

TEST(BitSources, DrawIntegersOfTheWholeRangeAndNoOthers) {
  PhiloxSource bits(kDomainsSeed, 3);
  std::map<std::int64_t, int> seen;
  for (int i = 0; i < 6000; ++i) ++seen[bits.Int(-1, 4)];
  ASSERT_EQ(seen.size(), 6U);
  for (const auto& [value, count] : seen) {
    EXPECT_TRUE(value >= -1 && value <= 4);
    EXPECT_NEAR(count, 1000, 150);
  }
  EXPECT_EQ(bits.Int(7, 7), 7);
  for (int i = 0; i < 100; ++i) {
    bits.Int(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  }
}

TEST(BitSources, OfBytesReadFromTheFrontAndThenGiveZeros) {
  const std::vector<std::uint8_t> bytes{0x12, 0x34, 0x56};
  ByteSource source(bytes);
  EXPECT_EQ(source.Bits(8), 0x12U);
  EXPECT_EQ(source.Bits(12), 0x634U);
  EXPECT_EQ(source.Bits(64), 0U);
}

TEST(BitSources, OfPhiloxAreTheSameOnEveryMachine) {
  // Known answer of Philox4x64-10 for counter 0 and key 0 (Random123, kat_vectors), last first.
  PhiloxSource bits(0, 0);
  EXPECT_EQ(bits.Bits(64), 0x7e68b68aec7ba23bU);
  EXPECT_EQ(bits.Bits(64), 0xd7e772cee186176bU);
  EXPECT_EQ(bits.Bits(64), 0xdb20fe9d672d0fdcU);
  EXPECT_EQ(bits.Bits(64), 0x16554d9eca36314cU);
  EXPECT_NE(PhiloxSource(1, 2).Bits(64), PhiloxSource(1, 3).Bits(64));
  EXPECT_NE(PhiloxSource(1, 2).Bits(64), PhiloxSource(2, 2).Bits(64));
  EXPECT_NE(PhiloxSource(1, 2).Bits(64), PhiloxSource(1, 2, 1).Bits(64));
}

}  // namespace
}  // namespace rasterproof::props
