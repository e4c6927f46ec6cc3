// rasterproof render: pictures of what a method draws.
#include <memory>
#include <string>

#include "core/error.h"
#include "fmt/format.h"
#include "io/image.h"
#include "io/output.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "report/picture.h"
#include "tool/asked.h"
#include "tool/commands.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

io::Image PaintCoverage(const RenderOptions& options, const Scene& scene) {
  const std::unique_ptr<Subject> subject = MakeSubject(options.subject);
  RequireTakes(*subject, scene, options.scene.path);
  const CoverageCounts observed = Draw(*subject, scene);
  if (options.mode == "coverage") return report::PaintCounts(observed);
  const std::unique_ptr<Subject> oracle = MakeOracle("exact", subject->Info().profile);
  return report::PaintDifference(observed, ShownBy(*subject, scene, Draw(*oracle, scene)));
}

io::Image PaintFragments(const RenderOptions& options, const Scene& scene) {
  const reference::Method* method = reference::FindMethod(options.subject);
  if (method == nullptr) {
    throw InputError(
        "--subject " + options.subject, "only a method of the reference shades pixels",
        "choose a method without a suffix from 'rasterproof list subjects', or --mode coverage");
  }
  reference::Needs needs;
  needs.barycentrics = options.mode == "barycentrics";
  needs.depth = options.mode == "depth";
  needs.edge_distance = options.mode == "wireframe";
  const FragmentBuffers fragments = reference::RasterizeFragments(scene, *method, {}, needs);
  if (options.mode == "barycentrics") return report::PaintBarycentrics(fragments);
  if (options.mode == "depth") return report::PaintDepth(fragments);
  if (options.mode == "wireframe") return report::PaintWireframe(fragments, options.line_width);
  return report::PaintFlat(fragments);
}

}  // namespace

int RunRender(const RenderOptions& options) {
  RequireHonestEnvironment();
  const Scene scene = LoadScene(options.scene);
  const bool counts = options.mode == "coverage" || options.mode == "difference";
  const io::Image image = counts ? PaintCoverage(options, scene) : PaintFragments(options, scene);
  const std::string png = io::EncodePng(image);
  WriteOutput(options.output, png);
  return kExitHolds;
}

}  // namespace rasterproof::tool
