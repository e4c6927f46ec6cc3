// Draws that take longer than they may, and processes that end: what that says of the program.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "subjects/process/conversation.h"
#include "subjects/process/process.h"

namespace rasterproof::subjects {
namespace {

// How many times the limit a draw gets that is to show whether it hangs.
constexpr double kHangFactor = 10;
constexpr const char* kNotAgain = "it answered: it did not happen again";

std::string GibibytesText(std::uint64_t bytes) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.3g GiB", static_cast<double>(bytes) / 0x1p30);
  return digits.data();
}

// A file that keeps nothing; -1, for that of all programs, if there is none.
class NoFile {
 public:
  NoFile() : file_(open("/dev/null", O_WRONLY | O_CLOEXEC)) {}
  ~NoFile() {
    if (file_ >= 0) close(file_);
  }
  NoFile(const NoFile&) = delete;
  NoFile& operator=(const NoFile&) = delete;
  int file() const { return file_; }

 private:
  int file_;
};

}  // namespace

// What an answer is waited for: to see whether it hangs, if that is not known and there is time.
ProcessSubject::Wait ProcessSubject::LongestWait() const {
  const auto longer = std::chrono::duration<double>(kHangFactor * limits_.seconds);
  const bool is_long = !hangs_ && waits_left_ > 0 && deadline_ - Clock::now() >= longer;
  return {limits_.seconds, is_long ? longer.count() : limits_.seconds};
}

DrawOutcome ProcessSubject::AskAlone(const DrawJob& job) {
  const Wait wait = LongestWait();
  Call call = Ask({&job, 1}, wait);
  return call.slow ? AskAgain(job, *call.slow, wait) : std::move(call.outcomes.front());
}

DrawOutcome ProcessSubject::AskAgain(const DrawJob& job, const OutOfTime& slow, const Wait& wait) {
  DrawOutcome outcome;
  CallEnd end = EndOf([&] {
    TryAgain(slow, wait, [&](const Wait& again) {
      Call call = Ask({&job, 1}, again);
      if (call.slow) throw OutOfTime(*call.slow);
      outcome = std::move(call.outcomes.front());
      if (EndsTheCall(outcome.end.stop)) throw SubjectStop(outcome.end);
    });
  });
  if (end.stop != Stop::kNone) outcome.end = std::move(end);
  return outcome;
}

// Repeats what took too long, alone on a fresh process. Where it answered late it hangs now, or its
// time is known; or it was slow only once, and the answer counts. Where it gave no answer in ten
// times its limit that is told, whatever comes now.
void ProcessSubject::TryAgain(const OutOfTime& slow, const Wait& wait,
                              const std::function<void(const Wait&)>& ask) {
  const std::string limit = SecondsText(limits_.seconds);
  const std::string said = slow.what();
  if (hangs_) {
    throw SubjectStop(Stop::kHung, "it hangs: " + said + ", as before with 10 times as much");
  }
  const std::string advice = said + "; raise --time-limit (now " + limit + ") if it needs more";
  if (slow.WasStarved() || !wait.IsLong()) throw SubjectStop(Stop::kTooSlow, advice);
  --waits_left_;
  child_.reset();
  const std::string hangs_alone = "it hangs: alone, on a fresh process, ";
  const std::string ten_times = ", 10 times its limit of " + limit;
  if (slow.GaveAnswer()) {
    try {
      return ask({limits_.seconds, kHangFactor * limits_.seconds});
    } catch (const OutOfTime& again) {
      if (again.GaveAnswer()) {
        throw SubjectStop(Stop::kTooSlow,
                          std::string("alone, on a fresh process, ") + again.what() +
                              "; give a --time-limit above that (now " + limit + ")");
      }
      if (again.WasStarved()) throw SubjectStop(Stop::kTooSlow, advice);
      hangs_ = true;
      throw SubjectStop(Stop::kHung, hangs_alone + again.what() + ten_times);
    }
  }
  std::string then = kNotAgain;
  try {
    ask({limits_.seconds, limits_.seconds});
  } catch (const OutOfTime& again) {
    hangs_ = !again.WasStarved();
    throw SubjectStop(Stop::kHung,
                      hangs_alone + again.what() + "; before that " + said + ten_times);
  } catch (const SubjectStop& other) {
    then = other.what();
  }
  throw SubjectStop(Stop::kHung, "it hangs: " + said + ten_times +
                                     "; asked again alone, on a fresh process, " + then);
}

