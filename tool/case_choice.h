// Which case a verb is about.
#ifndef RASTERPROOF_TOOL_CASE_CHOICE_H_
#define RASTERPROOF_TOOL_CASE_CHOICE_H_

#include <cstddef>
#include <string>

namespace rasterproof::tool {

/// A saved case, or the name of a drawn one.
struct CaseChoice {
  std::string path;  ///< or the case itself, as JSON
  std::string subject;
  std::string property;
  std::string profile;  ///< judge by this one; empty: the file's, or the subject's own
  std::string name;     ///< of a drawn case: "near-edge:17@1"
  std::string typed;    ///< the command line as the user gave it, quoted for a shell
  /// Read the file as a fuzz input, even if it looks like text.
  bool is_fuzz_input = false;
  std::size_t list_length = 0;  ///< 0: the subject's own
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CASE_CHOICE_H_
