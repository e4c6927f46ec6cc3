// A type of somebody else's as a subject.
#include "core/rasterizer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <vector>

#include "core/drawing.h"
#include "core/subject_errors.h"

namespace rasterproof {
namespace {

// Gives so many drawings more than it is given scenes.
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
    EXPECT_TRUE(outcomes[0].BrokeDown());
    EXPECT_THROW(outcomes[0].Get(), SubjectFault);
  }
}

}  // namespace
}  // namespace rasterproof
