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
#include "tool/pipe/cmd_pipe.h"
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
                  "Seconds that a plugin or program may take for one answer")
      ->check(Positive())
      ->capture_default_str();
  app->add_option_function<double>(
         "--memory-limit",
         [](double gibibytes) {
           OutsideLimits().bytes = static_cast<std::uint64_t>(gibibytes * 0x1p30);
         },
         "GiB of address space that it may have (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->default_str("4");
}

void AddSeconds(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  app->add_option("--seconds", campaign.seconds, "Most seconds a " + of + " (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void AddSeed(CLI::App* app, std::uint64_t& seed, const std::string& of) {
  app->add_option_function<std::string>(
         "--seed", [&seed](const std::string& text) { seed = ParseSeed(text); },
         "Seed of the " + of + ", or 'random' (the one taken is printed)")
      ->default_str("1");
}

void AddCampaign(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  AddSeed(app, campaign.seed);
  app->add_option("--cases", campaign.cases, "Cases a " + of)
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
                   "Preset or profile file: the oracle's model (default: real, or beside --against "
                   "the subject's own); a subject without a grid draws the scene snapped to it");
  CLI::Option* output =
      verb->add_option("-o,--output", options.output, "File for the rows")->capture_default_str();
  CLI::Option* against = verb->add_option(
      "--against", options.against,
      "Subject to compare with (such as exact): what is missing and unexpected; status 1 if any");
  CLI::Option* png =
      verb->add_option(
              "--png", options.png,
              "Picture (- for standard output) in place of the rows, or of the difference; "
              "NAME.ppm: as PPM; NAME.pgm: the counts as PGM")
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
  verb->add_option(
      "image", options.image,
      "Counts as `coverage` writes them, or a picture: PNG, PGM, PPM, or NAME.raw of 1, 3 "
      "or 4 bytes a pixel (default: a subject draws)");
  AddSubject(verb, options.subject, "Subject that draws the scene");
  verb->add_option("--profile", options.profile,
                   "Preset or profile file (default: the subject's own)");
}

void AddPictureView(CLI::App* verb, LegalOptions& options, CLI::Option* png) {
  verb->add_option("--view", options.view, "The picture's part: COLUMN,ROW,WIDTH,HEIGHT")
      ->delimiter(',')
      ->expected(4)
      ->needs(png);
  verb->add_option("--scale", options.scale,
                   "Side of a pixel in the picture; from 4 on with the triangles' edges, from 8 on "
                   "with pixel numbers and a legend")
      ->check(CLI::Range(1, 128))
      ->capture_default_str()
      ->needs(png);
}

void AddLegal(CLI::App& app, Run& run) {
  static LegalOptions options;
  CLI::App* verb = app.add_subcommand(
      "legal", "Say whether one legal model explains a drawing, or what is open");
  AddDrawing(verb, options);
  CLI::Option* background = verb->add_option("--background", options.background,
                                             "Colour of a picture where nothing is drawn, RRGGBB")
                                ->capture_default_str();
  CLI::Option* counts =
      verb->add_flag("--counts", options.counts,
                     "The levels of a PGM or raw picture are counts: how often, not only where");
  CLI::Option* ids =
      verb->add_flag("--ids", options.ids,
                     "The numbers of the image are 1 + the triangle that a sample shows, 0: none")
          ->excludes(counts)
          ->excludes(background);
  verb->add_option("--visible", options.visible,
                   "Which triangle of those that cover a sample an id names: any, last or first")
      ->check(CLI::IsMember({"any", "last", "first"}))
      ->capture_default_str()
      ->needs(ids);
  CLI::Option* facings =
      verb->add_option("--facings", options.facings,
                       "File like the image: how many of the counts, or whether the triangle of an "
                       "id, show the front")
          ->excludes(background);
  CLI::Option* json =
      verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  CLI::Option* save = verb->add_option("--save", options.save,
                                       "File for the part that no model explains, as a case that "
                                       "this verb judges again");
  CLI::Option* decided =
      verb->add_flag("--decided", options.decided,
                     "Judge no drawing: how often the legal models of --profile cover each sample");
  ExcludeAll(decided, {background, counts, ids, facings, save});
  CLI::Option* resolved =
      verb->add_flag("--resolved", options.resolved,
                     "The image is what a multisampled target was resolved to: of each pixel how "
                     "many of its samples are covered, as rows of numbers or as grey, white: all");
  ExcludeAll(resolved, {background, counts, ids, facings, save, decided});
  CLI::Option* list = verb->add_option(
      "--list", options.list, "File of drawings to judge, each its own (docs/commands.md)");
  ExcludeAll(list, {facings, json, save, decided, resolved});
  verb->add_option("--junit", options.junit,
                   "Verdicts on the list as JUnit XML (-: standard output)")
      ->needs(list);
  CLI::Option* png =
      verb->add_option("--png", options.png, "Picture: where legal models differ")->needs(decided);
  verb->add_option(
          "--mask", options.mask,
          "PNG (or NAME.pgm, or an array as NAME.h, .ts or .py) for a comparison of pictures: 255 "
          "must be covered, 0 must not, 128 is open")
      ->needs(decided);
  verb->add_option("--assume-transform-error", options.transform_error,
                   "Judge clip space: x and y may be off by N x 2^-24 of their size, then snapped")
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
                   "Name the cheapest method that is proved to move no edge by more pixels")
      ->check([](const std::string& text) {
        double pixels = -1;
        const bool is_number = CLI::detail::lexical_cast(text, pixels);
        return is_number && pixels >= 0 && std::isfinite(pixels) ? "" : "give pixels, 0 or more";
      });
  verb->add_option("--bench", options.bench, "File that bench --json wrote: the times for --error");
  verb->callback([&run] { run = [] { return RunPlan(options); }; });
}

}  // namespace

