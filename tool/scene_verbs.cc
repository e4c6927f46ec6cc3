// Options of the verbs that take one scene.
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tool/commands.h"
#include "tool/outside.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {

CLI::Validator Positive() {
  const auto check = [](const std::string& text) {
    double number = 0;
    const bool is_positive = CLI::detail::lexical_cast(text, number) && number > 0;
    return is_positive ? std::string() : text + " is not above 0";
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
  CLI::App* verb = app.add_subcommand("coverage", "The count per sample, as rows of integers");
  AddScene(verb, options.scene);
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Preset or profile file: the oracle's model (default real); a subject without a "
                   "grid draws the scene snapped to the profile's");
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  verb->callback([&run] { run = [] { return RunCoverage(options); }; });
}

void AddDecided(CLI::App& app, Run& run) {
  static DecidedOptions options;
  CLI::App* verb =
      app.add_subcommand("decided", "How often legal models of a profile cover each sample");
  AddScene(verb, options.scene);
  verb->add_option("--profile", options.profile, "Preset or profile file")->capture_default_str();
  verb->add_option("--json", options.json,
                   "Counts and what is open, as JSON (- for standard output)");
  verb->add_option("--png", options.png, "Picture: where legal models differ");
  verb->add_option("--view", options.view, "The picture's part: COLUMN,ROW,WIDTH,HEIGHT")
      ->delimiter(',')
      ->expected(4);
  verb->add_option("--scale", options.scale,
                   "Side of a pixel in the picture; from 4 on with the triangles' edges")
      ->check(CLI::Range(1, 128))
      ->capture_default_str();
  verb->callback([&run] { run = [] { return RunDecided(options); }; });
}

void AddDiff(CLI::App& app, Run& run) {
  static DiffOptions options;
  CLI::App* verb = app.add_subcommand("diff", "Where two subjects disagree on a scene");
  AddScene(verb, options.scene);
  AddSubject(verb, options.subject);
  verb->add_option("--against", options.against, "What to compare with")->capture_default_str();
  verb->add_option("--profile", options.profile,
                   "Profile of the oracle (default: the subject's own)");
  verb->add_option("--png", options.png, "Picture of the difference");
  verb->callback([&run] { run = [] { return RunDiff(options); }; });
}

void AddLegal(CLI::App& app, Run& run) {
  static LegalOptions options;
  CLI::App* verb = app.add_subcommand("legal", "Whether one legal model explains a drawing");
  AddScene(verb, options.scene);
  verb->add_option("image", options.image,
                   "Counts as `coverage` writes them, or a PNG picture (default: a subject draws)");
  AddSubject(verb, options.subject, "Subject that draws the scene");
  verb->add_option("--profile", options.profile,
                   "Preset or profile file (default: the subject's own)");
  verb->add_option("--background", options.background,
                   "Colour of a picture where nothing is drawn, RRGGBB")
      ->capture_default_str();
  verb->add_option("--json", options.json, "Verdict as JSON (- for standard output)");
  verb->add_option("--save", options.save, "File for the part that no model explains, as a case");
  verb->callback([&run] { run = [] { return RunLegal(options); }; });
}

void AddPlan(CLI::App& app, Run& run) {
  static PlanOptions options;
  CLI::App* verb =
      app.add_subcommand("plan", "The cheapest exact arithmetic for a scene, and what is left out");
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

void AddRender(CLI::App& app, Run& run) {
  static RenderOptions options;
  CLI::App* verb = app.add_subcommand("render", "Pictures (PNG) of what a method draws");
  AddScene(verb, options.scene);
  verb->add_option("--mode", options.mode,
                   "flat, barycentrics, depth, wireframe, coverage or difference")
      ->check(
          CLI::IsMember({"flat", "barycentrics", "depth", "wireframe", "coverage", "difference"}))
      ->capture_default_str();
  AddSubject(verb, options.subject);
  verb->add_option("--line-width", options.line_width, "Half-width of wireframe lines in pixels")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("-o,--output", options.output, "PNG file (- for standard output)")->required();
  verb->callback([&run] { run = [] { return RunRender(options); }; });
}

}  // namespace

void AddSceneVerbs(CLI::App& app, Run& run) {
  AddCoverage(app, run);
  AddRender(app, run);
  AddDecided(app, run);
  AddLegal(app, run);
  AddPlan(app, run);
  AddDiff(app, run);
}

}  // namespace rasterproof::tool
