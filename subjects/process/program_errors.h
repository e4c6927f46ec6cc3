// What programs under test write to standard error: told apart from this program's words.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROGRAM_ERRORS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROGRAM_ERRORS_H_

namespace rasterproof::subjects {

/// The file for the standard error of programs under test. From its first use until this process
/// ends, each line that is written there goes to standard error after "program: "; after 20 lines
/// the rest is counted, and the count is told at the end.
///
/// Returns:    -1 if there is no pipe to be had: the program then shares this one's standard error.
int ProgramErrors();

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROGRAM_ERRORS_H_
