// What a run did not ask of what a subject shows and takes, by what was drawn.
#include "props/run/not_asked.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/subject_info.h"
#include "exact/coverage.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/fake_subject.h"

namespace rasterproof::props {
namespace {

// Draws by the exact model. Affine weights of the places as given: wrong in perspective.
FakeSubject ShowsFragments(bool takes_window, bool takes_clip) {
  SubjectInfo info;
  info.coverage = CoverageKind::kFragments;
  info.takes_window = takes_window;
  info.takes_clip = takes_clip;
  info.takes_culling = info.takes_scissor = info.takes_tiles = false;
  return FakeSubject::Showing(info, [](const DrawJob& job) {
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height);
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      Scene alone = scene;
      alone.triangles = {scene.triangles[t]};
      const auto v = Corners(scene, scene.triangles[t]);
      const CoverageCounts covered = exact::Coverage(alone, Profile{});
      for (std::size_t k = 0; k < covered.size(); ++k) {
        if (covered.Count(k) == 0) continue;
        const auto width = static_cast<std::size_t>(scene.width);
        const double x = static_cast<double>(k % width) + 0.5;
        const double y = static_cast<double>(k / width) + 0.5;
        const auto edge = [&](std::size_t i, std::size_t j, double px, double py) {
          return (px - v[i].x) * (v[j].y - v[i].y) - (py - v[i].y) * (v[j].x - v[i].x);
        };
        const double area = edge(0, 1, v[2].x, v[2].y);
        drawing.counts.front[k] = 1;
        drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
        drawing.barycentrics[k] = {edge(1, 2, x, y) / area, edge(2, 0, x, y) / area,
                                   edge(0, 1, x, y) / area};
        for (std::size_t i = 0; i < 3; ++i) {
          drawing.depths[k] += drawing.barycentrics[k][i] * v[i].z;
        }
      }
    }
    return drawing;
  });
}

std::vector<PropertyResult> ResultsOf(FakeSubject& subject,
                                      std::vector<std::string_view> properties,
                                      std::uint64_t cases = 8) {
  std::vector<PropertyResult> results;
  for (const std::string_view name : properties) {
    CampaignOptions options;
    options.cases = cases;
    results.push_back(RunCampaign(subject, *FindProperty(name), options));
  }
  return results;
}

// "centroids in clip space: no property judges them".
std::vector<std::string> Lines(FakeSubject& subject, const std::vector<PropertyResult>& results) {
  std::vector<std::string> lines;
  for (const NotAskedOf& one : NotAsked(subject.Info(), OutputsOf(subject), results)) {
    lines.push_back(one.what + (one.why.empty() ? "" : ": " + one.why));
  }
  return lines;
}

const std::vector<std::string_view> kOfFragments{
    "CoverageEqualsTheModel", "PrimitiveIdFollowsTheStatedOrder",
    "FragmentBarycentricsStayWithinTheirError", "FragmentDepthStaysInTheHull"};

std::uint64_t Largest(const std::vector<PropertyResult>& results) {
  std::uint64_t largest = 0;
  for (const PropertyResult& result : results)
    largest = std::max(largest, result.draws.largest_target);
  return largest;
}

std::string Above(const std::vector<PropertyResult>& results) {
  return "targets above " + std::to_string(Largest(results)) + " samples";
}

TEST(NotAsked, NamesOutputsThatNoPropertyWasAskedAboutInASpaceThatIsTaken) {
  FakeSubject subject = ShowsFragments(true, true);
  std::vector<std::string_view> properties = kOfFragments;
  properties.push_back("ClipSpaceCoverageEqualsTheModel");
  auto results = ResultsOf(subject, properties, 40);
  EXPECT_EQ(
      Lines(subject, results),
      (std::vector<std::string>{
          "barycentrics, depths in clip space: no property about them applies", Above(results)}));
  for (PropertyResult& more :
       ResultsOf(subject,
                 {"ClipBarycentricsStayWithinTheirError", "ClipDepthsStayWithinTheirError"}, 40)) {
    results.push_back(std::move(more));
  }
  EXPECT_EQ(Lines(subject, results), std::vector{Above(results)});
}

TEST(NotAsked, ASpaceThatIsNotTakenIsNoneOfItsBusiness) {
  FakeSubject subject = ShowsFragments(true, false);
  const auto results = ResultsOf(subject, kOfFragments);
  EXPECT_GT(Largest(results), 0U);
  EXPECT_EQ(Lines(subject, results), std::vector{Above(results)});
}

TEST(NotAsked, NothingIsSaidWhereAllWasAsked) {
  FakeSubject subject = ShowsFragments(true, false);
  std::vector<PropertyResult> results = ResultsOf(subject, kOfFragments);
  subject.info.profile.max_target = {1, 1};  // of what is drawn none is larger
  EXPECT_TRUE(Lines(subject, results).empty());
}

TEST(NotAsked, GoesByWhatWasDrawnAndJudged) {
  FakeSubject subject = ShowsFragments(true, false);
  const auto results = ResultsOf(subject, {"CoverageEqualsTheModel"});
  const auto lines = Lines(subject, results);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front(),
            "primitive ids, barycentrics, depths in window space: no property about them applies");
  EXPECT_GT(results.front().draws.window, 0U);
  EXPECT_EQ(results.front().draws.clip, 0U);
}

TEST(NotAsked, DrawsOfPartsOfARunAddUp) {
  FakeSubject subject = ShowsFragments(true, false);
  const Property& property = *FindProperty("CoverageEqualsTheModel");
  CampaignOptions options;
  options.cases = 12;
  const PropertyResult whole = RunCampaign(subject, property, options);
  options.cases = 5;
  PropertyResult sum = RunCampaign(subject, property, options);
  options.first_case = 5;
  options.cases = 7;
  sum += RunCampaign(subject, property, options);
  EXPECT_EQ(sum.draws.window, whole.draws.window);
  EXPECT_EQ(sum.draws.clip, whole.draws.clip);
  EXPECT_EQ(sum.draws.largest_target, whole.draws.largest_target);
}

}  // namespace
}  // namespace rasterproof::props
