// Which case a verb is about, and the command that names it again.
#ifndef RASTERPROOF_TOOL_CASE_CHOICE_H_
#define RASTERPROOF_TOOL_CASE_CHOICE_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace rasterproof::tool {

/// A saved case, or the name of a drawn one.
struct CaseChoice {
  std::string path;  ///< or the case itself, as JSON
  std::string subject;
  std::string property;
  std::string profile;  ///< judge by this one; empty: the file's, or the subject's own
  std::string name;     ///< of a drawn case: "near-edge:17@1"
  std::string typed;    ///< the command line as the user gave it, quoted for a shell
  /// The file is a fuzz input, as a fuzzer saves it, whatever it looks like.
  bool is_fuzz_input = false;
  std::size_t list_length = 0;  ///< 0: the subject's own
};

/// The option that names the subject on a command line, quoted for a shell: "--exec './a b'".
std::string SubjectOption(const std::string& name);

/// True of a case that is given as JSON in place of its path.
bool IsCaseText(const std::string& path);

/// The command that runs the verb on the choice's case, quoted for a shell.
std::string CommandFor(std::string_view verb, const CaseChoice& choice);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CASE_CHOICE_H_
