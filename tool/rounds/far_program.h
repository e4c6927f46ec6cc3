// The subject rounds:FOLDER: a program that is not at hand, asked in rounds of files.
#ifndef RASTERPROOF_TOOL_ROUNDS_FAR_PROGRAM_H_
#define RASTERPROOF_TOOL_ROUNDS_FAR_PROGRAM_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/subject_info.h"
#include "props/engine/pulled.h"
#include "tool/rounds/rounds.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

/// What the program states is in FOLDER/program.subject, if that is there. Each call of a verb runs
/// it on the answers of all earlier rounds, other verbs' too, and writes the next round where an
/// answer is missing.
class FarProgram {
 public:
  /// Names the subject, and how it is judged, as ResolveSubject() does.
  ///
  /// Error:      InputError if there is no such description or profile.
  FarProgram(std::string subject, const std::string& profile, props::RoundSize most,
             bool device = false, std::size_t list_length = 0);

  const SubjectInfo& Info() { return engine_.answers().Info(); }
  /// Makes subjects that draw by the answers so far. They don't outlive this.
  SubjectMaker Maker();
  template <class Work>
  const Work& Add(std::unique_ptr<Work> work) {
    return engine_.Add(std::move(work));
  }
  /// Reads the folder and goes on with the works. Once they have their results: calls `ask`, which
  /// draws what is to be told, and, when that is answered too, `tell`.
  ///
  /// Returns:    what `tell` does; kExitInconclusive, said why, while answers are missing or if one
  ///             of them changed; InterruptStatus() of a command that was interrupted.
  /// Error:      InputError, as Rounds.
  int Run(const std::function<void()>& ask, const std::function<int()>& tell);

 private:
  int GoOn(Rounds& rounds, const std::function<void()>& ask, const std::function<int()>& tell);

  std::string folder_;
  props::PulledEngine engine_;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_ROUNDS_FAR_PROGRAM_H_
