// rasterproof coverage: what a subject covers, as rows of counts or a picture, or where it differs
// from another.
#include "tool/coverage/cmd_coverage.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/quoted.h"
#include "core/ulp.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/image.h"
#include "io/netpbm.h"
#include "io/output.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "report/picture.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/resolve.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

bool IsShaded(const CoverageOptions& options) { return options.mode != "coverage"; }

std::string SubjectName(const CoverageOptions& options) {
  if (!options.subject.empty()) return options.subject;
  return IsShaded(options) ? "spans-exact" : "exact";
}

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

// The counts as grey levels, the samples of a pixel side by side, as `legal --counts` reads them.
std::string CountsToPgm(const CoverageCounts& counts, const std::string& path) {
  std::vector<std::uint32_t> levels(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) levels[k] = counts.Count(k);
  return io::EncodePgm(counts.width * counts.samples, counts.height, levels, Quoted(path));
}

// A subject without its own grid draws the scene as the profile snaps it.
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

// How far the two agree, and the first sample at which they do not.
std::string DifferenceText(const CoverageCounts& observed, const CoverageCounts& expected,
                           const CoverageOptions& options) {
  const CoverageDifference difference = Compare(observed, expected);
  std::string text = fmt::format("samples {}\ncovered {}\nwrong {}\nmissing {}\nunexpected {}\n",
                                 difference.samples, difference.covered, difference.wrong,
                                 difference.missing, difference.unexpected);
  if (difference.wrong == 0) return text;
  const std::size_t first = difference.first_wrong;
  const auto samples = static_cast<std::size_t>(observed.samples);
  const auto width = static_cast<std::size_t>(observed.width);
  return text + fmt::format(
                    "first column {} row {} sample {}: {} has {} front {} back, {} has {} front {} "
                    "back\n",
                    first / samples % width, first / samples / width, first % samples,
                    SubjectName(options), observed.front[first], observed.back[first],
                    options.against, expected.front[first], expected.back[first]);
}

int RunAgainst(const CoverageOptions& options) {
  std::unique_ptr<Subject> subject = MakeSubject(SubjectName(options));
  const Scene scene = LoadScene(options.scene);
  RequireTakes(*subject, scene, options.scene.path);
  // Against the oracle the subject is held to its own profile, unless another one is named.
  std::unique_ptr<Subject> against;
  if (IsOracle(options.against) && options.profile.empty()) {
    against = MakeOracle(options.against, subject->Info().profile);
  } else {
    against = MakeSubject(options.against, options.profile);
  }
  NotePreset(against->Info().profile);
  RequireTakes(*against, scene, options.scene.path);
  if (subject->Info().profile.pattern.samples() != against->Info().profile.pattern.samples()) {
    throw InputError("--against " + options.against, "the two have different samples per pixel",
                     "compare subjects of one sample pattern");
  }
  // Facings that it does not tell are worked out by the profile that it is compared by.
  if (!options.profile.empty()) subject = MakeSubject(SubjectName(options), options.profile);
  const CoverageCounts observed = ShownBy(against->Info(), scene, Draw(*subject, scene));
  const CoverageCounts expected = ShownBy(subject->Info(), scene, Draw(*against, scene));
  if (!options.png.empty()) {
    io::WriteOutput(options.png,
                    io::EncodeFor(options.png, report::PaintDifference(observed, expected)));
  }
  if (options.png != "-")
    io::WriteOutput(options.output, DifferenceText(observed, expected, options));
  return Compare(observed, expected).wrong == 0 ? kExitHolds : kExitViolated;
}

io::Image Shaded(const CoverageOptions& options, const Scene& scene) {
  const std::string& mode = options.mode;
  const reference::Method* method = reference::FindMethod(SubjectName(options));
  if (method == nullptr) {
    throw InputError(
        "--subject " + options.subject, "only a method of the reference shades pixels",
        "choose a method without a suffix from 'rasterproof list subjects', or --mode coverage");
  }
  reference::Needs needs;
  needs.barycentrics = mode == "barycentrics";
  needs.depth = mode == "depth";
  needs.edge_distance = mode == "wireframe";
  const FragmentBuffers fragments = reference::RasterizeFragments(scene, *method, {}, needs);
  if (needs.barycentrics) return report::PaintBarycentrics(fragments);
  if (needs.depth) return report::PaintDepth(fragments);
  if (needs.edge_distance) return report::PaintWireframe(fragments, options.line_width);
  return report::PaintFlat(fragments);
}

}  // namespace

int RunCoverage(const CoverageOptions& options) {
  RequireHonestEnvironment();
  if (!options.against.empty()) return RunAgainst(options);
  Scene scene = LoadScene(options.scene);
  if (IsShaded(options)) {
    io::WriteOutput(options.png, io::EncodeFor(options.png, Shaded(options, scene)));
    return kExitHolds;
  }
  const std::string name = SubjectName(options);
  const bool oracle = IsOracle(name);
  const std::unique_ptr<Subject> subject = MakeSubject(name, oracle ? options.profile : "");
  if (!oracle && !options.profile.empty()) scene = SnappedFor(*subject, scene, options.profile);
  RequireTakes(*subject, scene, options.scene.path);
  const CoverageCounts counts = Draw(*subject, scene);
  if (options.png.empty()) {
    io::WriteOutput(options.output, CountsToText(counts));
  } else if (options.png.ends_with(".pgm")) {
    io::WriteOutput(options.png, CountsToPgm(counts, options.png));
  } else {
    io::WriteOutput(options.png, io::EncodeFor(options.png, report::PaintCounts(counts)));
  }
  return kExitHolds;
}

}  // namespace rasterproof::tool
