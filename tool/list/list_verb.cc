// rasterproof list: its options.
#include "tool/list/cmd_list.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddList(CLI::App* verb, const Invocation& /*call*/) {
  static ListOptions options;
  verb->add_option("what", options.what, "What to list; all omits keys and clauses")
      ->check(CLI::IsMember({"subjects", "properties", "domains", "worlds", "profiles", "mutants",
                             "keys", "clauses", "all"}))
      ->capture_default_str();
  verb->add_option("prefix", options.prefix,
                   "List only clauses whose names begin so: vulkan, gl.common-edge");
  verb->add_flag("--json", options.json, "Print clauses as JSON");
  verb->add_option("--subject", options.subject, "List only properties that apply to this subject");
  return [] { return RunList(options); };
}

}  // namespace

extern constinit const Verb kListVerb{"list", VerbGroup::kEveryDay, 60,
                                      "List subjects, properties, domains, profiles and their keys",
                                      AddList};

}  // namespace rasterproof::tool
