// Output that is whole or absent.
#ifndef RASTERPROOF_IO_OUTPUT_H_
#define RASTERPROOF_IO_OUTPUT_H_

#include <string>
#include <string_view>

namespace rasterproof::io {

/// Whether a file or folder has that path.
bool IsThere(const std::string& path);

/// Reads a whole file ("-": standard input) or pipe. InputError names the file and the reason, for
/// example a device, or a pipe without a writer within 2 s.
std::string ReadFile(const std::string& path);

/// Writes a file so that it is either complete or unchanged: temporary file next to it, fsync,
/// rename. A path that exists and is not a regular file (/dev/full, a pipe) is written directly.
/// InputError names file and reason; no temporary file remains.
void WriteFile(const std::string& path, std::string_view content);

/// Writes to standard output and flushes; InputError if that fails (a full device). A pipe without
/// a reader is no error: the rest of the output is dropped.
void WriteStandardOutput(std::string_view content);

/// Writes to the file, or to standard output if the path is "-".
void WriteOutput(const std::string& path, std::string_view content);

/// Creates the folder and its parents; InputError if that fails.
void MakeFolder(const std::string& path);

/// Tests, without leaving a trace, whether MakeFolder can make the folder and files can be made in
/// it: for callers that write there only after long work.
///
/// Error:      InputError as MakeFolder, or that nothing may be written there.
void RequireFolderCanBe(const std::string& path);

/// Checks before long work that a file can be written there at its end. "" and "-" are no files.
///
/// Error:      InputError if its folder is not there or may not be written.
void RequireFileCanBe(const std::string& path);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_OUTPUT_H_
