// Questions are put in as few calls as may be, and what breaks down ends its own case.
#include "props/run/submit.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "props/judging/redraw.h"
#include "props/run/judge.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

// As many samples as a call holds: beside such a draw there is room for no other.
constexpr int kSide = 1024;

// Draws nothing, and breaks down over a scene of `breaks_over` vertices.
FakeSubject Empty(const std::size_t& breaks_over) {
  return {testing::RealInfo(), [&](const Scene& scene, const DrawOptions&, CoverageCounts&) {
            if (scene.vertices.size() == breaks_over) BreakDown("it crashed");
          }};
}

Case Blank(int width, int height, std::size_t vertices) {
  Case c;
  c.profile = testing::RealInfo().profile;
  c.scene.width = width;
  c.scene.height = height;
  c.scene.vertices.resize(vertices);
  return c;
}

// Some checks of a case, and the requests that put them.
class Requests {
 public:
  Requests() : placed_(Place(Blank(8, 8, 3), false)) {}
  void Add(const std::vector<Case>& draws) {
    Check& check = *checks_.emplace_back(std::make_unique<Check>());
    for (const Case& c : draws) {
      check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, c.options));
    }
    requests_.push_back({&placed_, &check, &drawn_});
  }
  std::vector<Answers> SubmitTo(Subject& subject) const { return Submit(subject, requests_); }

 private:
  PlacedCase placed_;
  std::vector<std::shared_ptr<const Drawing>> drawn_;
  std::vector<std::unique_ptr<Check>> checks_;
  std::vector<Request> requests_;
};

TEST(Questions, ThatCantBePutHideNoCrashOfTheirBase) {
  std::size_t breaks_over = 0;
  FakeSubject subject = Empty(breaks_over);
  Requests requests;
  requests.Add({Blank(8, 8, 3), Blank(kMaxTargetSide, kMaxTargetSide, 3)});
  EXPECT_EQ(requests.SubmitTo(subject)[0].end.stop, Stop::kNotDrawable);
  breaks_over = 3;
  const Answers crashed = requests.SubmitTo(subject)[0];
  EXPECT_EQ(crashed.end.stop, Stop::kBrokeDown);
  EXPECT_EQ(crashed.end.why, "it crashed");
  EXPECT_TRUE(crashed.draws.empty());
}

TEST(Questions, BehindABreakdownAtTheEndOfACallAreNotPut) {
  std::size_t breaks_over = 0;
  FakeSubject subject = Empty(breaks_over);
  Requests requests;
  for (const std::size_t vertices : {3U, 4U, 5U}) {
    requests.Add({Blank(8, 8, 1), Blank(8, 8, vertices), Blank(kSide, kSide, 2)});
  }
  EXPECT_EQ(requests.SubmitTo(subject).size(), 3U);
  const std::vector<std::size_t> by_size{2, 1, 2, 1, 2, 1};
  EXPECT_EQ(subject.calls, by_size);
  subject.calls.clear();
  breaks_over = 4;  // the last job of the third call
  const std::vector<Answers> answers = requests.SubmitTo(subject);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].end.stop, Stop::kNone);
  EXPECT_EQ(answers[0].draws.size(), 3U);
  EXPECT_EQ(answers[1].end.stop, Stop::kBrokeDown);
  EXPECT_EQ(subject.calls, (std::vector<std::size_t>{2, 1, 2}));
}

}  // namespace
}  // namespace rasterproof::props
