#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/codec/codec.h"
#include "props/property.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/generators/case_streams.h"
#include "tests/generators/race.h"

namespace rasterproof::generators {
namespace {

constexpr int kMany = 20000;

std::vector<Case> Drawn(std::string_view stream, const SubjectInfo& info, int count) {
  const std::unique_ptr<CaseStream> cases = MakeStream(stream, info, {}, 1);
  std::vector<Case> drawn;
  for (int k = 0; k < count; ++k) drawn.push_back(cases->Next());
  return drawn;
}

TEST(Uniform, FillsItsBoxEvenly) {
  const auto subject = subjects::MakeBuiltin("f32-direct");
  constexpr int kParts = 8;
  std::array<int, kParts> x_in{};
  std::array<int, kParts> y_in{};
  int vertices = 0;
  for (const Case& c : Drawn("uniform", subject->Info(), kMany)) {
    for (const Vertex& v : c.scene.vertices) {
      const auto part = [](double x) {
        return static_cast<std::size_t>(std::floor((x + kSide / 2.0) / (2.0 * kSide / kParts)));
      };
      ASSERT_LT(part(v.x), kParts) << v.x;
      ASSERT_LT(part(v.y), kParts) << v.y;
      EXPECT_EQ(v.x, static_cast<float>(v.x));
      EXPECT_EQ(v.w, 1);
      ++x_in[part(v.x)];
      ++y_in[part(v.y)];
      ++vertices;
    }
  }
  for (const auto& parts : {x_in, y_in}) {
    for (const int count : parts) EXPECT_NEAR(count, vertices / kParts, vertices * 0.005);
  }
}

TEST(Uniform, HalfAreQuadsSplitByTheirDiagonal) {
  const auto subject = subjects::MakeBuiltin("f32-direct");
  int quads = 0;
  for (const Case& c : Drawn("uniform", subject->Info(), kMany)) {
    const bool is_quad = c.scene.triangles.size() == 2;
    quads += is_quad ? 1 : 0;
    ASSERT_EQ(c.scene.vertices.size(), is_quad ? 4U : 3U);
    if (is_quad) {
      EXPECT_EQ(c.scene.triangles[0][2], c.scene.triangles[1][1]);
    }
  }
  EXPECT_NEAR(quads, kMany / 2, kMany * 0.02);
}

TEST(Uniform, ClipSpaceIsTheSameBoxTimesW) {
  const auto subject = subjects::MakeBuiltin("hom-f32");
  for (const Case& c : Drawn("uniform", subject->Info(), 1000)) {
    ASSERT_TRUE(c.scene.clip_space);
    for (const Vertex& v : c.scene.vertices) {
      EXPECT_GE(v.w, 0.125);
      EXPECT_LE(v.w, 8);
      EXPECT_GE(v.x / v.w, -kSide / 2.0 - 1e-5);
      EXPECT_LE(v.x / v.w, 1.5 * kSide + 1e-5);
    }
  }
}

TEST(RapidCheckDefaults, GrowOverAHundredCases) {
  const auto subject = subjects::MakeBuiltin("f32-direct");
  const std::vector<Case> drawn = Drawn("rapidcheck", subject->Info(), 202);
  for (const std::size_t empty : std::array<std::size_t, 2>{0, 101}) {  // size 0
    for (const Vertex& v : drawn[empty].scene.vertices) EXPECT_EQ(v.x, 0);
  }
  const auto largest = [](const Case& c) {
    double most = 0;
    for (const Vertex& v : c.scene.vertices) most = std::max(most, std::fabs(v.x));
    return most;
  };
  EXPECT_LT(largest(drawn[6]), 64);
  EXPECT_GT(largest(drawn[100]), 0x1p50);
}

TEST(Streams, TheSeedDecides) {
  const auto subject = subjects::MakeBuiltin("f32-direct");
  const auto properties = Applicable(*subject, JudgingProperties());
  const SubjectInfo info = subject->Info();
  for (const std::string_view name : StreamNames()) {
    const auto first = [&](std::uint64_t seed) {
      const auto cases = MakeStream(name, info, properties, seed);
      return std::array{cases->Next(), cases->Next(), cases->Next(), cases->Next()};
    };
    const auto same = [](const auto& a, const auto& b) {
      return std::ranges::equal(a, b, props::SameCase);
    };
    EXPECT_TRUE(same(first(1), first(1))) << name;
    EXPECT_FALSE(same(first(1), first(2))) << name;
  }
  EXPECT_EQ(MakeStream("uniformly", info, properties, 1), nullptr);
}

// A bug that any generator shows, and a sound subject that none does.
TEST(Race, EndsAtTheFirstViolationOrTheCap) {
  const auto bug = subjects::MakeMutant("mutant:facing-exchanged");
  const auto sound = subjects::MakeBuiltin("i64-snap8");
  for (const std::string_view name : StreamNames()) {
    for (Subject* const subject : {bug.get(), sound.get()}) {
      const auto properties = Applicable(*subject, JudgingProperties());
      ASSERT_EQ(properties.size(), 4U);  // all but that of clip space
      const SubjectInfo info = subject->Info();
      const auto cases = MakeStream(name, info, properties, 1);
      const double cap = subject == bug.get() ? 300 : 0.05;
      const Race race = RunRace(*subject, properties, *cases, cap, 0);
      EXPECT_GT(race.cases, 0U);
      EXPECT_EQ(race.violating, subject == bug.get() ? 1U : 0U) << name;
      EXPECT_EQ(race.cases_to_first.has_value(), subject == bug.get()) << name;
      if (race.cases_to_first) {
        EXPECT_EQ(*race.cases_to_first, race.cases);
        EXPECT_LE(*race.seconds_to_first, race.seconds);
      }
    }
  }
}

TEST(Wrong, CountsWhatTheOracleCallsWrong) {
  const auto naive = subjects::MakeBuiltin("f32-affine");
  const auto exact = subjects::MakeBuiltin("spans-exact");
  const auto properties = Applicable(*exact, JudgingProperties());
  for (const bool is_naive : {true, false}) {
    Subject& subject = is_naive ? *naive : *exact;
    const SubjectInfo info = subject.Info();
    const auto cases = MakeStream("domains", info, properties, 1);
    const Wrong found = CountWrong(subject, *cases, 400, 60);
    EXPECT_GT(found.cases, 100U);
    EXPECT_EQ(found.wrong > 0, is_naive);
  }
}

}  // namespace
}  // namespace rasterproof::generators
