#include "tool/case/case_options.h"

#include <string>
#include <vector>

#include "report/case_code.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {

void AddCase(CLI::App* app, CaseChoice& choice) {
  app->add_option("case", choice.path,
                  "Case file, scene file, inline JSON or fuzz input (- for standard input)");
  AddSubject(app, choice.subject, "Subject (default: the file's)");
  app->add_option("--property", choice.property, "Property (default: the file's)");
  app->add_option("--profile", choice.profile,
                  "Judge by this profile (default: the file's, or the subject's own)");
  app->add_option("--case", choice.name, std::string(kCaseHelp));
  app->add_flag("--fuzz-input", choice.is_fuzz_input,
                "Read the file as a fuzz input even if it looks like text");
  AddListLength(app, choice.list_length);
}

CLI::Option* AddAs(CLI::App* verb, std::string& as) {
  const std::vector<std::string> languages(report::kCodeLanguages.begin(),
                                           report::kCodeLanguages.end());
  return verb->add_option("--as", as, "Print the case as code for a test, below the verdict")
      ->check(CLI::IsMember(languages));
}

}  // namespace rasterproof::tool
