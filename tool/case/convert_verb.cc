// rasterproof convert: its options.
#include "tool/case/case_options.h"
#include "tool/case/cmd_case.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddConvert(CLI::App* verb, const Invocation& call) {
  static ConvertOptions options;
  options.choice.typed = call.typed;
  AddCase(verb, options.choice);
  verb->add_option("--to", options.to, "Format to write")
      ->check(CLI::IsMember({"case", "fuzz-input"}))
      ->required();
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  return [] { return RunConvert(options); };
}

}  // namespace

extern constinit const Verb kConvertVerb{
    "convert", VerbGroup::kDevelopment, 10,
    "Write a fuzz input as a case file, or a case or scene as a fuzz input", AddConvert};

}  // namespace rasterproof::tool
