// Fragments whose barycentrics or depths are no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

// The first triangle wins every sample, with what is no number for barycentrics and depth.
FakeSubject NoNumbers(double barycentric, double depth) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = CoverageKind::kFragments;
  return FakeSubject::Showing(info, [=](const DrawJob& job) {
    Drawing drawing;
    drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
    const std::size_t size = drawing.counts.size();
    drawing.primitive_ids.assign(size, job.Triangles().empty() ? kNoPrimitive : 0);
    drawing.barycentrics.assign(size, {barycentric, barycentric, barycentric});
    drawing.depths.assign(size, depth);
    return drawing;
  });
}

TEST(AFragmentThatIsNoNumber, IsAFindingWithItsWitness) {
  const Property& hull = *FindProperty("FragmentDepthStaysInTheHull");
  for (const double no_number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    FakeSubject depths = NoNumbers(1, no_number);
    FakeSubject barycentrics = NoNumbers(no_number, 0.5);
    for (const auto& [subject, name] :
         {std::pair<Subject*, std::string_view>{&depths, "FragmentDepthStaysInTheHull"},
          {&depths, "FragmentDepthFollowsItsBarycentrics"},
          {&barycentrics, "FragmentDepthFollowsItsBarycentrics"},
          {&barycentrics, "FragmentBarycentricsSumToOne"},
          {&barycentrics, "FragmentBarycentricsStayWithinTheirError"}}) {
      const PropertyResult result = RunCampaign(*subject, *FindProperty(name), {.cases = 40});
      ASSERT_EQ(result.outcome, Outcome::kViolated) << name;
      EXPECT_FALSE(result.counterexample->verdict.witness->observed.empty()) << name;
    }
    const PropertyResult result = RunCampaign(depths, hull, {.cases = 40});
    const std::string_view word = std::isnan(no_number) ? "nan" : "inf";
    const WitnessValue& seen = result.counterexample->verdict.witness->observed;
    EXPECT_NE(TextOfValue(seen).find(word), std::string::npos);
  }
}

}  // namespace
}  // namespace rasterproof::props
