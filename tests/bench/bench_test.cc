#include "bench/bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/ulp.h"
#include "exact/coverage.h"

namespace rasterproof::bench {
namespace {

// The oracle as a subject, with faults to order.
class Draughtsman final : public Subject {
 public:
  explicit Draughtsman(std::string name) { info_.name = std::move(name); }

  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    ++draws;
    Scene drawn = scene;
    if (leaves_out_first) drawn.triangles.erase(drawn.triangles.begin());
    counts = exact::Coverage(drawn, info_.profile, options);
    if (draws_twice) {
      for (std::uint32_t& count : counts.front) count *= 2;
    }
  }

  SubjectInfo info_;
  bool leaves_out_first = false;
  bool draws_twice = false;
  int draws = 0;
};

BenchResult RunOnce(std::vector<Subject*> subjects, int repetitions = 1) {
  BenchOptions options;
  options.repetitions = repetitions;
  return RunBench(subjects, options);
}

TEST(FamiliesTest, AreFourOfFloat32WithinTheirTargets) {
  const std::vector<Family> families = Families(1);
  ASSERT_EQ(families.size(), 4U);
  for (const Family& family : families) {
    EXPECT_FALSE(family.scene.triangles.empty()) << family.name;
    for (const Vertex& v : family.scene.vertices) {
      EXPECT_TRUE(IsFloat32(v.x) && IsFloat32(v.y)) << family.name;
      EXPECT_TRUE(v.x >= 0 && v.x <= family.scene.width) << family.name;
      EXPECT_TRUE(v.y >= 0 && v.y <= family.scene.height) << family.name;
    }
    for (const Triangle& triangle : family.scene.triangles) {
      const auto v = Corners(family.scene, triangle);
      EXPECT_EQ(exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}), 1);
    }
  }
}

TEST(FamiliesTest, AreTheSameForTheSameSeedAndOthersForAnother) {
  EXPECT_EQ(Families(1)[0].scene, Families(1)[0].scene);
  EXPECT_NE(Families(1)[0].scene, Families(2)[0].scene);
}

TEST(FamiliesTest, NeedlesAreThinnerThanAPixel) {
  for (const Family& family : Families(1)) {
    if (family.name != "needles") continue;
    for (const Triangle& triangle : family.scene.triangles) {
      const auto v = Corners(family.scene, triangle);
      double shortest = 1e9;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& a = v[k];
        const Vertex& b = v[(k + 1) % 3];
        shortest = std::min(shortest, std::hypot(a.x - b.x, a.y - b.y));
      }
      EXPECT_LE(shortest, 1.01);
    }
  }
}

TEST(BenchTest, TheOracleIsNeverWrong) {
  Draughtsman exact("exact");
  const BenchResult result = RunOnce({&exact});
  ASSERT_EQ(result.rows.size(), 4U);
  for (const BenchRow& row : result.rows) {
    EXPECT_EQ(row.against_own.wrong, 0U);
    EXPECT_EQ(row.against_real.wrong, 0U);
    EXPECT_GT(row.against_real.covered, 0U);
    EXPECT_GE(row.box_pixels, row.triangles);
    EXPECT_DOUBLE_EQ(row.ratio, 1);
  }
}

TEST(BenchTest, CountsGapsAndOverlapsApart) {
  Draughtsman gap("gap");
  gap.leaves_out_first = true;
  Draughtsman overlap("overlap");
  overlap.draws_twice = true;
  const BenchResult result = RunOnce({&gap, &overlap});
  for (const BenchRow& row : result.rows) {
    const bool gaps = row.subject == "gap";
    EXPECT_EQ(row.against_real.missing != 0, gaps) << row.family;
    EXPECT_EQ(row.against_real.unexpected != 0, !gaps) << row.family;
  }
}

TEST(BenchTest, ASnappedSubjectIsRightForItsProfileAndWrongForRealGeometry) {
  Draughtsman snapped("snapped");
  snapped.info_.profile = *PresetProfile("d3d11-canonical");
  snapped.info_.profile.snap.bits = 1;
  Draughtsman real("real");
  for (const BenchRow& row : RunOnce({&snapped, &real}).rows) {
    EXPECT_EQ(row.arithmetic, row.subject == "snapped" ? "fixed point" : "float32");
    EXPECT_EQ(row.against_own.wrong, 0U) << row.family;
    EXPECT_EQ(row.against_real.wrong != 0, row.subject == "snapped") << row.family;
  }
}

TEST(BenchTest, ProfilesThatDifferOnlyInTheirTieRuleHaveTruthsOfTheirOwn) {
  // Both snap to half pixels, so that many samples lie on edges.
  Draughtsman top_left("top-left");
  top_left.info_.profile.snap.bits = 1;
  Draughtsman bottom_right = top_left;
  bottom_right.info_.name = "bottom-right";
  bottom_right.info_.profile.tie_rule = *TieRuleFromName("bottom-right");
  for (const BenchRow& row : RunOnce({&top_left, &bottom_right}).rows) {
    EXPECT_EQ(row.against_own.wrong, 0U) << row.family << row.subject;
  }
}

TEST(BenchTest, InterleavesAndRepeatsEachDraw) {
  Draughtsman exact("exact");
  Draughtsman baseline{std::string(kBaseline)};
  const BenchResult result = RunOnce({&exact, &baseline}, 3);
  EXPECT_EQ(exact.draws, 4 * 3);
  EXPECT_EQ(result.baseline, kBaseline);
  EXPECT_EQ(result.repetitions, 3);
  for (const BenchRow& row : result.rows) {
    EXPECT_LE(row.least_seconds, row.median_seconds);
    if (row.subject == kBaseline) {
      EXPECT_DOUBLE_EQ(row.ratio, 1);
    }
  }
}

TEST(BenchTest, LeavesOutSubjectsThatDoNotTakeTheScenes) {
  Draughtsman exact("exact");
  Draughtsman clip("clip");
  clip.info_.takes_window = false;
  const BenchResult result = RunOnce({&clip, &exact});
  EXPECT_EQ(clip.draws, 0);
  for (const BenchRow& row : result.rows) EXPECT_EQ(row.subject, "exact");
}

TEST(BenchTest, SaysWhatItIsDoing) {
  Draughtsman exact("exact");
  std::set<std::string> stages;
  BenchOptions options;
  options.repetitions = 1;
  options.progress = [&](const std::string& stage) { stages.insert(stage); };
  Subject* subject = &exact;
  RunBench({&subject, 1}, options);
  EXPECT_EQ(stages.size(), 4U);
}

}  // namespace
}  // namespace rasterproof::bench