void AddListLength(CLI::App* app, std::size_t& length) {
  app->add_option_function<std::string>(
         "--list-length", [&length](const std::string& text) { length = ParseListLength(text); },
         "Triangles before the mesh in the longest list that is drawn")
      ->type_name("COUNT")
      ->default_str("65537, of a program 257");
}

void AddSceneVerbs(CLI::App& app, Run& run) {
  AddCoverage(app, run);
  AddLegal(app, run);
  AddPlan(app, run);
}

namespace {

void AddPipe(CLI::App* app, PipeOptions& options) {
  app->add_option("--property", options.property, "Property to put to the test")
      ->capture_default_str();
  app->add_option("--description", options.description,
                  "File that says what the program states (docs/subjects.md)");
  app->add_option("--profile", options.profile, "Judge by this profile, not by the description's");
  AddCampaign(app, options.campaign);
}

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

void AddRounds(CLI::App* app, RoundsOptions& options) {
  app->add_option("--rounds", options.folder,
                  "Folder of the rounds: round-N.requests is written, round-N.answers is read")
      ->required();
  app->add_option("--description", options.description,
                  "File that says what the program states (docs/subjects.md)");
  app->add_option("--profile", options.profile, "Judge by this profile, not by the description's");
}

void AddShrinkRounds(CLI::App* pipe, Run& run) {
  static ShrinkRoundsOptions options;
  CLI::App* verb = pipe->add_subcommand(
      "shrink", "Find the smallest case that still fails, by a program that is asked in rounds");
  verb->add_option("case", options.choice.path, "Case or scene file, or its JSON itself");
  verb->add_option("--case", options.choice.name, std::string(kCaseHelp));
  verb->add_option("--property", options.choice.property,
                   "Property (default: the one the file names)");
  AddRounds(verb, options.rounds);
  verb->add_option("-o,--output", options.output, "File for the smallest case")->required();
  verb->add_option("--evaluations", options.evaluations, "Most evaluations to shrink by")
      ->capture_default_str();
  verb->callback([&run] { run = [] { return RunShrinkRounds(options); }; });
}

void AddInferRounds(CLI::App* pipe, Run& run) {
  static InferRoundsOptions options;
  CLI::App* verb = pipe->add_subcommand(
      "infer", "Find the model that a program follows, which is asked in rounds");
  AddRounds(verb, options.rounds);
  AddSeed(verb, options.seed, "experiments");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->callback([&run] { run = [] { return RunInferRounds(options); }; });
}

}  // namespace

