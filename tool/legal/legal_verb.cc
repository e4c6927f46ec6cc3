// rasterproof legal: its options.
#include <initializer_list>

#include "tool/legal/cmd_legal.h"
#include "tool/scene_options.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

void ExcludeAll(CLI::Option* option, std::initializer_list<CLI::Option*> others) {
  for (CLI::Option* other : others) option->excludes(other);
}

// What is judged, and by which profile.
void AddDrawing(CLI::App* verb, LegalOptions& options) {
  AddScene(verb, options.scene);
  verb->get_option("scene")->required(false);  // not with --list
  verb->add_option("image", options.image,
                   "Counts in the format of `coverage`, or a picture: PNG, PGM, PPM, or NAME.raw "
                   "with 1, 3 or 4 bytes per pixel (default: the subject draws)");
  AddSubject(verb, options.subject, "Subject that draws the scene");
  verb->add_option("--profile", options.profile,
                   "Preset or profile file (default: the subject's own)");
}

void AddPictureView(CLI::App* verb, LegalOptions& options, CLI::Option* png) {
  verb->add_option("--view", options.view, "Part of the target to show: COLUMN,ROW,WIDTH,HEIGHT")
      ->delimiter(',')
      ->expected(4)
      ->needs(png);
  verb->add_option("--scale", options.scale,
                   "Side of a pixel in the picture; 4 and more show edges, 8 and more also pixel "
                   "numbers and a legend")
      ->check(CLI::Range(1, 128))
      ->capture_default_str()
      ->needs(png);
}

Run AddLegal(CLI::App* verb, const Invocation& /*call*/) {
  static LegalOptions options;
  AddDrawing(verb, options);
  CLI::Option* background =
      verb->add_option("--background", options.background, "Background colour of a picture, RRGGBB")
          ->capture_default_str();
  CLI::Option* counts = verb->add_flag("--counts", options.counts,
                                       "Read the levels of a PGM or raw picture as counts");
  CLI::Option* ids =
      verb->add_flag("--ids", options.ids,
                     "Read the image's numbers as 1 + the visible triangle's index, 0: none")
          ->excludes(counts)
          ->excludes(background);
  verb->add_option("--visible", options.visible,
                   "Which of the triangles that cover a sample is visible: any, last or first")
      ->check(CLI::IsMember({"any", "last", "first"}))
      ->capture_default_str()
      ->needs(ids);
  CLI::Option* facings = verb->add_option("--facings", options.facings,
                                          "File like the image: how many of each count are "
                                          "front-facing; for ids 1 where the triangle is")
                             ->excludes(background);
  CLI::Option* json =
      verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  CLI::Option* save = verb->add_option(
      "--save", options.save,
      "Case file for the part that no model explains; this verb can judge it again");
  CLI::Option* decided = verb->add_flag(
      "--decided", options.decided,
      "Judge no drawing; print how often the legal models of --profile cover each sample");
  ExcludeAll(decided, {background, counts, ids, facings, save});
  CLI::Option* resolved =
      verb->add_flag("--resolved", options.resolved,
                     "Read the image as a resolved multisampled target: covered samples of each "
                     "pixel, as rows of numbers or as grey (white: all)");
  ExcludeAll(resolved, {background, counts, ids, facings, save, decided});
  CLI::Option* list = verb->add_option("--list", options.list,
                                       "File of drawings to judge one by one (docs/commands.md)");
  ExcludeAll(list, {facings, json, save, decided, resolved});
  verb->add_option("--junit", options.junit,
                   "Verdicts on the list as JUnit XML (- for standard output)")
      ->needs(list);
  CLI::Option* png = verb->add_option("--png", options.png, "Picture of where legal models differ")
                         ->needs(decided);
  verb->add_option("--mask", options.mask,
                   "Mask for comparing pictures, as PNG, NAME.pgm or an array (NAME.h, .ts, .py): "
                   "255 must be covered, 0 must not, 128 is open")
      ->needs(decided);
  verb->add_option(
          "--assume-transform-error", options.transform_error,
          "Judge clip space: before the snap, x and y may be off by N x 2^-24 of their size")
      ->check(CLI::Range(0.0, 0x1p20));
  AddPictureView(verb, options, png);
  return [] { return RunLegal(options); };
}

}  // namespace

extern constinit const Verb kLegalVerb{
    "legal", VerbGroup::kOneScene, 20,
    "Check whether one legal model explains a drawing, or show what is open", AddLegal};

}  // namespace rasterproof::tool
