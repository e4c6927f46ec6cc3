// Questions are put in as few calls as may be, and what breaks down ends its own case.
#include "props/run/submit.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
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

// Refuses a scene of `refuses` vertices, and covers every sample of the others.
FakeSubject Refusing(std::size_t refuses) {
  return {testing::RealInfo(), [=](const Scene& scene, const DrawOptions&, CoverageCounts& counts) {
            if (scene.vertices.size() == refuses) throw SubjectStop(Stop::kRefused, "it is odd");
            for (std::uint32_t& count : counts.front) ++count;
          }};
}

Answers AskedInOrder(Subject& subject, std::vector<std::size_t> may_be_refused) {
  Check check;
  check.questions.company = Company::kInOrderAlone;
  for (const Case& c : {Blank(8, 8, 3), Blank(8, 8, 4), Blank(8, 8, 3)}) {
    check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, c.options));
  }
  check.may_be_refused = std::move(may_be_refused);
  const PlacedCase placed = Place(Blank(8, 8, 3), false);
  const std::vector<std::shared_ptr<const Drawing>> drawn;
  const Request request{&placed, &check, &drawn};
  return Submit(subject, {&request, 1}).front();
}

TEST(Questions, BehindOneThatMayBeRefusedArePut) {
  FakeSubject subject = Refusing(4);
  EXPECT_EQ(AskedInOrder(subject, {}).end.stop, Stop::kRefused);
  const Answers answers = AskedInOrder(subject, {1});
  EXPECT_EQ(answers.end.stop, Stop::kNone);
  ASSERT_EQ(answers.draws.size(), 3U);
  EXPECT_EQ(answers.draws[0]->counts.Count(0), 1U);
  EXPECT_EQ(answers.draws[1]->counts.size(), 0U);
  EXPECT_EQ(answers.draws[2]->counts.Count(0), 1U);
}

TEST(Questions, ThatMayBeRefusedMayNotBreakTheSubjectDown) {
  const std::size_t breaks_over = 4;
  FakeSubject subject = Empty(breaks_over);
  EXPECT_EQ(AskedInOrder(subject, {1}).end.stop, Stop::kBrokeDown);
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
