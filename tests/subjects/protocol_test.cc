#include "subjects/process/protocol.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/subject.h"
#include "subjects/process/serve.h"

namespace rasterproof::subjects {
namespace {

DrawRequest SomeRequest() {
  Scene scene;
  scene.width = 3;
  scene.height = 2;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{0.1, -0.0, 0x1p-1074, 1},
                    {1e300, std::numeric_limits<double>::infinity(), 0, 1},
                    {0x1.fffffffffffffp1023, 1.0 / 3, -2, 1}};
  scene.triangles = {{0, 1, 2}, {2, 1, 0}};
  DrawRequest request{7, {scene, {}, 2}};
  request.job.options.cull = Cull::kBack;
  request.job.options.scissor = PixelRect{-1, 0, 2, 2};
  request.job.options.tile = 8;
  request.job.options.threads = 3;
  return request;
}

TEST(Protocol, CarriesARequestWithoutLosingABit) {
  const DrawRequest request = SomeRequest();
  std::istringstream in(RequestText(request.id, request.job));
  const std::vector<DrawRequest> read = ReadCall(in);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].id, request.id);
  EXPECT_EQ(read[0].job.samples, request.job.samples);
  EXPECT_EQ(SceneOf(read[0].job), SceneOf(request.job));
  EXPECT_EQ(read[0].job.options, request.job.options);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(read[0].job.scene->vertices[0].y), std::uint64_t{1} << 63);
  EXPECT_TRUE(ReadCall(in).empty());
}

TEST(Protocol, CarriesWhatIsNoNumber) {
  DrawRequest request = SomeRequest();
  Scene scene = *request.job.scene;
  scene.vertices[1].x = std::numeric_limits<double>::quiet_NaN();
  request.job.scene = std::make_shared<const Scene>(scene);
  std::istringstream in(RequestText(request.id, request.job));
  const std::vector<DrawRequest> read = ReadCall(in);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_NE(read[0].job.scene->vertices[1].x, read[0].job.scene->vertices[1].x);
}

TEST(Protocol, RefusesRequestsThatAreNone) {
  const std::string good = RequestText(SomeRequest().id, SomeRequest().job);
  const auto refuses = [](const std::string& text) {
    std::istringstream in(text);
    EXPECT_THROW(ReadCall(in), InputError) << text;
  };
  refuses("draw 1 2 3\n");
  refuses("paint 1 2 2 1 window 0 0\n");
  refuses("draw 1 0 2 1 window 0 0\n");
  refuses("draw 1 65537 2 1 window 0 0\n");
  refuses("draw 1 2 2 1 window 0 0 colour=red\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 3\n");
  refuses("draw 1 2 2 1 window 1 0\n1 2 x 1\n");
  refuses("draw 1 2 2 1 window 1 1\n1 2 0 1\n0 0 1\n");
  refuses(good.substr(0, good.size() / 2));
}

// The answer to request 12, a scene of 2 triangles on a target of one row.
Drawing Read(const std::string& answer, CoverageKind kind, int width) {
  Scene scene;
  scene.width = width;
  scene.triangles.resize(2);
  const DrawJob job(scene, {}, 1);
  SubjectInfo info;
  info.coverage = kind;
  std::istringstream lines(answer);
  return ReadAnswer(12, job, info, [&](std::size_t) {
    std::string line;
    std::getline(lines, line);
    return line;
  });
}

TEST(Protocol, ReadsCountsAndNothingElse) {
  const Drawing drawing = Read("counts 12\n 1 4294967295\t3\r\n", CoverageKind::kCounts, 3);
  EXPECT_EQ(drawing.counts.front, (std::vector<std::uint32_t>{1, 4294967295U, 3}));
  EXPECT_EQ(drawing.counts.back, (std::vector<std::uint32_t>{0, 0, 0}));
  for (const char* const head : {"", "counts 1", "counts 123", "count 12", "12 counts", "ids 12"}) {
    EXPECT_THROW(Read(std::string(head) + "\n1 2 3\n", CoverageKind::kCounts, 3), SubjectFault)
        << head;
  }
  for (const char* const row :
       {"1 2", "1 2 3 4", "1 x 3", "1 -2 3", "1 4294967296 3", "1 2 3x", "1 2.5 3"}) {
    EXPECT_THROW(Read("counts 12\n" + std::string(row) + "\n", CoverageKind::kCounts, 3),
                 SubjectFault)
        << row;
  }
}

TEST(Protocol, TellsRefusalsFromFaults) {
  EXPECT_THROW(Read("refused 12 too large\n", CoverageKind::kCounts, 1), InputError);
  EXPECT_THROW(Read("fault 12\n", CoverageKind::kCounts, 1), SubjectFault);
}

