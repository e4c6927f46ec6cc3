#include "core/subject.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/subject_info.h"

namespace rasterproof {
namespace {

// Refuses wide targets by value, and counts what it draws.
class Narrow final : public Subject {
 public:
  const SubjectInfo& OwnInfo() const override { return info_; }
  int drawn() const { return drawn_; }

 protected:
  std::optional<InputError> WhyNotDrawn(const DrawJob& job) const override {
    if (job.scene->width == 1) return std::nullopt;
    return InputError("width", "is not 1", "give 1");
  }
  Drawing Show(const DrawJob& job) override {
    ++drawn_;
    return Subject::Show(job);
  }
  void Draw(const Scene&, const DrawOptions&, CoverageCounts&) override {}

 private:
  SubjectInfo info_;
  int drawn_ = 0;
};

DrawJob JobOf(int width) {
  Scene scene;
  scene.width = width;
  scene.height = 1;
  return {scene, {}, 1};
}

TEST(Subject, WhatItRefusesByValueIsNotDrawnAndTheRestIs) {
  Narrow subject;
  const std::array jobs{JobOf(1), JobOf(2), JobOf(1)};
  const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].end.stop, Stop::kNone);
  EXPECT_EQ(outcomes[1].end.stop, Stop::kNotDrawable);
  EXPECT_NE(outcomes[1].end.why.find("is not 1"), std::string::npos);
  EXPECT_EQ(outcomes[2].end.stop, Stop::kNone);
  EXPECT_EQ(subject.drawn(), 2);
}

}  // namespace
}  // namespace rasterproof
