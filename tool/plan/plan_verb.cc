// rasterproof plan: its options.
#include <cmath>
#include <string>

#include "tool/plan/cmd_plan.h"
#include "tool/scene_options.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddPlan(CLI::App* verb, const Invocation& /*call*/) {
  static PlanOptions options;
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
  return [] { return RunPlan(options); };
}

}  // namespace

extern constinit const Verb kPlanVerb{"plan", VerbGroup::kOneScene, 30,
                                      "Choose the cheapest arithmetic that is exact for a scene",
                                      AddPlan};

}  // namespace rasterproof::tool
