// rasterproof coverage: its options.
#include "tool/coverage/cmd_coverage.h"
#include "tool/scene_options.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddCoverage(CLI::App* verb, const Invocation& /*call*/) {
  static CoverageOptions options;
  AddScene(verb, options.scene);
  AddSubject(verb, options.subject,
             "Subject (default: exact, the oracle; of shaded pictures spans-exact)");
  verb->add_option("--profile", options.profile,
                   "Preset or profile file: the oracle's model (default: real; with --against, the "
                   "subject's own). A subject without a grid draws the scene snapped to it");
  CLI::Option* output =
      verb->add_option("-o,--output", options.output, "File for the rows")->capture_default_str();
  CLI::Option* against = verb->add_option("--against", options.against,
                                          "Subject to compare with, such as exact; prints missing "
                                          "and unexpected samples, status 1 if any");
  CLI::Option* png = verb->add_option("--png", options.png,
                                      "Picture instead of the rows, or of the difference (- for "
                                      "standard output); NAME.ppm: PPM; NAME.pgm: counts as PGM")
                         ->excludes(output);
  verb->add_option(
          "--mode", options.mode,
          "What the picture shows: coverage, or pixels shaded by a method of the reference")
      ->check(CLI::IsMember({"coverage", "flat", "barycentrics", "depth", "wireframe"}))
      ->capture_default_str()
      ->needs(png)
      ->excludes(against);
  verb->add_option("--line-width", options.line_width, "Half-width of wireframe lines in pixels")
      ->check(Positive())
      ->capture_default_str();
  return [] { return RunCoverage(options); };
}

}  // namespace

extern constinit const Verb kCoverageVerb{
    "coverage", VerbGroup::kOneScene, 10,
    "Count the triangles over each sample, or compare two subjects", AddCoverage};

}  // namespace rasterproof::tool
