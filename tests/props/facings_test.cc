#include "props/run/facings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/profile.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/run/facing_draws.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

// The exact model, but its facings are lost; as a mask its counts as well.
FakeSubject Faceless(const SubjectInfo& info) {
  return {info, [kind = info.coverage, profile = info.profile](
                    const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts = exact::Coverage(scene, profile, options);
            HideFacings(kind, counts);
          }};
}

void ExpectTheModel(CoverageKind kind, YAxis y_axis, const char* domain, bool clip) {
  SubjectInfo info = clip ? testing::RealInfo() : testing::SnappedInfo(8);
  info.takes_clip = clip;
  info.profile.y_axis = y_axis;
  info.coverage = kind;
  FakeSubject subject = Faceless(info);
  for (std::uint64_t index = 0; index < 40; ++index) {
    PhiloxSource bits(1, index);
    const Case c = FindDomain(domain)->draw(bits, info);
    CoverageCounts counts(c.scene.width, c.scene.height, c.profile.pattern.samples());
    DrawByFacing(subject, c.scene, c.options, counts);
    EXPECT_EQ(counts, exact::Coverage(c.scene, c.profile, c.options)) << domain << " " << index;
  }
}

TEST(Facings, OfCountsAndMasksAreThoseOfTheModel) {
  for (const CoverageKind kind : {CoverageKind::kCounts, CoverageKind::kMask}) {
    ExpectTheModel(kind, YAxis::kDown, "uniform-subpixel", false);
    ExpectTheModel(kind, YAxis::kUp, "uniform-subpixel", false);
    ExpectTheModel(kind, YAxis::kDown, "degenerate", false);
    ExpectTheModel(kind, YAxis::kDown, "mixed-w", true);
  }
}

TEST(Facings, TakeOneDrawForAMeshThatFacesOneWay) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = CoverageKind::kCounts;
  FakeSubject subject = Faceless(info);
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{0, 0}, {0, 4}, {4, 4}, {4, 0}};
  scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  CoverageCounts counts(4, 4);
  DrawByFacing(subject, scene, {}, counts);
  EXPECT_EQ(subject.draws, 1U);
  EXPECT_EQ(counts, exact::Coverage(scene, info.profile));
}

// What a call holds is at hand at once: the triangles of a map took gigabytes.
TEST(Facings, OfManyTrianglesTakeCallsOfABoundedSize) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = CoverageKind::kMask;
  FakeSubject subject = Faceless(info);
  Scene scene;
  scene.width = scene.height = 512;
  for (int n = 0; n < 9; ++n) {
    const double x = 50.0 * n;
    scene.vertices.insert(scene.vertices.end(), {{x, 0}, {x, 50}, {x + 50, 50}});
    scene.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
  }
  std::size_t largest_call = 0;
  subject.on_call = [&](std::span<const DrawJob> jobs) {
    std::size_t size = 0;
    for (const DrawJob& job : jobs) size += SizeInACall(job);
    largest_call = std::max(largest_call, size);
  };
  CoverageCounts counts(512, 512);
  DrawByFacing(subject, scene, {}, counts);
  EXPECT_EQ(subject.draws, 9U);
  EXPECT_LE(largest_call, kMostInACall);
  EXPECT_EQ(counts, exact::Coverage(scene, info.profile));
}

TEST(Facings, AreThoseOfTheProfileThatTheSubjectIsJudgedBy) {
  SubjectInfo info = testing::RealInfo();
  info.coverage = CoverageKind::kCounts;
  FakeSubject subject = Faceless(info);
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{0, 0}, {0, 4}, {4, 4}};
  scene.triangles = {{0, 1, 2}};
  info.profile.y_axis = YAxis::kUp;
  subject.JudgeAs(info);
  CoverageCounts counts(4, 4);
  DrawByFacing(subject, scene, {}, counts);
  EXPECT_EQ(subject.OwnInfo().profile.y_axis, YAxis::kDown);
  EXPECT_EQ(std::ranges::count(counts.front, 0U), 16);
  EXPECT_NE(std::ranges::count(counts.back, 0U), 16);
}

}  // namespace
}  // namespace rasterproof::props
