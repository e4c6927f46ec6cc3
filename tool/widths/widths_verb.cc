// rasterproof widths: its options.
#include "core/scene.h"
#include "tool/verb_options.h"
#include "tool/widths/cmd_widths.h"

namespace rasterproof::tool {
namespace {

Run AddWidths(CLI::App* verb, const Invocation& /*call*/) {
  static WidthsOptions options;
  verb->add_option("--fixed", options.fixed,
                   "Bits of a coordinate before and after the point: 12.4; with --signed the first "
                   "is the sign")
      ->required();
  verb->add_flag("--signed,!--unsigned", options.is_signed, "Coordinates have a sign (default)");
  verb->add_option("--target", options.target, "Width and height of the largest target: 4096x4096")
      ->required();
  verb->add_option("--samples", options.samples,
                   "Sample locations: standard-1, -2, -4, -8, -16, or a list as in the profile key "
                   "sample_locations: '[[0, 0], [0.5, 0.5]]'")
      ->capture_default_str();
  verb->add_option("--tile", options.tile, "Side of a tile in pixels; also the larger step")
      ->check(CLI::Range(1, kMaxTargetSide))
      ->capture_default_str();
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save,
                   "Folder for one case per value: the input that needs its last bit");
  return [] { return RunWidths(options); };
}

}  // namespace

extern constinit const Verb kWidthsVerb{
    "widths", VerbGroup::kDevelopment, 30,
    "Fewest bits for every value of an integer edge function, with inputs that need them",
    AddWidths};

}  // namespace rasterproof::tool