TEST(Protocol, ReadsWinnersOfTheSceneAndNoOthers) {
  const Drawing drawing = Read("ids 12\n0 -1 1\n", CoverageKind::kWinners, 3);
  EXPECT_EQ(drawing.winners, (std::vector<std::int32_t>{0, kNoTriangle, 1}));
  EXPECT_EQ(drawing.counts.front, (std::vector<std::uint32_t>{1, 0, 1}));
  for (const char* const row : {"0 2 1", "0 -2 1", "0 1", "0 1 1 1", "0 x 1"}) {
    EXPECT_THROW(Read("ids 12\n" + std::string(row) + "\n", CoverageKind::kWinners, 3),
                 SubjectFault)
        << row;
  }
}

TEST(Protocol, CarriesFragmentsWithoutLosingABit) {
  Drawing drawing;
  drawing.counts = CoverageCounts(3, 1);
  drawing.counts.front = {1, 0, 1};
  drawing.winners = {1, kNoTriangle, 0};
  drawing.weights = {{0.1, 1.0 / 3, -0x1p-1074}, {}, {1, 0, 0}};
  drawing.depths = {0x1.fffffffffffffp1023, 0, -2};
  const Drawing read =
      Read(AnswerText(12, drawing, CoverageKind::kFragments), CoverageKind::kFragments, 3);
  EXPECT_EQ(read.counts, drawing.counts);
  EXPECT_EQ(read.winners, drawing.winners);
  EXPECT_EQ(read.weights, drawing.weights);
  EXPECT_EQ(read.depths, drawing.depths);
  for (const char* const row : {"0 1 1 1 1 -1", "-1 -1 0 1 1 1", "-1 1 1 1 1 1 1 1 1 1"}) {
    EXPECT_THROW(Read("fragments 12\n" + std::string(row) + "\n", CoverageKind::kFragments, 3),
                 SubjectFault)
        << row;
  }
}

TEST(Protocol, TakesABatchAsOneCall) {
  const DrawRequest request = SomeRequest();
  std::istringstream in(BatchText(2) + RequestText(7, request.job) + RequestText(8, request.job) +
                        RequestText(9, request.job));
  const std::vector<DrawRequest> batch = ReadCall(in);
  ASSERT_EQ(batch.size(), 2U);
  EXPECT_EQ(batch[1].id, 8U);
  EXPECT_EQ(SceneOf(batch[1].job), SceneOf(request.job));
  EXPECT_EQ(ReadCall(in).size(), 1U);
  for (const std::string text :
       {"batch\n", "batch 0\n", "batch 70000\n", "batch x\n", "batch 1\n", "batch 1\nbatch 1\n"}) {
    std::istringstream bad(text);
    EXPECT_THROW(ReadCall(bad), InputError) << text;
  }
}

class Speaker final : public Subject {
 public:
  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions&, CoverageCounts& counts) override {
    if (scene.width == 1) throw InputError("place", "too\nsmall", "more");
    if (scene.width == 2) throw SubjectFault("it broke");
    counts.front[0] = 5;
    counts.back[1] = 6;
  }

 private:
  SubjectInfo info_;
};

TEST(Serve, AnswersRefusesAndConfesses) {
  Speaker speaker;
  std::istringstream in(
      "draw 1 1 1 1 window 0 0\ndraw 2 2 1 1 window 0 0\n\ndraw 3 3 2 1 window 0 0\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(
      said,
      "refused 1 place: too small; more\nfault 2 it broke\ncounts 3\n5 0 0\n0 0 0\n0 6 0\n0 0 "
      "0\n");
}

class Short final : public Subject {
 public:
  explicit Short(CoverageKind kind) { info_.coverage = kind; }
  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene&, const DrawOptions&, CoverageCounts&) override {}
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    return Subject::DrawMany(jobs.first(jobs.size() - 1));
  }

 private:
  SubjectInfo info_;
};

TEST(Serve, ConfessesWhatIsLeftOutOrLacksAPart) {
  const auto said_of = [](CoverageKind kind) {
    const auto subject = std::make_unique<Short>(kind);
    std::istringstream in("batch 2\ndraw 1 1 1 1 window 0 0\ndraw 2 1 1 1 window 0 0\n");
    std::string said;
    Serve(*subject, in, [&](const std::string& text) { said += text; });
    return said;
  };
  EXPECT_EQ(said_of(CoverageKind::kFacingCounts), "counts 1\n0\n0\nfault 2 it left out a scene\n");
  EXPECT_EQ(said_of(CoverageKind::kFragments).substr(0, 7), "fault 1") << "it shows none";
}

TEST(Serve, AnswersABatchUpToTheFirstFault) {
  Speaker speaker;
  std::istringstream in(
      "batch 4\ndraw 1 1 1 1 window 0 0\ndraw 2 3 1 1 window 0 0\ndraw 3 2 1 1 window 0 0\n"
      "draw 4 3 1 1 window 0 0\n");
  std::string said;
  Serve(speaker, in, [&](const std::string& text) { said += text; });
  EXPECT_EQ(said, "refused 1 place: too small; more\ncounts 2\n5 0 0\n0 6 0\nfault 3 it broke\n");
}

}  // namespace
}  // namespace rasterproof::subjects
