#include "tool/case_choice.h"

#include "fmt/format.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

std::string SubjectOption(const std::string& name) {
  if (name.starts_with(kPluginPrefix)) {
    return "--plugin " + ShellWord(name.substr(kPluginPrefix.size()));
  }
  if (name.starts_with(kExecPrefix)) return "--exec " + ShellWord(name.substr(kExecPrefix.size()));
  return "--subject " + ShellWord(name);
}

bool IsCaseText(const std::string& path) { return path.starts_with('{'); }

std::string CommandFor(std::string_view verb, const CaseChoice& choice) {
  std::string command = fmt::format("rasterproof {}", verb);
  const auto add = [&](std::string_view option, const std::string& value) {
    if (!value.empty()) command += fmt::format("{} {}", option, ShellWord(value));
  };
  // Prefix "./" so that a leading dash is not taken for an option.
  const bool like_option = choice.path.size() > 1 && choice.path.front() == '-';
  const bool is_text = IsCaseText(choice.path);
  if (!is_text) add("", like_option ? "./" + choice.path : choice.path);
  if (!choice.subject.empty()) command += " " + SubjectOption(choice.subject);
  add(" --property", choice.property);
  add(" --profile", choice.profile);
  add(" --case", choice.name);
  if (choice.is_fuzz_input) command += " --fuzz-input";
  if (choice.list_length != 0) {
    command += fmt::format(" --list-length {}", choice.list_length);
  }
  if (is_text) add("", choice.path);  // long, so the last
  return command;
}

}  // namespace rasterproof::tool
