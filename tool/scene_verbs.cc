// Options that verbs share, those of the verbs that take one scene, and of pipe.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/scene.h"
#include "tool/coverage/cmd_coverage.h"
#include "tool/legal/cmd_legal.h"
#include "tool/outside.h"
#include "tool/plan/cmd_plan.h"
#include "tool/scene_source.h"
#include "tool/subject_kinds.h"
#include "tool/typed_number.h"
#include "tool/vectors/cmd_vectors.h"
#include "tool/verb_options.h"
#include "tool/widths/cmd_widths.h"

namespace rasterproof::tool {

CLI::Validator Positive() {
  const auto check = [](const std::string& text) {
    double number = 0;
    const bool is_positive = CLI::detail::lexical_cast(text, number) && number > 0;
    return is_positive ? std::string() : text + " is no number above 0";
  };
  return CLI::Validator(check, "POSITIVE");
}

void AddOutside(CLI::App* app, const std::function<void(const std::string&)>& add) {
  app->add_option_function<std::vector<std::string>>(
         "--plugin",
         [add](const std::vector<std::string>& paths) {
           for (const std::string& path : paths) add(std::string(kPluginPrefix) + path);
         },
         "Shared library with the interface of kit/rasterproof_plugin.h")
      ->allow_extra_args(false);
  app->add_option_function<std::vector<std::string>>(
         "--exec",
         [add](const std::vector<std::string>& commands) {
           for (const std::string& command : commands) add(std::string(kExecPrefix) + command);
         },
         "Program that answers requests on a pipe (docs/subjects.md)")
      ->allow_extra_args(false);
  app->add_option("--time-limit", OutsideLimits().seconds,
                  "Time limit in seconds for one answer of a plugin or program")
      ->check(Positive())
      ->capture_default_str();
  app->add_option_function<double>(
         "--memory-limit",
         [](double gibibytes) {
           OutsideLimits().bytes = static_cast<std::uint64_t>(gibibytes * 0x1p30);
         },
         "Limit of its address space in GiB (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->default_str("4");
}

void AddSeconds(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  app->add_option("--seconds", campaign.seconds, "Maximum seconds per " + of + " (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void AddSeed(CLI::App* app, std::uint64_t& seed, const std::string& of) {
  app->add_option_function<std::string>(
         "--seed", [&seed](const std::string& text) { seed = ParseSeed(text); },
         "Seed of the " + of + ", or 'random' (and print it)")
      ->default_str("1");
}

void AddCampaign(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  AddSeed(app, campaign.seed);
  app->add_option("--cases", campaign.cases, "Cases per " + of)
      ->check(Positive())
      ->capture_default_str();
  AddSeconds(app, campaign, of);
}

void AddSubject(CLI::App* app, std::string& subject, const std::string& help) {
  app->add_option("--subject", subject, help)->capture_default_str();
  AddOutside(app, [&subject](const std::string& name) { subject = name; });
}

namespace {

void AddScene(CLI::App* app, SceneOptions& scene) {
  app->add_option("scene", scene.path,
                  "Scene file (JSON; - for standard input) or mesh (obj, ply, off, stl, gltf, glb)")
      ->required();
  app->add_option("--camera", scene.camera,
                  "For meshes: front, inside, or \"eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES\"");
  app->add_option("--project", scene.project, "For meshes: window, clip or auto")
      ->check(CLI::IsMember({"window", "clip", "auto"}))
      ->capture_default_str();
  app->add_option("--width", scene.width, "For meshes: width of the target")->capture_default_str();
  app->add_option("--height", scene.height, "For meshes: height of the target")
      ->capture_default_str();
}

void AddCoverage(CLI::App& app, Run& run) {
  static CoverageOptions options;
  CLI::App* verb = app.add_subcommand(
      "coverage", "Count the triangles over each sample, or compare two subjects");
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
  verb->callback([&run] { run = [] { return RunCoverage(options); }; });
}

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

void AddLegal(CLI::App& app, Run& run) {
  static LegalOptions options;
  CLI::App* verb = app.add_subcommand(
      "legal", "Check whether one legal model explains a drawing, or show what is open");
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
  verb->callback([&run] { run = [] { return RunLegal(options); }; });
}

void AddPlan(CLI::App& app, Run& run) {
  static PlanOptions options;
  CLI::App* verb =
      app.add_subcommand("plan", "Choose the cheapest arithmetic that is exact for a scene");
  AddScene(verb, options.scene);
  verb->add_option("--profile", options.profile, "Preset or profile file")->capture_default_str();
  verb->add_flag("--barycentrics", options.barycentrics, "Barycentrics are needed");
  verb->add_flag("--depth", options.depth, "Depth is needed");
  verb->add_flag("--wireframe", options.wireframe, "Edge distances are needed");
  verb->add_flag("--verify", options.verify, "Draw by the plan and compare with the oracle");
  verb->add_flag("--measure", options.measure,
                 "Time what each left-out stage saves on this scene, and the whole pipeline");
  verb->add_option("--error", options.error,
                   "Name the cheapest method proved to move no edge by more than this many pixels")
      ->check([](const std::string& text) {
        double pixels = -1;
        const bool is_number = CLI::detail::lexical_cast(text, pixels);
        return is_number && pixels >= 0 && std::isfinite(pixels) ? "" : "give pixels, 0 or more";
      });
  verb->add_option("--bench", options.bench, "File of bench --json with the times for --error");
  verb->callback([&run] { run = [] { return RunPlan(options); }; });
}

}  // namespace

void AddListLength(CLI::App* app, std::size_t& length) {
  app->add_option_function<std::string>(
         "--list-length", [&length](const std::string& text) { length = ParseListLength(text); },
         "Triangles before the mesh in the longest list")
      ->type_name("COUNT")
      ->default_str("65537; for a program 257");
}

void AddSceneVerbs(CLI::App& app, Run& run) {
  AddCoverage(app, run);
  AddLegal(app, run);
  AddPlan(app, run);
}

namespace {

void AddFloatMode(CLI::App* app, const std::string& option, FloatModeOfHost::Where where,
                  const std::string& help, FloatModeOfHost& float_mode) {
  app->add_option_function<std::string>(
         option,
         [where, &float_mode](const std::string& name) {
           float_mode = {FindFloatMode(name).value_or(FloatMode::kUsual), where};
         },
         help)
      ->check(
          CLI::IsMember(std::vector<std::string>{kFloatModeNames.begin(), kFloatModeNames.end()}));
}

}  // namespace

void AddPipeVerb(CLI::App& app, Run& run) {
  static HostOptions host;
  CLI::App* verb =
      app.add_subcommand("pipe", "Answer requests on a pipe by a library: pipe answer plugin:PATH");
  verb->require_subcommand(1);
  CLI::App* answer = verb->add_subcommand("answer", "Answer requests with a plugin");
  answer->add_option("subject", host.subject, "plugin:PATH")->required();
  answer->add_flag("--describe", host.describe, "Print only its description");
  AddFloatMode(answer, "--fp-env", FloatModeOfHost::Where::kFromTheStart,
               "Floating-point mode in which the plugin is loaded and called", host.float_mode);
  AddFloatMode(answer, "--fp-env-of-workers", FloatModeOfHost::Where::kInOtherThreads,
               "Floating-point mode of the plugin's own threads, before each call",
               host.float_mode);
  answer->callback([&run] { run = [] { return HostSubject(host); }; });
}

void AddWidthsVerb(CLI::App& app, Run& run) {
  static WidthsOptions options;
  CLI::App* verb = app.add_subcommand(
      "widths",
      "Fewest bits for every value of an integer edge function, with inputs that need them");
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
  verb->callback([&run] { run = [] { return RunWidths(options); }; });
}

void AddVectorsVerb(CLI::App& app, Run& run) {
  static GenerateOptions generate_options;
  static VerifyOptions verify_options;
  CLI::App* verb = app.add_subcommand(
      "vectors", "Write cases and their required coverage as files for your own test bench");
  verb->require_subcommand(1);
  CLI::App* generate = verb->add_subcommand("generate", "Write cases drawn for a profile");
  generate->add_option("--profile", generate_options.profile, "Profile")->required();
  generate->add_option("--level", generate_options.level, "1: 500 cases, 2: 50,000")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  generate->add_option("--cases", generate_options.cases, "Cases, instead of the level's number")
      ->check(Positive());
  AddSeed(generate, generate_options.seed);
  CLI::Option* const world =
      generate->add_option("--world", generate_options.world,
                           "Instead of drawn cases, every triangle with so many bits before and "
                           "after the point of a coordinate (2.1; with a sign s2.1)");
  for (const char* of_drawn : {"--level", "--cases", "--seed"})
    world->excludes(generate->get_option(of_drawn));
  generate->add_flag("--yes", generate_options.yes, "Accept a world of any number of cases")
      ->needs(world);
  generate->add_flag("--values", generate_options.values,
                     "Also what channels hold at covered samples, and the floats that the "
                     "profile's error allows");
  generate->add_option("--format", generate_options.format, "Format of the files")
      ->check(CLI::IsMember({"jsonl", "c", "readmemh"}))
      ->capture_default_str();
  generate
      ->add_option("-o,--out", generate_options.output,
                   "File (- for standard output); for readmemh a folder")
      ->capture_default_str();
  generate->callback([&run] { run = [] { return RunGenerate(generate_options); }; });
  CLI::App* verify = verb->add_subcommand(
      "verify", "Find answers that contradict every legal drawing; finding none proves nothing");
  verify->add_option("vectors", verify_options.vectors, "File of generate in the format jsonl")
      ->required();
  CLI::Option* const answers = verify->add_option(
      "answers", verify_options.answers, "Your rasterizer's answers (- for standard input)");
  AddSubject(verify, verify_options.subject, "Subject that draws, instead of a file of answers");
  for (const char* subject : {"--subject", "--plugin", "--exec"})
    answers->excludes(verify->get_option(subject));
  verify
      ->add_flag(
          "--alone", verify_options.alone,
          "Each answer comes from its own call: skip joint constraints, which are about one call")
      ->excludes(verify->get_option("--subject"));
  verify->add_option("--show", verify_options.shown, "Maximum contradictions to print")
      ->capture_default_str();
  verify->callback([&run] { run = [] { return RunVerify(verify_options); }; });
}

}  // namespace rasterproof::tool
