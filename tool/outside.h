// Subjects that are not part of this program: shared libraries, other programs, types of a user.
#ifndef RASTERPROOF_TOOL_OUTSIDE_H_
#define RASTERPROOF_TOOL_OUTSIDE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/float_mode.h"
#include "core/subject.h"
#include "subjects/process/process.h"

namespace rasterproof::tool {

/// How a subject outside is named:
///   plugin:PATH       a shared library with the interface of kit/rasterproof_plugin.h
///   exec:COMMAND      a program that speaks subjects/process/protocol.h, as PlainDescription says
///   PATH.subject      a program and what it states (description.h)
inline constexpr std::string_view kPluginPrefix = "plugin:";
inline constexpr std::string_view kExecPrefix = "exec:";
inline constexpr std::string_view kDescriptionEnding = ".subject";

/// How long and how large a subject outside may be. Set once, from the command line.
subjects::ProcessLimits& OutsideLimits();

/// Makes a type of the user's own known by a name (kit/main.h).
void RegisterOwn(const std::string& name, std::function<std::unique_ptr<Subject>()> make);
std::vector<std::string> OwnNames();

/// Whether the name is of a kind that says what to run or to load: a library, a program, or a file
/// that names one.
bool NamesWhatToRun(std::string_view name);

/// Whether the name is that of a subject outside: a library, a program or an own type.
bool IsOutside(std::string_view name);

/// Makes a subject, as often as it is called.
using SubjectMaker = std::function<std::unique_ptr<Subject>()>;

/// Returns a maker of the subject of that name, each in its own process; nothing if the name is
/// none of the above. Reads the description of the library or the file once. If it does not report
/// facings, the caller works them out (props::DrawByFacing).
///
/// Error:      InputError if the library or the file is malformed.
SubjectMaker ResolveOutside(const std::string& name);

/// The description of a program that does not run here, as of one that does: what its file says,
/// or, without a file, the description assumed by default.
///
/// Returns:    named after the file, or "exec:PROGRAM".
/// Error:      InputError if the file is malformed.
SubjectInfo InfoOfProgram(const std::string& file);

/// The floating-point mode that a host sets beside what requests ask for.
struct FloatModeOfHost {
  enum class Where : std::uint8_t {
    kNowhere,
    kFromTheStart,   ///< before it loads the library, and from then on
    kInOtherThreads  ///< before each call, in all threads but the one that calls
  };
  FloatMode mode = FloatMode::kUsual;
  Where where = Where::kNowhere;
};

struct HostOptions {
  std::string subject;
  bool describe = false;
  FloatModeOfHost float_mode;
};

/// What `rasterproof pipe answer NAME` does: loads the library or makes the own type here, and
/// describes it or answers requests on standard input. What the subject itself prints goes to
/// standard error.
int HostSubject(const HostOptions& options);

/// The library or own type of that name, hosted in a floating-point mode.
///
/// Domain:     IsOutside(name), and no program.
std::unique_ptr<Subject> MakeInHost(const std::string& name, const FloatModeOfHost& float_mode);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_OUTSIDE_H_