// A batch without an answer. Parts of it are asked for, down to single draws: they hang, or all are
// answered, and what the batch took is compared with what they take.
std::vector<DrawOutcome> ProcessSubject::AskInParts(std::span<const DrawJob> jobs, Call silent,
                                                    const Wait& wait) {
  if (wait.IsLong()) --waits_left_;
  std::vector<DrawOutcome> outcomes = std::move(silent.outcomes);
  outcomes.pop_back();
  const std::size_t first = outcomes.size();
  const bool is_outermost = !std::exchange(is_in_parts_, true);
  const double before = answered_seconds_;
  while (outcomes.size() < jobs.size()) {
    const std::size_t open = jobs.size() - outcomes.size();
    std::ranges::move(AskSome(jobs.subspan(outcomes.size(), std::min(open, most_in_a_batch_))),
                      std::back_inserter(outcomes));
    if (EndsTheCall(outcomes.back().end.stop)) break;
  }
  if (!is_outermost) return outcomes;
  is_in_parts_ = false;
  if (EndsTheCall(outcomes.back().end.stop)) return outcomes;
  CallEnd end = EndOfSilence(*silent.slow, wait, answered_seconds_ - before, jobs.size() - first);
  if (end.stop != Stop::kNone) {
    outcomes.resize(first + 1);
    outcomes.back().end = std::move(end);
  }
  return outcomes;
}

// Many requests at once got no answer; in parts, on fresh processes, they took so many seconds.
// They were slow as a whole and nothing more, unless what was waited in vain is ten times that.
CallEnd ProcessSubject::EndOfSilence(const OutOfTime& slow, const Wait& wait, double in_parts,
                                     std::size_t requests) const {
  if (slow.WasStarved() || hangs_ || kHangFactor * in_parts > wait.most) return {};
  const std::string limit = SecondsText(limits_.seconds);
  const std::string said = "asked " + std::to_string(requests) + " requests at once, " +
                           slow.what() + (wait.IsLong() ? ", 10 times its limit of " + limit : "") +
                           "; asked again in parts, on fresh processes, " + kNotAgain;
  if (wait.IsLong()) return {Stop::kHung, "it hangs: " + said};
  return {Stop::kTooSlow, said + "; raise --time-limit (now " + limit + ") if it needs more"};
}

// The process ended, or said that it was out of memory. A fresh one, whose address space has no
// limit but which is ended once it holds as much memory, is asked the same, after the same calls.
// If it takes more than the limit, the limit ended the first one and no fault did; if it gives no
// answer in its time, nobody knows. Where the calls before are not known, what the first one had
// taken by then is added.
void ProcessSubject::BlameMemory(std::span<const DrawJob> jobs, Call& call) {
  const NoFile nothing;
  if (!info_.takes_batches) jobs = jobs.first(call.outcomes.size());
  constexpr double kPatience = 4;
  const double most = kPatience * limits_.seconds;
  bool is_memory = false;
  bool is_slow = false;
  const CallEnd asked = EndOf([&] {
    child_ = std::make_unique<Child>(command_, limits_.bytes, nothing.file());
    std::vector<std::vector<DrawJob>> calls = std::move(call.before);
    const std::uint64_t before = calls.empty() ? call.bytes_before : 0;
    calls.emplace_back(jobs.begin(), jobs.end());
    for (std::size_t k = 0; k < calls.size() && child_ != nullptr; ++k) {
      const Call again = AskOnce(calls[k], {most, most});
      is_memory = is_memory || again.is_too_large;
      is_slow = again.slow.has_value();
    }
    if (is_memory || child_ == nullptr) return;
    is_memory = child_->MostBytes() + before > limits_.bytes;
  });
  child_.reset();
  if (asked.stop != Stop::kNone || !(is_memory || is_slow)) return;
  CallEnd& end = call.outcomes.back().end;
  const std::string without =
      is_memory ? "takes more: raise the limit, or give 0 for none"
                : "gave no answer in " + SecondsText(most) + ": raise --time-limit as well";
  end = {Stop::kOutOfMemory, end.why + ", under --memory-limit (now " +
                                 GibibytesText(limits_.bytes) + "); without it it " + without};
}

}  // namespace rasterproof::subjects
