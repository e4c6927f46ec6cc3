// Fragments whose barycentrics or depths are no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "exact/coverage.h"
#include "props/run/campaign.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;

// The first triangle wins every sample, with what is no number for barycentrics and depth.
class NoNumbers final : public Subject {
 public:
  NoNumbers(double barycentric, double depth) : barycentric_(barycentric), depth_(depth) {
    info_.coverage = CoverageKind::kFragments;
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    counts += exact::Coverage(scene, Profile{}, options);
  }
  Drawing Show(const DrawJob& job) override {
    Drawing drawing;
    drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
    drawing.primitive_ids.assign(drawing.counts.size(), job.Triangles().empty() ? kNoPrimitive : 0);
    drawing.barycentrics.assign(drawing.counts.size(), {barycentric_, barycentric_, barycentric_});
    drawing.depths.assign(drawing.counts.size(), depth_);
    return drawing;
  }

 private:
  SubjectInfo info_ = RealInfo();
  double barycentric_;
  double depth_;
};

TEST(AFragmentThatIsNoNumber, IsAFindingWithItsWitness) {
  const Property& hull = *FindProperty("FragmentDepthStaysInTheHull");
  for (const double no_number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    NoNumbers depths(1, no_number);
    NoNumbers barycentrics(no_number, 0.5);
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
    EXPECT_NE(result.counterexample->verdict.witness->observed.find(word), std::string::npos);
  }
}

}  // namespace
}  // namespace rasterproof::props
