#include "tool/failure.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/subject_info.h"
#include "core/verdict.h"
#include "core/witness.h"

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

}  // namespace
}  // namespace rasterproof::tool
