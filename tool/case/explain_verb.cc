// rasterproof explain: its options.
#include <vector>

#include "tool/case/case_options.h"
#include "tool/case/cmd_case.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddExplain(CLI::App* verb, const Invocation& call) {
  static ExplainOptions options;
  options.choice.typed = call.typed;
  AddCase(verb, options.choice);
  verb->add_option_function<std::vector<int>>(
          "--pixel",
          [](const std::vector<int>& at) {
            options.x = at[0];
            options.y = at[1];
          },
          "Column and row (from the top) to show")
      ->expected(2)
      ->delimiter(',');
  verb->add_option("--svg", options.svg, "Picture as SVG");
  verb->add_option("--png", options.png, "Picture as PNG");
  verb->add_flag("--colour", options.colour, "Colours in the terminal");
  CLI::Option* const as = AddAs(verb, options.as);
  for (const char* const picture : {"--pixel", "--svg", "--png", "--colour"}) {
    as->excludes(verb->get_option(picture));
  }
  return [] { return RunExplain(options); };
}

}  // namespace

extern constinit const Verb kExplainVerb{
    "explain", VerbGroup::kEveryDay, 20,
    "Show the pixels where a case fails, with exact edge values", AddExplain};

}  // namespace rasterproof::tool
