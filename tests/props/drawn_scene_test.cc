// A verdict tells the scene that was drawn, where the property had changed the case's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include "core/call_end.h"
#include "exact/coverage.h"
#include "props/property.h"
#include "props/run/trial.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;

constexpr int kSide = 8;

Case TriangleInEight() {
  Case c;
  c.scene.width = kSide;
  c.scene.height = kSide;
  c.scene.vertices = {{0.25, 0}, {7, 1}, {1, 6.5}};
  c.scene.triangles = {{0, 1, 2}};
  return c;
}

bool HasNan(const Scene& scene) {
  return std::ranges::any_of(scene.vertices, [](const Vertex& v) { return std::isnan(v.x); });
}

bool IsWide(const Scene& scene) { return scene.width > kSide; }
bool IsHigh(const Scene& scene) { return scene.height > kSide; }

using Which = std::function<bool(const Scene&)>;

// Right, but where `is_bad` says so: there it throws, or draws nothing.
Trial Tried(std::string_view property, const Which& is_bad, bool throws,
            const Case& c = TriangleInEight()) {
  SubjectInfo info = RealInfo();
  info.profile = c.profile;
  info.takes_scissor = true;
  const auto draw = [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
    if (is_bad(scene) && throws) throw SubjectStop(Stop::kHung, "it gives no answer");
    if (!is_bad(scene)) counts += exact::Coverage(scene, c.profile, options);
  };
  FakeSubject alone(info, draw);
  FakeSubject together = FakeSubject::Outside(info, draw);
  const Trial trial = TryCase(alone, *FindProperty(property), c);
  const Trial of_shared_calls = TryCase(together, *FindProperty(property), c);
  EXPECT_EQ(trial.verdict.drawn == nullptr, of_shared_calls.verdict.drawn == nullptr) << property;
  return trial;
}

struct Change {
  std::string_view property;
  Which is_bad;
};

const std::initializer_list<Change> kChanges{
    {"BadTrianglesPoisonNoOthers", HasNan},
    {"TargetWidthKeepsCoverage", IsWide},
    {"TargetHeightKeepsCoverage", IsHigh},
    {"IntegerTranslationMovesCoverage", [](const Scene& s) { return s.vertices[1].x != 7; }},
    {"ReversalSwapsFacing", [](const Scene& s) { return s.triangles[0][1] == 2; }},
    {"VertexRotationKeepsCoverage", [](const Scene& s) { return s.triangles[0][0] != 0; }},
};

TEST(DrawnScene, IsTheChangedOneWhereThatIsDrawnWrongly) {
  for (const Change& change : kChanges) {
    const Verdict verdict = Tried(change.property, change.is_bad, false).verdict;
    ASSERT_EQ(verdict.outcome, Outcome::kViolated) << change.property;
    ASSERT_NE(verdict.drawn, nullptr) << change.property;
    EXPECT_TRUE(change.is_bad(verdict.drawn->scene)) << change.property;
  }
}

TEST(DrawnScene, IsTheChangedOneWhereThatBreaksTheSubject) {
  for (const Change& change : kChanges) {
    const Trial trial = Tried(change.property, change.is_bad, true);
    EXPECT_EQ(trial.stop, Stop::kHung) << change.property;
    ASSERT_NE(trial.verdict.drawn, nullptr) << change.property;
    EXPECT_TRUE(change.is_bad(trial.verdict.drawn->scene)) << change.property;
  }
}

// The framed target is drawn with the case's own as its scissor.
TEST(DrawnScene, TellsHowItWasDrawn) {
  const Trial trial = Tried("DrawStaysInsideItsTarget", IsWide, true);
  ASSERT_NE(trial.verdict.drawn, nullptr);
  EXPECT_TRUE(IsWide(trial.verdict.drawn->scene));
  ASSERT_TRUE(trial.verdict.drawn->options.scissor.has_value());
  EXPECT_EQ(*trial.verdict.drawn->options.scissor, (PixelRect{0, 0, kSide, kSide}));
}

// With y up the rows of the lower target are the last ones of the higher.
TEST(DrawnScene, HasTheWitnessInIt) {
  Case c = TriangleInEight();
  c.profile.y_axis = YAxis::kUp;
  const Verdict verdict = Tried("TargetHeightKeepsCoverage", IsHigh, false, c).verdict;
  ASSERT_NE(verdict.drawn, nullptr);
  ASSERT_TRUE(verdict.witness.has_value());
  Case drawn = c;
  drawn.scene = verdict.drawn->scene;
  const CoverageCounts model = exact::Coverage(drawn.scene, drawn.profile, {});
  EXPECT_NE(model.Count(model.Index(verdict.witness->x, verdict.witness->y, 0)), 0U);
}

TEST(DrawnScene, IsNoneWhereTheCaseItselfFails) {
  const auto always = [](const Scene&) { return true; };
  EXPECT_EQ(Tried("CoverageEqualsTheModel", always, false).verdict.drawn, nullptr);
  EXPECT_EQ(Tried("CoverageEqualsTheModel", always, true).verdict.drawn, nullptr);
  // What is drawn first is the case.
  for (const Change& change : kChanges) {
    const Trial trial = Tried(change.property, always, true);
    EXPECT_EQ(trial.stop, Stop::kHung);
    EXPECT_EQ(trial.verdict.drawn, nullptr) << change.property;
  }
}

}  // namespace
}  // namespace rasterproof::props
