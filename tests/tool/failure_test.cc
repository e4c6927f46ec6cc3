#include "tool/failure.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>

#include "core/case.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "core/witness.h"
#include "props/property.h"
#include "props/run/campaign_options.h"
#include "props/run/counterexample.h"
#include "tests/fake_subject.h"

namespace rasterproof::tool {
namespace {

std::string SaidOf(WitnessValue observed, WitnessValue expected,
                   CoverageKind shown = CoverageKind::kCounts) {
  Witness witness;
  witness.observed = std::move(observed);
  witness.expected = std::move(expected);
  SubjectInfo info;
  info.coverage = shown;
  const Verdict said = WithCountsAsGiven(Verdict::Violated(1, "", witness), info);
  return TextOfValue(said.witness->observed) + ", not " + TextOfValue(said.witness->expected);
}

TEST(WithCountsAsGiven, LeavesOutFacingsThatTheSubjectDoesNotShow) {
  const WitnessValue two{FacingCounts{1, 1}};
  const WitnessValue one{FacingCounts{1, 0}, "; exact E: ", RationalText{"-1/2"}};
  EXPECT_EQ(SaidOf(two, one), "2, not 1; exact E: -1/2");
  EXPECT_EQ(SaidOf(two, one, CoverageKind::kFacingCounts),
            "front 1, back 1, not front 1, back 0; exact E: -1/2");
}

TEST(WithCountsAsGiven, KeepsThemWhereTheFacingAloneIsWrong) {
  EXPECT_EQ(SaidOf({FacingCounts{0, 1}}, {FacingCounts{1, 0}}),
            "front 0, back 1, not front 1, back 0");
}

TEST(WithCountsAsGiven, KeepsWordsThatLookLikeCounts) {
  EXPECT_EQ(SaidOf({"front 1, back 1"}, {FacingCounts{1, 0}}),
            "front 1, back 1, not front 1, back 0");
  EXPECT_EQ(SaidOf({"front 1, back 1"}, {"front 1, back 0"}),
            "front 1, back 1, not front 1, back 0");
  EXPECT_EQ(SaidOf({}, {FacingCounts{1, 0}}), ", not front 1, back 0");
}

// The case is judged once more when nothing smaller fails; who is to blame and what the picture
// shows is read from that draw.
TEST(FailingCase, IsDrawnOnceAfterShrinking) {
  for (const CoverageKind shown : {CoverageKind::kFacingCounts, CoverageKind::kCounts}) {
    SubjectInfo info;
    info.coverage = shown;
    FakeSubject drawing_nothing(info, [](const auto&, const auto&, const auto&) {});
    Case c;
    c.scene.width = c.scene.height = 2;
    c.scene.vertices = {{0, 0}, {0, 2}, {2, 0}};
    c.scene.triangles = {{0, 1, 2}};
    props::CampaignOptions nothing_smaller;
    nothing_smaller.shrink_budget = 0;
    Counterexample found = props::ShrinkFailing(
        drawing_nothing, *props::FindProperty("CoverageEqualsTheModel"), c, nothing_smaller);
    ASSERT_EQ(found.outcome, Outcome::kViolated);
    EXPECT_EQ(found.verdict.witness->triangle, 0);
    SeeIfItCan(drawing_nothing, found.value, found.verdict);
    EXPECT_NE(FailureText(info, "", found.value, found.verdict, "").find("missing"),
              std::string::npos);
    constexpr std::size_t kFirstFailure = 1;
    EXPECT_EQ(drawing_nothing.draws, kFirstFailure + 1);
  }
}

}  // namespace
}  // namespace rasterproof::tool
