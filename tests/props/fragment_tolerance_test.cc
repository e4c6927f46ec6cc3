// Rasterizers that compute barycentrics and depths in float32 by one of the usual forms and state
// no error of their own: each rounds in its own way, and none is at fault.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/subject_info.h"
#include "exact/coverage.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/fake_subject.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using Barycentrics3 = std::array<float, 3>;

float Edge(const std::array<Vertex, 3>& v, std::size_t i, std::size_t j, float x, float y) {
  const auto ax = static_cast<float>(v[i].x), ay = static_cast<float>(v[i].y);
  const auto bx = static_cast<float>(v[j].x), by = static_cast<float>(v[j].y);
  return (x - ax) * (by - ay) - (y - ay) * (bx - ax);
}

Barycentrics3 OverVertexArea(const std::array<Vertex, 3>& v, float x, float y) {
  const float area = Edge(v, 0, 1, static_cast<float>(v[2].x), static_cast<float>(v[2].y));
  return {Edge(v, 1, 2, x, y) / area, Edge(v, 2, 0, x, y) / area, Edge(v, 0, 1, x, y) / area};
}

Barycentrics3 OverTheirSum(const std::array<Vertex, 3>& v, float x, float y) {
  const Barycentrics3 e{Edge(v, 1, 2, x, y), Edge(v, 2, 0, x, y), Edge(v, 0, 1, x, y)};
  const float sum = e[0] + e[1] + e[2];
  return {e[0] / sum, e[1] / sum, e[2] / sum};
}

Barycentrics3 OneMinusTheOthers(const std::array<Vertex, 3>& v, float x, float y) {
  const Barycentrics3 l = OverVertexArea(v, x, y);
  return {l[0], l[1], 1 - l[0] - l[1]};
}

Barycentrics3 OneMinusTheOthersFirst(const std::array<Vertex, 3>& v, float x, float y) {
  const Barycentrics3 l = OverVertexArea(v, x, y);
  return {1 - l[2] - l[1], l[1], l[2]};
}

float ByBarycentrics(const Barycentrics3& l, const std::array<Vertex, 3>& v) {
  return l[0] * static_cast<float>(v[0].z) + l[1] * static_cast<float>(v[1].z) +
         l[2] * static_cast<float>(v[2].z);
}

float ByDeltas(const Barycentrics3& l, const std::array<Vertex, 3>& v) {
  const auto z = static_cast<float>(v[0].z);
  return z + l[1] * (static_cast<float>(v[1].z) - z) + l[2] * (static_cast<float>(v[2].z) - z);
}

struct Form {
  std::string name;
  Barycentrics3 (*barycentrics)(const std::array<Vertex, 3>&, float, float);
  float (*depth)(const Barycentrics3&, const std::array<Vertex, 3>&);
};

void DrawTriangle(const Form& form, const Scene& scene, std::size_t t, Drawing& drawing) {
  const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
  Scene alone = scene;
  alone.triangles = {scene.triangles[t]};
  const CoverageCounts covered = exact::Coverage(alone, Profile{});
  for (std::size_t k = 0; k < covered.size(); ++k) {
    if (covered.Count(k) == 0) continue;
    const auto width = static_cast<std::size_t>(scene.width);
    const float x = static_cast<float>(k % width) + 0.5F;
    const float y = static_cast<float>(k / width) + 0.5F;
    const Barycentrics3 l = form.barycentrics(v, x, y);
    drawing.counts.front[k] = 1;
    drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
    drawing.barycentrics[k] = {l[0], l[1], l[2]};
    drawing.depths[k] = form.depth(l, v);
  }
}

FakeSubject Honest(const Form& form) {
  SubjectInfo info;
  info.name = form.name;
  info.coverage = CoverageKind::kFragments;
  info.takes_culling = info.takes_scissor = info.takes_tiles = false;
  return FakeSubject::Showing(info, [form](const DrawJob& job) {
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height);
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) DrawTriangle(form, scene, t, drawing);
    return drawing;
  });
}

class FragmentTolerance : public ::testing::TestWithParam<Form> {};

TEST_P(FragmentTolerance, AUsualFormNeedsNoStatement) {
  FakeSubject subject = Honest(GetParam());
  for (const char* name :
       {"FragmentBarycentricsSumToOne", "FragmentBarycentricsStayWithinTheirError",
        "FragmentDepthStaysInTheHull", "FragmentDepthFollowsItsBarycentrics"}) {
    CampaignOptions options;
    options.cases = Cases(600U);
    const PropertyResult result = RunCampaign(subject, *FindProperty(name), options);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << name << ": " << result.message;
    EXPECT_LE(result.worst_ratio, 1) << name;
    EXPECT_GT(result.cases_exercised, kOneCaseIn > 1 ? 0U : 100U) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, FragmentTolerance,
                         ::testing::Values(Form{"vertex area", OverVertexArea, ByBarycentrics},
                                           Form{"vertex area, deltas", OverVertexArea, ByDeltas},
                                           Form{"sum", OverTheirSum, ByBarycentrics},
                                           Form{"sum, deltas", OverTheirSum, ByDeltas},
                                           Form{"one minus", OneMinusTheOthers, ByBarycentrics},
                                           Form{"one minus, deltas", OneMinusTheOthers, ByDeltas},
                                           Form{"one minus first", OneMinusTheOthersFirst,
                                                ByDeltas}));

}  // namespace
}  // namespace rasterproof::props
