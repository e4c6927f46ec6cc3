// Words as a shell reads them: for the commands that are printed to be typed again.
#ifndef RASTERPROOF_TOOL_SHELL_H_
#define RASTERPROOF_TOOL_SHELL_H_

#include <string>
#include <string_view>

namespace rasterproof::tool {

/// The word as one word of a POSIX shell's: as it is, '...', or $'...' if something in it shows
/// nothing or changes what is shown beside it (control characters, marks that turn the direction of
/// text, bytes that are no UTF-8).
///
/// Domain:     no NUL, which no command line can hold.
/// Properties: a shell that reads the result gives the word back, byte for byte; the result is one
///             line and shows all that is in it.
std::string ShellWord(std::string_view word);

/// Returns the command with all its arguments, to be typed again: "rasterproof check --jobs 2".
std::string CommandLine(int argc, char** argv);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SHELL_H_
