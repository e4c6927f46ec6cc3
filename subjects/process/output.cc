// All that a program prints.
#include <algorithm>
#include <cstddef>
#include <string_view>

#include "core/call_end.h"
#include "core/error.h"
#include "subjects/process/child.h"
#include "subjects/process/process.h"

namespace rasterproof::subjects {
namespace {

// A description, or the search for a program: no answer, and as good as nothing to do.
constexpr double kLeastSecondsOfOutput = 10;
constexpr std::size_t kMostOfOutput = std::size_t{1} << 20;

}  // namespace

std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits) {
  ChildProcess process(command, limits.bytes);
  process.SayNoMore();
  const double seconds = std::max(limits.seconds, kLeastSecondsOfOutput);
  Patience patience = process.Wait(seconds);
  std::string output;
  for (;;) {
    std::string_view line;
    const PipeEnd end = process.ReadLine(patience, kMostOfOutput - output.size(), line);
    switch (end) {
      case PipeEnd::kOpen:
        if (output.size() + line.size() >= kMostOfOutput) break;
        output += line;
        output += '\n';
        continue;
      case PipeEnd::kClosed: {
        const std::string ending = process.Ending();
        if (ending == kEndedWell) return output;
        throw InputError(place, "it " + ending, "correct the program, or give another");
      }
      case PipeEnd::kTooLong:
      case PipeEnd::kTooLarge:
        break;
      case PipeEnd::kTimedOut:
      case PipeEnd::kDeadline:
        throw InputError(
            place, "it did not end within " + SecondsText(seconds) + ": " + patience.time.Text(),
            "correct the program, or raise --time-limit");
      case PipeEnd::kInterrupted:
        throw SubjectStop(Stop::kTooSlow, kInterruptedText);
    }
    throw InputError(place, "it printed more than 1 MiB", "correct the program");
  }
}

}  // namespace rasterproof::subjects
