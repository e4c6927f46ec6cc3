#include "subjects/process/process.h"

#include <cstddef>
#include <utility>

#include "core/error.h"
#include "subjects/process/child.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

ChildProcess::Clock::time_point After(double seconds) {
  return ChildProcess::Clock::now() + std::chrono::duration_cast<ChildProcess::Clock::duration>(
                                          std::chrono::duration<double>(seconds));
}

std::string SecondsText(double seconds) {
  std::string text = std::to_string(seconds);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

}  // namespace

// The running child, and reading its answers.
class ProcessSubject::Child {
 public:
  Child(const std::vector<std::string>& command, const ProcessLimits& limits)
      : process_(command, limits.bytes), limits_(limits) {}

  void Ask(std::string request) { process_.Say(std::move(request)); }

  std::string Line(ChildProcess::Clock::time_point deadline) {
    std::string line;
    switch (process_.ReadLine(deadline, limits_.answer_bytes, line)) {
      case PipeEnd::kOpen:
        return line;
      case PipeEnd::kTimedOut:
        throw SubjectFault("it gave no answer within " + SecondsText(limits_.seconds));
      case PipeEnd::kClosed:
        break;
    }
    throw SubjectFault("it " + process_.Ending() + " before its answer was whole");
  }

 private:
  ChildProcess process_;
  ProcessLimits limits_;
};

ProcessSubject::ProcessSubject(std::vector<std::string> command, SubjectInfo info,
                               ProcessLimits limits)
    : command_(std::move(command)), info_(std::move(info)), limits_(limits) {}

ProcessSubject::~ProcessSubject() = default;

const SubjectInfo& ProcessSubject::Info() const { return info_; }

void ProcessSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  if (child_ == nullptr) child_ = std::make_unique<Child>(command_, limits_);
  // Whatever goes wrong, the next draw starts a fresh child.
  std::unique_ptr<Child> child = std::move(child_);
  const std::uint64_t id = next_id_++;
  DrawOptions taken = options;
  if (!info_.takes_tiles) taken.tile = 0;
  if (!info_.takes_threads) taken.threads = 1;
  child->Ask(RequestText({id, scene, counts.samples, taken}));
  const auto deadline = After(limits_.seconds);
  const AnswerHead head = ParseAnswerHead(child->Line(deadline), id);
  if (head.kind == AnswerKind::kFault) throw SubjectFault(head.reason);
  if (head.kind == AnswerKind::kRefused) {
    child_ = std::move(child);
    throw InputError("subject " + info_.name, "it refused the scene: " + head.reason,
                     "give it another one");
  }
  CoverageCounts answer(counts.width, counts.height, counts.samples);
  const auto row =
      static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
  const auto read = [&](std::vector<std::uint32_t>& side) {
    for (std::size_t at = 0; at < side.size(); at += row) {
      ParseCountsRow(child->Line(deadline), row, side.data() + at);
    }
  };
  read(answer.front);
  if (info_.coverage == CoverageKind::kFacingCounts) read(answer.back);
  for (std::size_t k = 0; k < answer.size(); ++k) {
    counts.front[k] += answer.front[k];
    counts.back[k] += answer.back[k];
  }
  child_ = std::move(child);
}

std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits) {
  ChildProcess process(command, limits.bytes);
  process.SayNoMore();
  const auto deadline = After(limits.seconds);
  std::string output;
  for (;;) {
    std::string line;
    const PipeEnd end = process.ReadLine(deadline, limits.answer_bytes, line);
    if (end == PipeEnd::kOpen) {
      output += line + '\n';
      continue;
    }
    if (end == PipeEnd::kTimedOut) {
      throw InputError(place, "it did not end within " + SecondsText(limits.seconds),
                       "mend the program");
    }
    const std::string ending = process.Ending();
    if (ending == "ended with status 0") return output;
    throw InputError(place, "it " + ending, "mend the program, or give another");
  }
}

}  // namespace rasterproof::subjects
