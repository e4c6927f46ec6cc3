// Centroids on the pipe: asked for where they are shown and wanted, and read back.
#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

// The job of one pixel row for a subject of fragments, and the subject.
struct CentroidsAsked {
  CentroidsAsked(bool shows, bool takes_wants, Outputs wants) {
    info.coverage = CoverageKind::kFragments;
    info.takes_wants = takes_wants;
    info.fragments.shows_centroids = shows;
    Scene scene;
    scene.width = 2;
    scene.height = 1;
    scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
    scene.triangles = {{0, 1, 2}};
    job = DrawJob(scene, {}, 1);
    job.wants = wants;
  }
  std::string Text() const { return RequestsText(12, {&job, 1}, info); }
  Drawing Reads(const std::string& answer) const {
    std::istringstream lines(answer);
    std::string line;
    return ReadAnswer(12, job, info,
                      [&](std::size_t) {
                        std::getline(lines, line);
                        return std::string_view(line);
                      },
                      {});
  }

  SubjectInfo info;
  DrawJob job;
};

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(CentroidProtocol, AsksForCentroidsWhereTheyAreShownAndWanted) {
  Drawing drawing;
  drawing.counts = CoverageCounts(2, 1);
  drawing.counts.front = {1, 0};
  drawing.primitive_ids = {0, kNoPrimitive};
  drawing.barycentrics = {{0.25, 0.5, 0.25}, {}};
  drawing.depths = {0.125, 0};
  drawing.centroids = {{0.5, 0.375, 0.125}, {}};
  Outputs wants = kCoverageAndPrimitiveIds;
  wants.centroids = true;
  const CentroidsAsked alone(true, true, wants);
  EXPECT_TRUE(Contains(alone.Text(), " wants=primitive-ids,centroids\n"));
  const std::string answer = AnswerText(12, drawing, CoverageKind::kFragments, wants);
  EXPECT_EQ(answer, "fragments 12\n0 0.5 0.375 0.125 -1\n");
  EXPECT_EQ(alone.Reads(answer).centroids, drawing.centroids);
  EXPECT_TRUE(alone.Reads(answer).barycentrics.empty());
  EXPECT_THROW(alone.Reads("fragments 12\n0 0.5 0.375 -1\n"), SubjectStop);

  Outputs all = kEverything;
  all.centroids = true;
  const CentroidsAsked everything(true, true, all);
  EXPECT_TRUE(Contains(everything.Text(), " wants=primitive-ids,barycentrics,depths,centroids\n"));
  const Drawing read = everything.Reads(AnswerText(12, drawing, CoverageKind::kFragments, all));
  EXPECT_EQ(read.barycentrics, drawing.barycentrics);
  EXPECT_EQ(read.depths, drawing.depths);
  EXPECT_EQ(read.centroids, drawing.centroids);

  // Who shows none, or knows no such word, is asked as before.
  EXPECT_FALSE(Contains(CentroidsAsked(true, true, kEverything).Text(), "wants"));
  EXPECT_TRUE(Contains(CentroidsAsked(false, true, wants).Text(), " wants=primitive-ids\n"));
  EXPECT_FALSE(Contains(CentroidsAsked(false, false, wants).Text(), "wants"));
}

TEST(CentroidProtocol, RequestsReadBack) {
  Outputs wants = kCoverageAndPrimitiveIds;
  for (const bool centroids : {true, false}) {
    wants.centroids = centroids;
    std::istringstream in(CentroidsAsked(true, true, wants).Text());
    EXPECT_EQ(RequestReader(in).NextCall().front().job.wants, wants);
  }
  std::istringstream all(CentroidsAsked(true, true, kEverything).Text());
  EXPECT_EQ(RequestReader(all).NextCall().front().job.wants, kEverything);
}

}  // namespace
}  // namespace rasterproof::subjects