void AddPipeVerb(CLI::App& app, Run& run) {
  static PipeOptions options;
  static HostOptions host;
  CLI::App* verb = app.add_subcommand(
      "pipe", "Test a program on a pipe that you lay: pipe ask | PROGRAM | pipe judge");
  verb->require_subcommand(1);
  CLI::App* ask = verb->add_subcommand("ask", "Requests to draw, for a program's standard input");
  AddPipe(ask, options);
  ask->callback([&run] { run = [] { return RunAsk(options); }; });
  CLI::App* judge =
      verb->add_subcommand("judge", "Judge on standard input the answers to what ask asked");
  AddPipe(judge, options);
  judge->callback([&run] { run = [] { return RunJudge(options); }; });
  AddShrinkRounds(verb, run);
  AddInferRounds(verb, run);
  CLI::App* answer = verb->add_subcommand("answer", "Answer requests by a plugin");
  answer->add_option("subject", host.subject, "plugin:PATH")->required();
  answer->add_flag("--describe", host.describe, "Say only what it states");
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
      "widths", "Fewest bits of every value of an integer edge function, with the input for each");
  verb->add_option("--fixed", options.fixed,
                   "Bits of a coordinate before and after the point, 12.4; with --signed the sign "
                   "is one of those before it")
      ->required();
  verb->add_flag("--signed,!--unsigned", options.is_signed, "Coordinates have a sign (default)");
  verb->add_option("--target", options.target, "Width and height of the largest target: 4096x4096")
      ->required();
  verb->add_option("--samples", options.samples,
                   "Where samples lie in a pixel: standard-1, -2, -4, -8, -16, or a list of places "
                   "as the profile key sample_locations has it: '[[0, 0], [0.5, 0.5]]'")
      ->capture_default_str();
  verb->add_option("--tile", options.tile, "Pixels of a tile's side, and of the larger step")
      ->check(CLI::Range(1, kMaxTargetSide))
      ->capture_default_str();
  verb->add_option("--json", options.json, "File of the same as JSON (- for standard output)");
  verb->add_option("--save", options.save,
                   "Folder for a case of each value: the input that needs the last bit");
  verb->callback([&run] { run = [] { return RunWidths(options); }; });
}

void AddVectorsVerb(CLI::App& app, Run& run) {
  static GenerateOptions generate_options;
  static VerifyOptions verify_options;
  CLI::App* verb = app.add_subcommand(
      "vectors", "Cases and what is required of them as files, for your own test bench");
  verb->require_subcommand(1);
  CLI::App* generate = verb->add_subcommand("generate", "Write cases drawn for a profile");
  generate->add_option("--profile", generate_options.profile, "Profile")->required();
  generate->add_option("--level", generate_options.level, "1: 500 cases, 2: 50,000")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  generate->add_option("--cases", generate_options.cases, "Cases, in place of the level's number")
      ->check(Positive());
  AddSeed(generate, generate_options.seed);
  CLI::Option* const world = generate->add_option(
      "--world", generate_options.world,
      "Every triangle with coordinates of so many bits before and after the point (2.1; with a "
      "sign s2.1), in place of drawn cases");
  for (const char* of_drawn : {"--level", "--cases", "--seed"})
    world->excludes(generate->get_option(of_drawn));
  generate->add_flag("--yes", generate_options.yes, "However many cases the world has")
      ->needs(world);
  generate->add_option("--format", generate_options.format, "Format of the files")
      ->check(CLI::IsMember({"jsonl", "c", "readmemh"}))
      ->capture_default_str();
  generate
      ->add_option("-o,--out", generate_options.output,
                   "File (- for standard output); of readmemh a folder")
      ->capture_default_str();
  generate->callback([&run] { run = [] { return RunGenerate(generate_options); }; });
  CLI::App* verify = verb->add_subcommand(
      "verify", "Look for answers that contradict every legal drawing; this never acquits");
  verify->add_option("vectors", verify_options.vectors, "File that generate wrote as jsonl")
      ->required();
  CLI::Option* const answers =
      verify->add_option("answers", verify_options.answers,
                         "File of what your rasterizer covered (- for standard input)");
  AddSubject(verify, verify_options.subject, "Subject that draws in place of a file of answers");
  for (const char* subject : {"--subject", "--plugin", "--exec"})
    answers->excludes(verify->get_option(subject));
  verify
      ->add_flag("--alone", verify_options.alone,
                 "Each answer is from a call of its own: joint constraints, which are about one "
                 "call, are not judged")
      ->excludes(verify->get_option("--subject"));
  verify->add_option("--show", verify_options.shown, "Contradictions printed, at most")
      ->capture_default_str();
  verify->callback([&run] { run = [] { return RunVerify(verify_options); }; });
}

}  // namespace rasterproof::tool
