// Which subjects a name may mean. The command hands in what it is built with: a verb sees names and
// Subject alone.
#ifndef RASTERPROOF_TOOL_SUBJECT_KINDS_H_
#define RASTERPROOF_TOOL_SUBJECT_KINDS_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/float_mode.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "subjects/process/limits.h"

namespace rasterproof::tool {

/// How a subject outside is named:
///   plugin:PATH       a shared library with the interface of kit/rasterproof_plugin.h
///   exec:COMMAND      a program that speaks subjects/process/protocol.h, as PlainDescription says
///   PATH.subject      a program and what it states (description.h)
///   rounds:FOLDER     a program that is not at hand, asked by files (rounds/far_program.h)
inline constexpr std::string_view kPluginPrefix = "plugin:";
inline constexpr std::string_view kExecPrefix = "exec:";
inline constexpr std::string_view kRoundsPrefix = "rounds:";
inline constexpr std::string_view kDescriptionEnding = ".subject";

/// Makes a subject, as often as it is called.
using SubjectMaker = std::function<std::unique_ptr<Subject>()>;

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

/// A kind of subjects that are part of the program and always draw the same samples a pixel.
struct SubjectKind {
  bool (*has)(std::string_view name);
  std::unique_ptr<Subject> (*make)(std::string_view name);
  std::vector<std::string> (*names)();  ///< nullptr: too many to list among the others
};

/// All subjects that names may mean, but the oracle and types of the user's own.
struct SubjectKinds {
  std::vector<SubjectKind> built_in;
  /// The maker of a subject outside or of an own type; nothing if the name is of neither.
  SubjectMaker (*outside)(const std::string& name) = nullptr;
  /// The library or own type of that name, hosted in a floating-point mode.
  ///
  /// Domain:     IsOutside(name), and no program.
  std::unique_ptr<Subject> (*in_host)(const std::string& name, const FloatModeOfHost&) = nullptr;
  /// The description of a program that is not at hand, by its file or, without one, by default.
  SubjectInfo (*not_at_hand)(const std::string& file) = nullptr;
};

/// Set once, before a name is resolved: by the command, or by a test with what it needs.
SubjectKinds& Kinds();

/// The kind that has the name; nullptr if none of the built-in ones does.
const SubjectKind* BuiltInKind(std::string_view name);

/// The names of those built-in subjects that are listed.
std::vector<std::string> BuiltInNames();

/// How long and how large a subject outside may be. Set from the command line; bench sets its own.
subjects::ProcessLimits& OutsideLimits();

/// Makes a type of the user's own known by a name (kit/main.h).
void RegisterOwn(const std::string& name, SubjectMaker make);
std::vector<std::string> OwnNames();
bool IsOwn(std::string_view name);

/// One more of the type of that name; nullptr if there is none.
std::unique_ptr<Subject> MakeOwn(std::string_view name);

/// Whether the name is of a kind that says what to run or to load: a library, a program, or a file
/// that names one.
bool NamesWhatToRun(std::string_view name);

/// Whether the name is that of a subject outside: a library, a program or an own type.
bool IsOutside(std::string_view name);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SUBJECT_KINDS_H_
