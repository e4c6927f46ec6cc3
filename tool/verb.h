// A verb of the command. Its row stands in its folder (NAME_verb.cc); the build makes the list of
// the rows.
#ifndef RASTERPROOF_TOOL_VERB_H_
#define RASTERPROOF_TOOL_VERB_H_

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}  // namespace CLI

namespace rasterproof::tool {

/// The groups of --help, in its order; tool/command_line.cc has their titles.
enum class VerbGroup : std::uint8_t { kEveryDay, kOneScene, kCampaign, kDevelopment };

/// What a verb may ask of this call of the command, beside its own options.
struct Invocation {
  std::string own;    ///< the subject where none is named
  std::string typed;  ///< the command line as the user gave it, quoted for a shell
};

/// Runs the verb after its options are parsed; returns the exit status.
using Run = std::function<int()>;

struct Verb {
  std::string_view name;
  VerbGroup group;
  /// --help lists the verbs of a group by this; in tens, to leave room.
  int place;
  std::string_view summary;  ///< of --help, one sentence
  /// Adds the verb's options; what they are written to lives as long as the program.
  Run (*add)(CLI::App* verb, const Invocation& call);
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_VERB_H_
