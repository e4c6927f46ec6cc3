// A type of somebody else's as a subject.
#include "core/rasterizer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/result.h"

namespace rasterproof {
namespace {

// Returns `more` drawings more than it is given scenes.
template <int more>
struct Miscounts {
  Drawing Show(const DrawJob& /*job*/) { return {}; }
  std::vector<Drawing> ShowMany(std::span<const DrawJob> jobs) {
    return std::vector<Drawing>(jobs.size() + static_cast<std::size_t>(more));
  }
};

TEST(RasterizerSubject, IsAtFaultIfItDrawsMoreOrFewerScenesThanItWasGiven) {
  const std::vector<DrawJob> jobs(3);
  RasterizerSubject<Miscounts<0>> right("right");
  EXPECT_EQ(right.DrawMany(jobs).size(), 3U);
  RasterizerSubject<Miscounts<-1>> fewer("fewer");
  RasterizerSubject<Miscounts<+2>> more("more");
  for (Subject* const subject : {static_cast<Subject*>(&fewer), static_cast<Subject*>(&more)}) {
    const std::vector<DrawOutcome> outcomes = subject->DrawMany(jobs);
    ASSERT_EQ(outcomes.size(), 1U) << "fewer, and the last one holds the fault";
    EXPECT_EQ(outcomes[0].end.stop, Stop::kBrokeDown);
  }
}

struct Throws {
  Drawing Show(const DrawJob& /*job*/) { throw 7; }
  std::vector<Drawing> ShowMany(std::span<const DrawJob> /*jobs*/) {
    throw std::logic_error("negative column");
  }
};

TEST(RasterizerSubject, ThatThrowsGivesAnEnd) {
  RasterizerSubject<Throws> subject("throws");
  const std::vector<DrawJob> jobs(3);
  const CallEnd batch = subject.DrawMany(jobs).front().end;
  EXPECT_EQ(batch.stop, Stop::kBrokeDown);
  EXPECT_EQ(batch.why, "it threw: negative column");
  EXPECT_EQ(subject.DrawMany({jobs.data(), 1}).front().end.stop, Stop::kBrokeDown);
  EXPECT_THROW(DrawOne(subject, jobs.front()), SubjectStop);
}

// Each covers the one pixel once.
struct DrawsAlone {
  void Draw(const Scene& /*scene*/, CoverageCounts& counts) { ++counts.front[0]; }
};
struct ShowsAlone {
  Drawing Show(const DrawJob& /*job*/) {
    Drawing drawing;
    drawing.counts = CoverageCounts(1, 1);
    drawing.counts.front[0] = 1;
    return drawing;
  }
};

TEST(RasterizerSubject, AddsToWhatItsTargetHolds) {
  RasterizerSubject<DrawsAlone> draws("draws");
  RasterizerSubject<ShowsAlone> shows("shows");
  DrawJob job;
  job.scene = std::make_shared<const Scene>([] {
    Scene scene;
    scene.width = scene.height = 1;
    return scene;
  }());
  for (Subject* const subject : {static_cast<Subject*>(&draws), static_cast<Subject*>(&shows)}) {
    CoverageCounts counts(1, 1);
    counts.back[0] = 3;
    job.onto = std::make_shared<const CoverageCounts>(counts);
    EXPECT_EQ(DrawOne(*subject, job).counts.back[0], 3U);
    DrawOnto(*subject, *job.scene, {}, counts);
    EXPECT_EQ(counts.front[0], 1U);
    job.onto = nullptr;
    EXPECT_EQ(DrawOne(*subject, job).counts.back[0], 0U);
  }
}

TEST(PropertyResult, OfTwoRunsAddUpToThatOfOne) {
  Verdict wrong = Verdict::Violated(5, "", {});
  wrong.not_judged = 2;
  PropertyResult both;
  PropertyResult first;
  PropertyResult second;
  for (const Verdict& verdict : {Verdict::Held(3, 0.5), Verdict::Refused("odd")}) {
    first.AddCase(verdict);
    both.AddCase(verdict);
  }
  for (const Verdict& verdict : {Verdict::Held(0), wrong}) {
    second.AddCase(verdict);
    both.AddCase(verdict);
  }
  second.end = End::kFailed;
  second.counterexample.emplace().message = "the first";
  second.seconds = 1;
  first += second;
  for (const PropertyResult& result : {first, both}) {
    EXPECT_EQ(result.cases, 4U);
    EXPECT_EQ(result.cases_exercised, 2U);
    EXPECT_EQ(result.exercised, 8U);
    EXPECT_EQ(result.cases_refused, 1U);
    EXPECT_EQ(result.not_judged, 2U);
    EXPECT_EQ(result.worst_ratio, 0.5);
  }
  first += second;  // nothing counts after a failure
  EXPECT_EQ(first.cases, 4U);
  EXPECT_EQ(first.seconds, 2);
  EXPECT_EQ(first.counterexample->message, "the first");
}

}  // namespace
}  // namespace rasterproof
