// rasterproof bench: its options.
#include <string>

#include "tool/bench/cmd_bench.h"
#include "tool/typed_number.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddBench(CLI::App* verb, const Invocation& call) {
  static BenchOptions options;
  options.command = call.typed;
  verb->add_option("--family", options.families, "Families (default: all)");
  verb->add_option("--scene", options.scenes, "Scene files or meshes to add to the families");
  verb->add_option("--subject", options.subjects, "Built-in methods and kernels (default: all)");
  verb->add_option("--plugin", options.plugins, "Plugins to time too, in this process");
  verb->add_option("--exec", options.programs, "Programs to time too, on a pipe");
  verb->add_option("--target", options.target,
                   "Draw by kernels of this instruction set alone: avx2, avx512, ...");
  CLI::Option* limits = verb->add_flag("--limits", options.limits,
                                       "Find how far each method is right; measure no times");
  verb->add_option("--save", options.save, "Folder for the failing case of each limit")
      ->needs(limits);
  verb->add_flag("--values", options.values,
                 "Only measure how interpolated values err, and what they cost")
      ->excludes(limits);
  verb->add_option_function<std::string>(
          "--budget",
          [](const std::string& text) { options.budget = ParseSeconds("--budget", text); },
          "Time for the whole run, such as 90s or 10m; families have full size from 3m on")
      ->default_str("60s");
  AddSeed(verb, options.seed, "families");
  verb->add_option(
      "--against", options.against,
      "File of an earlier --json: report changes since; status 1 if anything got worse");
  verb->add_option(
      "--from", options.from,
      "File of an earlier --json: report it instead of measuring, or add --values to it");
  verb->add_flag("--growth", options.growth,
                 "Only measure times over 10^2 to 10^7 triangles, the target's side and threads")
      ->excludes(limits)
      ->excludes("--values")
      ->excludes("--from");
  verb->add_option("--json", options.json, "Result as JSON, raw times included");
  verb->add_option("--svg", options.svg, "Plot of error against run time, one panel per family");
  CLI::Option* fingerprint =
      verb->add_flag("--fingerprint", options.fingerprint,
                     "Only test one sample, with an edge's end at 256 x 256 neighbouring places")
          ->excludes(limits);
  verb->add_option("--out", options.folder, "Folder for the pictures: NAME-STEP.png")
      ->needs(fingerprint);
  verb->add_option("--width", options.width, "Of the target of meshes")->check(Positive());
  verb->add_option("--height", options.height, "Of the target of meshes")->check(Positive());
  return [] { return RunBench(options); };
}

}  // namespace

extern constinit const Verb kBenchVerb{"bench", VerbGroup::kCampaign, 30,
                                       "Measure error against run time", AddBench};

}  // namespace rasterproof::tool
