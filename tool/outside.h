// Makes subjects that are not part of this program: shared libraries, other programs, types of a
// user. Their names are told apart by tool/subject_kinds.h.
#ifndef RASTERPROOF_TOOL_OUTSIDE_H_
#define RASTERPROOF_TOOL_OUTSIDE_H_

#include <memory>
#include <string>

#include "core/subject.h"
#include "core/subject_info.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

/// Returns a maker of the subject of that name, each in its own process; nothing unless
/// IsOutside(name). The library or the file is asked here, once, what it is. If it does not report
/// facings, the caller works them out (props::DrawByFacing).
///
/// Error:      InputError if the library or the file is not what it should be.
SubjectMaker ResolveOutside(const std::string& name);

/// The description of a program that does not run here, as of one that does: what its file says,
/// or, without a file, what is assumed of a program that says nothing.
///
/// Returns:    named after the file, or "exec:PROGRAM".
/// Error:      InputError if the file is not what it should be.
SubjectInfo InfoOfProgram(const std::string& file);

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
