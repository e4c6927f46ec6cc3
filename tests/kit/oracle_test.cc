// The oracle in C: equal to the library that it is made of, contradicted by no legal rasterizer,
// and clear about what it does not decide.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/float_environment.h"
#include "core/profile.h"
#include "core/rasterizer.h"
#include "core/scene.h"
#include "core/subject.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "io/case_file.h"
#include "io/scene_file.h"
#include "kit/rasterproof_oracle.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "subjects/mutants/mutants.h"
#include "tests/kit/oracle_languages.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An open profile.
class Opened {
 public:
  explicit Opened(const std::string& text) {
    EXPECT_EQ(rasterproof_oracle_open(text.c_str(), &profile_), RASTERPROOF_ORACLE_OK)
        << rasterproof_oracle_message();
  }
  ~Opened() { rasterproof_oracle_close(profile_); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  const rasterproof_oracle_profile* get() const { return profile_; }
  std::size_t samples() const {
    return static_cast<std::size_t>(rasterproof_oracle_samples(profile_));
  }

 private:
  rasterproof_oracle_profile* profile_ = nullptr;
};

// A scene as the oracle takes it.
struct GivenScene {
  explicit GivenScene(const Scene& scene) {
    for (const Vertex& v : scene.vertices) {
      for (const double x : {v.x, v.y, v.z, v.w}) vertices.push_back(x);
    }
    for (const Triangle& t : scene.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
    given = {scene.width,           scene.height,     scene.clip_space ? 1 : 0, vertices.data(),
             scene.vertices.size(), triangles.data(), scene.triangles.size()};
  }

  std::vector<double> vertices;
  std::vector<std::int32_t> triangles;
  rasterproof_oracle_scene given{};
};

std::size_t SamplesOf(const Scene& scene, const Opened& profile) {
  return static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height) *
         profile.samples();
}

rasterproof_oracle_status Decide(const Scene& scene, const Opened& profile,
                                 std::vector<std::uint8_t>& decisions) {
  const GivenScene given(scene);
  decisions.assign(SamplesOf(scene, profile) * scene.triangles.size(), 77);
  return rasterproof_oracle_decide(profile.get(), &given.given, decisions.data(), decisions.size());
}

std::int32_t Judged(const Scene& scene, const Opened& profile,
                    const std::vector<std::uint32_t>& counts, bool is_mask = false) {
  const GivenScene given(scene);
  std::int32_t verdict = -1;
  EXPECT_EQ(rasterproof_oracle_judge(profile.get(), &given.given, counts.data(), counts.size(),
                                     is_mask ? 1 : 0, &verdict),
            RASTERPROOF_ORACLE_OK)
      << rasterproof_oracle_message();
  return verdict;
}

Scene OneTriangle(Vertex a, Vertex b, Vertex c, int side = 8) {
  Scene scene;
  scene.width = side;
  scene.height = side;
  scene.precision = Precision::kFloat64;
  scene.vertices = {a, b, c};
  scene.triangles = {{0, 1, 2}};
  return scene;
}

TEST(Oracle, IsOfItsHeadersVersionAndSpeaksC) {
  EXPECT_EQ(rasterproof_oracle_version(), RASTERPROOF_ORACLE_VERSION);
  EXPECT_EQ(rasterproof_oracle_calls_of_c99(), 0);
  EXPECT_EQ(rasterproof_oracle_calls_of_cxx11(), 0);
}

TEST(Oracle, CountsWhatExactCoverageCounts) {
  for (const char* file : {"scenes/ties.json", "scenes/fan.json", "scenes/drtk9.json"}) {
    const Scene scene = io::ReadScene(file);
    for (const char* preset : {"real", "d3d11-canonical", "vulkan", "gl-canonical-4x"}) {
      const Opened profile(preset);
      const GivenScene given(scene);
      std::vector<std::uint32_t> front(SamplesOf(scene, profile));
      std::vector<std::uint32_t> back(front.size());
      ASSERT_EQ(rasterproof_oracle_counts(profile.get(), &given.given, front.data(), back.data(),
                                          front.size()),
                RASTERPROOF_ORACLE_OK)
          << rasterproof_oracle_message();
      const CoverageCounts expected = exact::Coverage(scene, *PresetProfile(preset));
      EXPECT_EQ(front, expected.front) << file << preset;
      EXPECT_EQ(back, expected.back) << file << preset;
    }
  }
}

TEST(Oracle, LeavesOpenWhatTheProfileLeavesOpenAndNothingElse) {
  // An edge at x = 4.5 and one step of 1/256 to either side of it: a sample lies on the edge.
  const auto at = [](double x, const char* preset) {
    std::vector<std::uint8_t> decisions;
    const Scene scene = OneTriangle({x, 0}, {8, 4}, {x, 8});
    EXPECT_EQ(Decide(scene, Opened(preset), decisions), RASTERPROOF_ORACLE_OK);
    return decisions[4 * 8 + 4];
  };
  constexpr double kStep = 1.0 / 256;
  EXPECT_EQ(at(4.5, "d3d11-canonical"), RASTERPROOF_ORACLE_MUST) << "a left edge owns its samples";
  EXPECT_EQ(at(4.5 + kStep, "d3d11-canonical"), RASTERPROOF_ORACLE_MUST_NOT);
  EXPECT_EQ(at(4.5 - kStep, "d3d11-canonical"), RASTERPROOF_ORACLE_MUST);
  EXPECT_EQ(at(4.5 + 0.45 * kStep, "d3d11"), RASTERPROOF_ORACLE_MAY) << "two grid points are legal";
  EXPECT_EQ(at(4.5 + 0.61 * kStep, "d3d11"), RASTERPROOF_ORACLE_MUST_NOT) << "0.6 of a step";
  EXPECT_EQ(at(4.5, "vulkan"), RASTERPROOF_ORACLE_MAY) << "no owner is stated";
  EXPECT_EQ(at(4.5 - 1.0 / 15, "vulkan"), RASTERPROOF_ORACLE_MUST) << "more than a step of 1/16";
  EXPECT_EQ(at(4.5 + 1.0 / 15, "vulkan"), RASTERPROOF_ORACLE_MUST_NOT);
}

TEST(Oracle, DecidesNothingOfATriangleOfWhichNothingIsStated) {
  std::vector<std::uint8_t> decisions;
  const auto all = [&](std::uint8_t expected) {
    for (const std::uint8_t d : decisions) {
      if (d != expected) return false;
    }
    return true;
  };
  const Scene infinite = OneTriangle({0, 0}, {kInfinity, 0}, {0, 8});
  ASSERT_EQ(Decide(infinite, Opened("d3d11"), decisions), RASTERPROOF_ORACLE_OK);
  EXPECT_TRUE(all(RASTERPROOF_ORACLE_MAY));
  ASSERT_EQ(Decide(infinite, Opened("real"), decisions), RASTERPROOF_ORACLE_OK);
  EXPECT_TRUE(all(RASTERPROOF_ORACLE_MUST_NOT)) << "`real` says that it covers nothing";
  ASSERT_EQ(Decide(OneTriangle({0, 0}, {8, kNan}, {0, 8}), Opened("d3d11"), decisions),
            RASTERPROOF_ORACLE_OK);
  EXPECT_TRUE(all(RASTERPROOF_ORACLE_MUST_NOT)) << "a NaN draws nothing";
}

TEST(Oracle, SaysWhyItDoesNotDecide) {
  std::vector<std::uint8_t> decisions;
  const Scene scene = OneTriangle({0, 0}, {8, 0}, {0, 8});
  const auto why = [&](const Scene& asked, const std::string& profile) {
    EXPECT_EQ(Decide(asked, Opened(profile), decisions), RASTERPROOF_ORACLE_NOT_DECIDED) << profile;
    EXPECT_EQ(decisions.front(), 77) << "nothing is written";
    return std::string(rasterproof_oracle_message());
  };
  EXPECT_EQ(why(scene, "vulkan-4x"), "the profile does not state where samples lie");
  EXPECT_EQ(why(scene, R"({"name": "n", "contract": "none"})"),
            "the contract does not state single samples");
  EXPECT_EQ(
      why(OneTriangle({0, 0}, {40000, 0}, {0, 8}), R"({"name": "n", "coordinate_limit": 32768})"),
      "a coordinate lies beyond the profile's coordinate_limit");
  Scene clip = scene;
  clip.clip_space = true;
  why(clip, "gl");
}

TEST(Oracle, SaysNothingOfEdgesThatClippingMayMoveAnyhow) {
  std::vector<std::uint8_t> decisions;
  const Opened clips(R"({"name": "n", "guard_band": "viewport"})");
  const Scene within = OneTriangle({0, 0}, {8, 0}, {0, 8});
  const Scene leaves = OneTriangle({0, 0}, {9, 0}, {0, 8});
  EXPECT_EQ(Decide(within, clips, decisions), RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(decisions.front(), RASTERPROOF_ORACLE_MUST);
  EXPECT_EQ(Decide(leaves, clips, decisions), RASTERPROOF_ORACLE_NOT_DECIDED);
  EXPECT_EQ(std::string(rasterproof_oracle_message()),
            "a triangle leaves the guard band, and the profile does not say how far clipping moves "
            "its edges");
  const GivenScene given(leaves);
  const std::vector<std::uint32_t> counts(64);
  std::int32_t verdict = -1;
  EXPECT_EQ(rasterproof_oracle_judge(clips.get(), &given.given, counts.data(), 64, 0, &verdict),
            RASTERPROOF_ORACLE_NOT_DECIDED);
  EXPECT_EQ(Decide(leaves, Opened("gl"), decisions), RASTERPROOF_ORACLE_OK)
      << "there they move by less than a step";
}

TEST(Oracle, JudgesATransformOfItsOwnByWhatIsStatedOfEachTriangle) {
  const auto judged = [](const Scene& scene, const std::string& infinite, std::uint32_t n) {
    const Opened profile(R"({"name": "n", "infinite_vertex": ")" + infinite +
                         R"(", "transform": {"precision": "float32", "division": "quotient", )"
                         R"("viewport": "none", "flips_y": false}})");
    return Judged(scene, profile, std::vector<std::uint32_t>(64, n));
  };
  Scene whole = OneTriangle({0, 0, 0, 2}, {64, 0, 0, 2}, {0, 64, 0, 2});
  whole.clip_space = true;
  EXPECT_EQ(judged(whole, "nothing", 1), RASTERPROOF_ORACLE_LEGAL);
  EXPECT_EQ(judged(whole, "nothing", 0), RASTERPROOF_ORACLE_NOT_LEGAL);
  whole.vertices[1].x = kInfinity;
  EXPECT_EQ(judged(whole, "nothing", 1), RASTERPROOF_ORACLE_NOT_LEGAL);
  EXPECT_EQ(judged(whole, "nothing", 0), RASTERPROOF_ORACLE_LEGAL);
  EXPECT_EQ(judged(whole, "unspecified", 1), RASTERPROOF_ORACLE_LEGAL) << "it may cover anything";
  EXPECT_EQ(judged(whole, "unspecified", 0), RASTERPROOF_ORACLE_LEGAL);
  EXPECT_EQ(judged(whole, "unspecified", 2), RASTERPROOF_ORACLE_NOT_LEGAL) << "but not twice";
}

TEST(Oracle, DecidesWholePixelsAndOneSidedContractsToo) {
  std::vector<std::uint8_t> decisions;
  const Scene scene = OneTriangle({1.25, 1.25}, {1.5, 1.25}, {1.25, 1.5}, 4);
  ASSERT_EQ(Decide(scene, Opened("pdf-fill"), decisions), RASTERPROOF_ORACLE_OK)
      << rasterproof_oracle_message();
  EXPECT_EQ(decisions[9], RASTERPROOF_ORACLE_MUST) << "it lies within a pixel's square; y is up";
  EXPECT_EQ(decisions[0], RASTERPROOF_ORACLE_MUST_NOT);
  const Scene large = OneTriangle({0, 0}, {4, 0}, {0, 4}, 4);
  ASSERT_EQ(Decide(large, Opened(R"({"name": "n", "contract": "at-least-model"})"), decisions),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(decisions[0], RASTERPROOF_ORACLE_MUST);
  EXPECT_EQ(decisions[15], RASTERPROOF_ORACLE_MAY);
  ASSERT_EQ(Decide(large, Opened(R"({"name": "n", "contract": "at-most-model"})"), decisions),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(decisions[0], RASTERPROOF_ORACLE_MAY);
  EXPECT_EQ(decisions[15], RASTERPROOF_ORACLE_MUST_NOT);
}

// A case of every so many domains, small enough to be judged in a moment.
std::vector<Case> CasesFor(const SubjectInfo& info, std::size_t first, std::size_t stride) {
  std::vector<Case> cases;
  const auto domains = props::Domains();
  for (std::size_t d = first % stride; d < domains.size(); d += stride) {
    if (!props::Suits(domains[d], info)) continue;
    props::PhiloxSource bits(1, 0);
    Case c = domains[d].draw(bits, info);
    const std::size_t size =
        CoverageCounts::Size(c.scene.width, c.scene.height, info.profile.pattern.samples());
    if (c.scene.triangles.size() * size <= 4'000) cases.push_back(std::move(c));
  }
  return cases;
}

// No legal rasterizer contradicts what is decided: each triangle alone by decide(), counts of all
// together by judge(). And turning over a sample that is decided is not legal.
TEST(Oracle, IsContradictedByNoLegalRasterizer) {
  std::size_t asked = 0;
  std::size_t open = 0;
  std::size_t turned = 0;
  std::size_t nth = 0;
  for (const subjects::MutantInfo& variant : subjects::Mutants()) {
    if (!variant.legal || nth++ % static_cast<std::size_t>(kOneCaseIn) != 0) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(variant.name);
    const SubjectInfo& info = subject->Info();
    if (info.coverage != CoverageKind::kFacingCounts) continue;
    const Opened profile(io::ProfileToJson(info.profile));
    for (const Case& c : CasesFor(info, nth, 7)) {
      std::vector<std::uint8_t> decisions;
      if (Decide(c.scene, profile, decisions) != RASTERPROOF_ORACLE_OK) continue;
      const std::size_t samples = SamplesOf(c.scene, profile);
      CoverageCounts together(c.scene.width, c.scene.height, info.profile.pattern.samples());
      bool is_drawn = true;
      for (std::size_t t = 0; t < c.scene.triangles.size() && is_drawn; ++t) {
        DrawJob job(c.scene, {}, info.profile.pattern.samples());
        job.triangles = {c.scene.triangles[t]};
        Drawing drawing;
        try {
          drawing = DrawOne(*subject, job);
        } catch (const std::exception&) {
          is_drawn = false;  // it refuses the scene
          break;
        }
        for (std::size_t s = 0; s < samples; ++s) {
          const std::uint8_t decision = decisions[t * samples + s];
          const bool covers = drawing.counts.Count(s) != 0;
          ++asked;
          open += decision == RASTERPROOF_ORACLE_MAY ? 1 : 0;
          const bool contradicts = decision == RASTERPROOF_ORACLE_MUST
                                       ? !covers
                                       : decision == RASTERPROOF_ORACLE_MUST_NOT && covers;
          ASSERT_FALSE(contradicts) << variant.name << ", triangle " << t << " sample " << s
                                    << " of " << io::SceneToJson(c.scene);
        }
        together += drawing.counts;
      }
      if (!is_drawn || info.profile.contract != Contract::kSampleExact) continue;
      std::vector<std::uint32_t> counts(samples);
      for (std::size_t s = 0; s < samples; ++s)
        counts[s] = static_cast<std::uint32_t>(together.Count(s));
      ASSERT_NE(Judged(c.scene, profile, counts), RASTERPROOF_ORACLE_NOT_LEGAL)
          << variant.name << ": " << rasterproof_oracle_message() << " "
          << io::SceneToJson(c.scene);
      if (c.scene.triangles.size() != 1 || decisions.front() == RASTERPROOF_ORACLE_MAY) continue;
      counts.front() = 1 - counts.front();
      EXPECT_EQ(Judged(c.scene, profile, counts), RASTERPROOF_ORACLE_NOT_LEGAL)
          << variant.name << " " << io::SceneToJson(c.scene);
      ++turned;
    }
  }
  EXPECT_GT(asked, 100'000U / static_cast<std::size_t>(kOneCaseIn));
  EXPECT_GT(open, 100U / static_cast<std::size_t>(kOneCaseIn));
  EXPECT_GT(turned, 10U / static_cast<std::size_t>(kOneCaseIn));
}

TEST(Oracle, JudgesAllSamplesTogether) {
  // Two halves of a square: on the diagonal each sample has one owner.
  Scene scene = OneTriangle({0, 0}, {8, 0}, {0, 8});
  scene.vertices.push_back({8, 8});
  scene.triangles.push_back({1, 3, 2});
  const Opened profile("gl");
  std::vector<std::uint32_t> counts(64, 1);
  EXPECT_EQ(Judged(scene, profile, counts), RASTERPROOF_ORACLE_LEGAL);
  EXPECT_EQ(Judged(scene, profile, counts, true), RASTERPROOF_ORACLE_LEGAL);
  counts[7] = 2;
  EXPECT_EQ(Judged(scene, profile, counts), RASTERPROOF_ORACLE_NOT_LEGAL);
  EXPECT_EQ(std::string(rasterproof_oracle_message()),
            "column 7 row 0: covered 2 times; legal models cover it 1 times");
  EXPECT_EQ(Judged(scene, profile, counts, true), RASTERPROOF_ORACLE_LEGAL) << "a mask counts none";
  counts[7] = 0;
  EXPECT_EQ(Judged(scene, profile, counts, true), RASTERPROOF_ORACLE_NOT_LEGAL);
  const GivenScene given(scene);
  std::vector<std::uint32_t> least(64);
  std::vector<std::uint32_t> most(64);
  ASSERT_EQ(rasterproof_oracle_bounds(profile.get(), &given.given, least.data(), most.data(), 64),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(least, std::vector<std::uint32_t>(64, 1));
  EXPECT_EQ(most, least);
}

TEST(Oracle, AnswersSingleQuestionsAsItAnswersWhole) {
  const Opened profile("vulkan");
  const Opened other("real");
  const Scene scene = OneTriangle({0.5, 0.5}, {7, 1}, {1, 7});
  std::vector<std::uint8_t> decisions;
  ASSERT_EQ(Decide(scene, profile, decisions), RASTERPROOF_ORACLE_OK);
  const auto covers = [&](const Opened& by, int column, int row) {
    return rasterproof_oracle_covers(by.get(), 8, 8, 0.5, 0.5, 7, 1, 1, 7, column, row, 0);
  };
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      EXPECT_EQ(covers(profile, column, row),
                decisions[static_cast<std::size_t>(row * 8 + column)]);
      EXPECT_NE(covers(other, column, row), RASTERPROOF_ORACLE_MAY) << "of another profile";
    }
  }
  EXPECT_EQ(covers(profile, 8, 0), RASTERPROOF_ORACLE_BAD_ARGUMENT);
  EXPECT_EQ(rasterproof_oracle_edge_sign(0, 0, 1, 0, 0, -0x1p-1074), 1);
  EXPECT_EQ(rasterproof_oracle_edge_sign(0, 0, 1, 0, 0, 0x1p-1074), -1);
  EXPECT_EQ(rasterproof_oracle_edge_sign(0, 0, 3, 3, 0x1p100, 0x1p100), 0);
  EXPECT_EQ(rasterproof_oracle_edge_sign(0, 0, 1, 0, kNan, 0), 2);
  double b[3] = {};
  ASSERT_EQ(rasterproof_oracle_barycentrics(0, 0, 3, 0, 0, 3, 1, 1, &b[0], &b[1], &b[2]),
            RASTERPROOF_ORACLE_OK);
  for (const double x : b) EXPECT_EQ(x, 1.0 / 3);
  // Numbers 1, 4, 1 at w = 1, 4, 1, half way along the edge of the first two: NUMERICS C9.
  const double corners[9] = {0, 0, 1, 16, 0, 4, 0, 4, 1};
  const double numbers[3] = {1, 4, 1};
  double value = 0, by_x = 0, by_y = 0;
  ASSERT_EQ(rasterproof_oracle_value(corners, numbers, 2, 2, 0, &value, &by_x, &by_y),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(value, 8.0 / 5);
  EXPECT_EQ(by_x, 12.0 / 25);
  ASSERT_EQ(rasterproof_oracle_value(corners, numbers, 1, 2, 0, &value, nullptr, nullptr),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(value, 2.5);
  EXPECT_EQ(rasterproof_oracle_value(corners, numbers, 0, 2, 0, &value, &by_x, &by_y),
            RASTERPROOF_ORACLE_BAD_ARGUMENT);
  EXPECT_EQ(rasterproof_oracle_barycentrics(0, 0, 3, 0, 6, 0, 1, 1, &b[0], &b[1], &b[2]),
            RASTERPROOF_ORACLE_NOT_DECIDED);
  double x = 0;
  double y = 0;
  const Opened quarter(R"({"name": "q", "subpixel_bits": 2, "snap_rule": "floor"})");
  ASSERT_EQ(rasterproof_oracle_place(quarter.get(), 8, 8, 1.49, -0.01, &x, &y),
            RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(x, 1.25);
  EXPECT_EQ(y, -0.25);
}

TEST(Oracle, NamesBadArgumentsAndTheRemedy) {
  const Opened profile("real");
  const Scene scene = OneTriangle({0, 0}, {8, 0}, {0, 8});
  std::vector<std::uint8_t> decisions(64);
  const auto expect_bad = [](rasterproof_oracle_status status, const std::string& part) {
    EXPECT_EQ(status, RASTERPROOF_ORACLE_BAD_ARGUMENT);
    const std::string message = rasterproof_oracle_message();
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  rasterproof_oracle_profile* opened = nullptr;
  expect_bad(rasterproof_oracle_open("vulcan", &opened), "vulkan");
  expect_bad(rasterproof_oracle_open(R"({"name": "n", "subpixel_bits": 40})", &opened),
             "subpixel_bits");
  expect_bad(rasterproof_oracle_open(nullptr, &opened), "text_or_preset: null");
  expect_bad(rasterproof_oracle_open("real", nullptr), "opened: null");
  EXPECT_EQ(opened, nullptr);
  GivenScene given(scene);
  const auto decide = [&](std::size_t size = 64) {
    return rasterproof_oracle_decide(profile.get(), &given.given, decisions.data(), size);
  };
  EXPECT_EQ(decide(), RASTERPROOF_ORACLE_OK);
  expect_bad(decide(63), "63 elements; give triangle_count * height * width * samples");
  given.triangles[2] = 3;
  expect_bad(decide(), "triangle 0: index 3 of 3 vertices");
  given.triangles[2] = -1;
  expect_bad(decide(), "index -1");
  given.triangles[2] = 2;
  given.given.vertices = nullptr;
  expect_bad(decide(), "scene.vertices: null");
  given.given.width = 0;
  expect_bad(decide(), "scene");
  expect_bad(rasterproof_oracle_decide(nullptr, &given.given, decisions.data(), 64),
             "profile: null");
  rasterproof_oracle_close(nullptr);
  EXPECT_EQ(rasterproof_oracle_samples(nullptr), 0);
}

TEST(Oracle, LeavesTheCallersFloatingPointModeAsItWas) {
  const Opened profile("real");
  const Scene scene = OneTriangle({0, 0}, {0x1p-1070, 0}, {0, 8});
  const auto mode = FloatEnvironment::kFlushToZero | FloatEnvironment::kDenormalsAreZero |
                    FloatEnvironment::kTowardZero;
  const FloatEnvironment::Bits before = FloatEnvironment::Current();
  FloatEnvironment::Set(before | mode);
  const int sign = rasterproof_oracle_edge_sign(0, 0, 0x1p-1070, 0, 0, 1);
  std::vector<std::uint8_t> decisions;
  const rasterproof_oracle_status status = Decide(scene, profile, decisions);
  const FloatEnvironment::Bits after = FloatEnvironment::Current();
  FloatEnvironment::Set(before);
  EXPECT_EQ(sign, -1) << "the subnormal number was not flushed";
  EXPECT_EQ(status, RASTERPROOF_ORACLE_OK);
  EXPECT_EQ(after & mode, mode);
}

}  // namespace
}  // namespace rasterproof
