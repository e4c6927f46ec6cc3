// Whether a program answers at all.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/quoted.h"
#include "core/subject_info.h"
#include "subjects/process/child.h"
#include "subjects/process/process.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kMostOfALine = std::size_t{1} << 20;
constexpr std::size_t kMostOfLastWords = 200;  // of its last words, bytes

// A file in memory that a child writes its standard error to.
class LastWords {
 public:
  LastWords() : file_(memfd_create("last words", MFD_CLOEXEC)) {}
  ~LastWords() {
    if (file_ >= 0) close(file_);
  }
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

  int file() const { return file_; }

  // Its last line; empty if it said nothing.
  std::string Text() const {
    constexpr off_t kMost = 4096;
    const off_t size = file_ < 0 ? 0 : lseek(file_, 0, SEEK_END);
    std::array<char, kMost> end{};
    const off_t begin = size > kMost ? size - kMost : 0;
    const ssize_t count = size <= 0 ? 0 : pread(file_, end.data(), end.size(), begin);
    std::string_view text(end.data(), static_cast<std::size_t>(count > 0 ? count : 0));
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    return std::string(text.substr(text.rfind('\n') + 1));
  }

 private:
  int file_;
};

DrawJob OnePlainTriangle(const SubjectInfo& info) {
  constexpr int kSide = 4;
  Scene scene;
  scene.width = kSide;
  scene.height = kSide;
  scene.precision = info.input;
  scene.clip_space = !info.takes_window;
  scene.vertices = {{0, 0}, {2, 0}, {0, 2}};
  scene.triangles = {{0, 1, 2}};
  return {std::move(scene), DrawOptions{}, info.profile.pattern.samples()};
}

}  // namespace

void RequireThatItAnswers(const std::vector<std::string>& command, const SubjectInfo& info,
                          const ProcessLimits& limits) {
  const LastWords words;
  ChildProcess child(command, limits.bytes, words.file());
  const DrawJob job = OnePlainTriangle(info);
  child.Say(RequestsText(1, {&job, 1}, info));
  Patience patience = child.Wait(limits.seconds);
  std::string_view line;
  if (child.ReadLine(patience, kMostOfALine, line) != PipeEnd::kClosed) return;
  const std::string ending = child.Ending();
  if (!ending.starts_with(kEnded)) return;
  const std::string said = words.Text();
  throw SubjectDoesNotRun(
      info.name,
      "it " + ending +
          " before its first answer, and again when it was asked for one plain triangle" +
          (said.empty() ? ", with nothing on standard error"
                        : "; its last words: " + Quoted(said, kMostOfLastWords)),
      "correct its command or its dependencies: it must read requests from standard input and "
      "answer each on standard output");
}

}  // namespace rasterproof::subjects
