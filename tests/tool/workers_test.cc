#include "tool/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <cstddef>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "tests/fake_subject.h"
#include "tool/progress.h"
#include "tool/typed_number.h"

namespace rasterproof::tool {
namespace {

std::vector<std::size_t> Ascending(std::size_t count) {
  return OrderOfWork(1, count, [](std::size_t) { return true; });
}

std::unique_ptr<Subject> Nothing() { return std::make_unique<FakeSubject>(SubjectInfo{}, nullptr); }

TEST(ShareWork, DoesEachPieceOnceWhateverTheNumberOfWorkers) {
  for (const int jobs : {1, 2, 7, 100}) {
    std::vector<std::atomic<int>> times(50);
    ShareWork(jobs, Ascending(times.size()), [&](std::size_t worker, std::size_t i) {
      EXPECT_LT(worker, static_cast<std::size_t>(jobs));
      ++times[i];
    });
    for (const std::atomic<int>& each : times) EXPECT_EQ(each, 1);
  }
}

TEST(ShareWork, WorksAtSeveralPiecesAtOnce) {
  constexpr int kJobs = 3;
  std::barrier all_at_work(kJobs);  // who works alone would wait for ever
  ShareWork(kJobs, Ascending(kJobs),
            [&](std::size_t, std::size_t) { all_at_work.arrive_and_wait(); });
}

TEST(ShareWork, BeginsInTheGivenOrder) {
  std::vector<std::size_t> begun;
  const std::vector<std::size_t> order{3, 0, 2, 1};
  ShareWork(1, order, [&](std::size_t, std::size_t i) { begun.push_back(i); });
  EXPECT_EQ(begun, order);
}

// Order of work differs from order of numbers: everything numbered before the failure is still
// done, and the lowest-numbered failure is rethrown.
TEST(ShareWork, ThrowsTheFirstFailureByNumberAndDoesAllThatComeBeforeIt) {
  for (const int jobs : {1, 2, 7}) {
    std::mutex mutex;
    std::set<std::size_t> done;
    const std::vector<std::size_t> order{4, 6, 7, 0, 2, 1, 3, 5};
    try {
      ShareWork(jobs, order, [&](std::size_t, std::size_t i) {
        if (i == 2 || i == 4) throw std::runtime_error(std::to_string(i));
        const std::lock_guard lock(mutex);
        done.insert(i);
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "2") << jobs;
    }
    EXPECT_TRUE(done.contains(0) && done.contains(1)) << jobs;
    // Of several, another may begin it between the throw and the note that is taken of it.
    EXPECT_TRUE(jobs > 1 || !done.contains(5));
  }
}

TEST(Progress, TakesWhatSeveralWorkersSayAtOnce) {
  ::testing::internal::CaptureStderr();
  {
    Progress progress(4);
    ShareWork(4, Ascending(40), [&](std::size_t worker, std::size_t i) {
      progress.Stage("piece " + std::to_string(i), 2, worker);
      progress.Done(1, worker);
      progress.Say("done");
    });
  }
  const std::string said = ::testing::internal::GetCapturedStderr();
  std::size_t lines = 0;
  for (std::size_t at = said.find("done\n"); at != said.npos; at = said.find("done\n", at + 1))
    ++lines;
  EXPECT_EQ(lines, 40U) << said;
}

TEST(OrderOfWork, PutsLongOnesFirstWhereSeveralWork) {
  const auto is_odd = [](std::size_t i) { return i % 2 == 1; };
  EXPECT_EQ(OrderOfWork(2, 5, is_odd), (std::vector<std::size_t>{1, 3, 0, 2, 4}));
  EXPECT_EQ(OrderOfWork(1, 5, is_odd), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Crew, GivesEachWorkerASubjectOfItsOwnAndKeepsIt) {
  int made = 0;
  Crew crew(3, [&](std::size_t) {
    ++made;
    return Nothing();
  });
  crew.Give(Nothing());
  const std::set<const Subject*> subjects{&crew.Of(0), &crew.Of(1), &crew.Of(2), &crew.Of(1)};
  EXPECT_EQ(subjects.size(), 3U);
  EXPECT_EQ(made, 2);
}

TEST(Crew, MakesTheSubjectThatIsAskedFor) {
  std::vector<std::size_t> made;
  Crew crew(1, [&](std::size_t subject) {
    made.push_back(subject);
    return Nothing();
  });
  for (const std::size_t subject : {0U, 0U, 1U, 1U, 0U}) crew.Of(0, subject);
  EXPECT_EQ(made, (std::vector<std::size_t>{0, 1, 0}));
}

TEST(ParseCount, TakesWholeNumbersOfOneToTheMost) {
  EXPECT_EQ(ParseCount("--jobs", "1", 256), 1);
  EXPECT_EQ(ParseCount("--jobs", "256", 256), 256);
  for (const char* const bad : {"0", "257", "-1", "two", "2.5", "2x", "", " 2", "99999999999999"}) {
    try {
      ParseCount("--jobs", bad, 256);
      FAIL() << bad;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("give an integer of 1 to 256"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace rasterproof::tool
