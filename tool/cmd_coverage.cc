// rasterproof coverage: the count per sample, as rows of integers.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "core/error.h"
#include "core/profile.h"
#include "core/ulp.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "tool/asked.h"
#include "tool/commands.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// Rows of space-separated integers, top row first; the samples of a pixel stand side by side.
std::string CountsToText(const CoverageCounts& counts) {
  std::string text;
  text.reserve(counts.size() * 2);
  const std::size_t row_length =
      static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::uint32_t count = counts.Count(k);
    if (count < 10) {
      text += static_cast<char>('0' + count);
    } else {
      text += std::to_string(count);
    }
    text += (k + 1) % row_length == 0 ? '\n' : ' ';
  }
  return text;
}

// A subject without a grid of its own draws what the profile's snap leaves of the scene.
Scene SnappedFor(const Subject& subject, const Scene& scene, const std::string& name) {
  const TargetProfile profile(io::ReadProfile(name), scene);
  const TargetProfile own(subject.Info().profile, scene);
  if (SameModel(profile, own)) return scene;
  if (profile.freedom.MovesVertices()) {
    throw InputError("--profile " + name, "it leaves open to which grid points vertices snap",
                     "name a profile with one grid, such as vulkan-canonical");
  }
  if (!own.snap.IsNone() || profile.scanline_rounding != own.scanline_rounding ||
      profile.pattern != own.pattern || profile.tie_rule != own.tie_rule ||
      profile.y_axis != own.y_axis || scene.clip_space) {
    throw InputError("--profile " + name,
                     "subject " + subject.Info().name + " draws by its own profile, " + own.name,
                     "leave --profile out, or use --subject exact");
  }
  Scene snapped = SnapScene(scene, profile);
  const bool float32 = std::ranges::all_of(snapped.vertices, [](const Vertex& v) {
    return IsFloat32(v.x) && IsFloat32(v.y) && IsFloat32(v.z) && IsFloat32(v.w);
  });
  snapped.precision = float32 ? Precision::kFloat32 : Precision::kFloat64;
  return snapped;
}

}  // namespace

int RunCoverage(const CoverageOptions& options) {
  RequireHonestEnvironment();
  const bool oracle = IsOracle(options.subject);
  const std::unique_ptr<Subject> subject =
      MakeSubject(options.subject, oracle ? options.profile : "");
  Scene scene = LoadScene(options.scene);
  if (!oracle && !options.profile.empty()) scene = SnappedFor(*subject, scene, options.profile);
  RequireTakes(*subject, scene, options.scene.path);
  const std::string text = CountsToText(Draw(*subject, scene));
  WriteOutput(options.output, text);
  return kExitHolds;
}

}  // namespace rasterproof::tool
