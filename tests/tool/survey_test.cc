// What the survey of real rasterizers says is only worth as much as its scenes and its children.
#include "tool/survey/survey.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/snap.h"
#include "exact/coverage.h"
#include "io/output.h"
#include "tool/survey/families.h"
#include "tool/survey/fit.h"
#include "tool/survey/isolated.h"

namespace rasterproof::tool {
namespace {

Profile Model(int bits, SnapRule rule) {
  Profile model = *PresetProfile("real");
  model.snap = {bits, rule};
  model.coordinate_limit = 32767;
  return model;
}

// The oracle, posing as a rasterizer of some model.
class ModelSubject final : public Subject {
 public:
  explicit ModelSubject(const Profile& model) : model_(model) { info_.input = Precision::kFloat64; }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    counts = exact::Coverage(scene, model_, options);
  }

 private:
  Profile model_;
  SubjectInfo info_;
};

TEST(SurveyFamilies, MeshesCoverEverySampleOnceBeforeAndAfterSnapping) {
  constexpr std::array<Snap, 3> kSnaps{Snap{}, Snap{8, SnapRule::kNearestEven},
                                       Snap{0, SnapRule::kTruncate}};
  for (const Snap& snap : kSnaps) {
    const Profile model = Model(snap.bits, snap.rule);
    for (const Family& family : Families()) {
      if (family.kind != FamilyKind::kCover) continue;
      for (std::uint64_t index = 0; index < 40; ++index) {
        const Scene scene = family.draw(index, model, Precision::kFloat32);
        const CoverageCounts counts = exact::Coverage(scene, model);
        for (std::size_t k = 0; k < counts.size(); ++k) {
          ASSERT_EQ(counts.Count(k), 1U) << family.name << ", case " << index << ", sample " << k;
        }
      }
    }
  }
}

TEST(SurveyFamilies, KeepToTheLimitAndTheInputFormat) {
  Profile model = Model(8, SnapRule::kNearestEven);
  model.coordinate_limit = 100;
  for (const Family& family : Families()) {
    for (std::uint64_t index = 0; index < 200; ++index) {
      for (const Vertex& v : family.draw(index, model, Precision::kFloat32).vertices) {
        EXPECT_LE(std::abs(v.x), 100) << family.name;
        EXPECT_EQ(v.y, double{static_cast<float>(v.y)}) << family.name;
      }
    }
  }
}

TEST(SurveyFamilies, TheSameCaseIsTheSameScene) {
  const Profile model = Model(8, SnapRule::kNearestEven);
  for (const Family& family : Families()) {
    EXPECT_EQ(family.draw(7, model, Precision::kFloat64),
              family.draw(7, model, Precision::kFloat64));
    EXPECT_NE(family.draw(7, model, Precision::kFloat64),
              family.draw(8, model, Precision::kFloat64));
  }
}

TEST(SurveyFit, FindsTheModelOfTheOracle) {
  Profile model = *PresetProfile("real");
  model.snap = {4, SnapRule::kFloor};
  model.fill_rule = *FillRuleFromName("bottom-right");
  ModelSubject subject(model);
  const std::vector<Fit> fits = FitModels(subject, *PresetProfile("real"), 200);
  ASSERT_FALSE(fits.empty());
  EXPECT_EQ(fits[0].wrong, 0U);
  EXPECT_EQ(fits[0].model.snap, model.snap);
  EXPECT_EQ(fits[0].model.fill_rule.sign_x, -1);  // sign_y shows at level edges alone
}

// Covers nothing, whatever it is asked.
constexpr const char* kBlankProgram = R"sh(
while read -r draw number width height samples space vertices triangles; do
  for line in $(seq $((vertices + triangles))); do read -r skipped; done
  echo "counts $number"
  yes "$(seq -s ' ' "$width" | sed 's/[0-9][0-9]*/0/g')" | head -n "$height"
done
)sh";

TEST(Survey, TakesADescriptionOfAProgram) {
  const std::string program = testing::TempDir() + "blank.sh";
  const std::string path = testing::TempDir() + "blank.subject";
  io::WriteFile(program, kBlankProgram);
  io::WriteFile(path, "command sh '" + program + "'\nprofile gl\n");
  const Survey survey = RunSurvey(
      {.path = path, .cases = 2, .seconds = 20, .fitting_triangles = 8, .shrink_budget = 1});
  EXPECT_EQ(survey.subject, "blank");
  EXPECT_EQ(survey.declared.name, "gl");
  ASSERT_EQ(survey.families.size(), Families().size());
  for (const FamilySurvey& family : survey.families) {
    const FamilyTally& tally = family.tally;
    EXPECT_EQ(tally.scenes + tally.refused, 2U) << family.family->name;
    const bool is_mesh = family.family->kind == FamilyKind::kCover;
    EXPECT_EQ(tally.gaps, is_mesh ? tally.samples : 0) << family.family->name;
  }
  EXPECT_NE(SurveyToJson(survey).find("\"own_share\": 0."), std::string::npos);
}

TEST(Isolated, TellsHowAChildEnded) {
  Shared<std::atomic<std::uint64_t>> progress;
  EXPECT_EQ(RunIsolated([&] { ++*progress; }, *progress, 5), "");
  EXPECT_EQ(progress->load(), 1U);
  EXPECT_EQ(RunIsolated([] { std::abort(); }, *progress, 5), "killed by signal 6");
  EXPECT_EQ(RunIsolated([] { throw std::runtime_error("no"); }, *progress, 5),
            "ended with status 1");
}

TEST(Isolated, EndsAChildThatMakesNoProgress) {
  Shared<std::atomic<std::uint64_t>> progress;
  const auto forever = [] {
    std::atomic<bool> never = false;
    never.wait(false);
  };
  EXPECT_EQ(RunIsolated(forever, *progress, 1), "no answer for 1 s");
}

}  // namespace
}  // namespace rasterproof::tool
