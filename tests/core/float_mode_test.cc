// Another floating-point mode for a while, and what is noticed of code that ran in it.
#include "core/float_mode.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <span>
#include <string_view>
#include <vector>

#include "core/drawing.h"
#include "core/rasterizer.h"
#include "core/subject.h"

namespace rasterproof {
namespace {

float Opaque(float x) {
  const volatile float v = x;
  return v;
}

struct Seen {
  bool up = false;          // 1 + 2^-40 is more than 1
  bool down = false;        // -1 - 2^-40 is less than -1, and 1 + 2^-40 is 1
  bool flushes = false;     // a subnormal result is 0
  bool takes_zero = false;  // a subnormal operand is 0
};

Seen In(FloatMode mode) {
  const WithinFloatMode within(mode);
  const float up = Opaque(1) + Opaque(0x1p-40F);
  const float down = Opaque(-1) - Opaque(0x1p-40F);
  return {up > 1, down < -1, Opaque(0x1p-126F) * Opaque(0.5F) == 0,
          Opaque(0x1p-149F) * Opaque(0x1p60F) == 0};
}

TEST(FloatMode, IsThatOfItsNameAndThenTheCallersAgain) {
  EXPECT_TRUE(In(FloatMode::kUpward).up);
  EXPECT_FALSE(In(FloatMode::kUpward).down);
  EXPECT_TRUE(In(FloatMode::kDownward).down);
  EXPECT_FALSE(In(FloatMode::kTowardZero).up || In(FloatMode::kTowardZero).down);
  for (const FloatMode mode : {FloatMode::kFlushToZero, FloatMode::kDenormalsAreZero}) {
    if (!HasFloatMode(mode)) continue;
    EXPECT_TRUE(In(mode).flushes || In(mode).takes_zero) << FloatModeName(mode);
  }
  const Seen usual = In(FloatMode::kUsual);
  EXPECT_FALSE(usual.up || usual.down || usual.flushes || usual.takes_zero);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(FloatMode, EveryNameIsFound) {
  for (const std::string_view name : kFloatModeNames) {
    ASSERT_TRUE(FindFloatMode(name)) << name;
    EXPECT_EQ(FloatModeName(*FindFloatMode(name)), name);
  }
  EXPECT_FALSE(FindFloatMode("nearest"));
}

// Draws nothing, and does what it is given.
class Doing final : public Subject {
 public:
  explicit Doing(void (*what)()) : what_(what) {}
  const SubjectInfo& OwnInfo() const override { return info_; }

 protected:
  void Draw(const Scene&, const DrawOptions&, CoverageCounts&) override { what_(); }

 private:
  void (*what_)();
  SubjectInfo info_;
};

CallEnd EndIn(FloatMode mode, void (*what)()) {
  Doing subject(what);
  Scene scene;
  scene.width = scene.height = 1;
  DrawOptions options;
  options.float_mode = mode;
  const DrawJob job(scene, options, 1);
  return subject.DrawMany({&job, 1}).front().end;
}

TEST(FloatMode, ASubjectThatLeavesAnotherModeBreaksDown) {
  const auto leaves = [] { std::fesetround(FE_TOWARDZERO); };
  EXPECT_EQ(EndIn(FloatMode::kUpward, leaves).stop, Stop::kBrokeDown);
  EXPECT_NE(EndIn(FloatMode::kUpward, leaves).why.find("did not restore"), std::string::npos);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "it is restored for it";
  // One that restores what it changed, and one that leaves the mode that it was given.
  EXPECT_EQ(EndIn(FloatMode::kUpward,
                  [] {
                    std::fesetround(FE_TONEAREST);
                    std::fesetround(FE_UPWARD);
                  })
                .stop,
            Stop::kNone);
  EXPECT_EQ(EndIn(FloatMode::kTowardZero, leaves).stop, Stop::kNone);
}

// glibc's fegetround reads the x87 control word, so that code for MXCSR is noticed there alone.
TEST(FloatMode, AModeThatIsSetInTheControlRegisterAloneIsNoticed) {
  if (FloatEnvironment::kMode == 0) GTEST_SKIP() << "this processor's register is not reached";
  for (const FloatMode left : {FloatMode::kFlushToZero, FloatMode::kDenormalsAreZero,
                               FloatMode::kUpward, FloatMode::kDownward, FloatMode::kTowardZero}) {
    if (!HasFloatMode(left)) continue;
    const WithinFloatMode within(FloatMode::kTrapping);
    EXPECT_EQ(within.Complaint(), "") << FloatModeName(left);
    FloatEnvironment::Set(FloatEnvironment::Current() | ControlBits(left));
    EXPECT_NE(within.Complaint().find("did not restore"), std::string::npos) << FloatModeName(left);
  }
}

TEST(FloatMode, WhatIsTrappedIsNamedAndWhatIsNotIsNoMatter) {
  const auto divides = [] {
    const volatile float inverse = 1 / Opaque(0);
    (void)inverse;
  };
  const auto underflows = [] {
    const volatile float tiny = Opaque(0x1p-126F) * Opaque(0x1.8p-20F);
    (void)tiny;
  };
  EXPECT_NE(EndIn(FloatMode::kTrapping, divides).why.find("a division by zero"), std::string::npos);
  EXPECT_EQ(EndIn(FloatMode::kTrapping, underflows).stop, Stop::kNone);
  EXPECT_EQ(EndIn(FloatMode::kUpward, divides).stop, Stop::kNone);
  EXPECT_EQ(EndIn(FloatMode::kUsual, divides).stop, Stop::kNone);
}

// Says of each scene whether it is drawn upward, by one count.
struct RoundsUp {
  Drawing Show(const DrawJob& /*job*/) {
    Drawing drawing;
    drawing.counts = CoverageCounts(1, 1);
    drawing.counts.front[0] = std::fegetround() == FE_UPWARD ? 1 : 0;
    return drawing;
  }
  std::vector<Drawing> ShowMany(std::span<const DrawJob> jobs) {
    return std::vector<Drawing>(jobs.size(), Show(jobs.front()));
  }
};

TEST(FloatMode, IsEachJobsOwnInABatch) {
  std::vector<DrawJob> jobs(3);
  jobs[0].options.float_mode = FloatMode::kUpward;
  jobs[2].options.float_mode = FloatMode::kDownward;
  RasterizerSubject<RoundsUp> subject("rounds up");
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].drawing.counts.front[0], 1U);
  EXPECT_EQ(outcomes[1].drawing.counts.front[0], 0U);
  EXPECT_EQ(outcomes[2].drawing.counts.front[0], 0U);
}

}  // namespace
}  // namespace rasterproof
