// rasterproof diff: where two subjects disagree on a scene.
#include <memory>
#include <string>

#include "core/coverage.h"
#include "core/error.h"
#include "fmt/format.h"
#include "io/image.h"
#include "io/output.h"
#include "report/picture.h"
#include "tool/asked.h"
#include "tool/commands.h"
#include "tool/session.h"

namespace rasterproof::tool {

int RunDiff(const DiffOptions& options) {
  RequireHonestEnvironment();
  std::unique_ptr<Subject> subject = MakeSubject(options.subject);
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
  if (!options.profile.empty()) subject = MakeSubject(options.subject, options.profile);
  const CoverageCounts observed = ShownBy(*against, scene, Draw(*subject, scene));
  const CoverageCounts expected = ShownBy(*subject, scene, Draw(*against, scene));
  const CoverageDifference difference = Compare(observed, expected);
  std::string text = fmt::format("samples {}\ncovered {}\nwrong {}\nmissing {}\nunexpected {}\n",
                                 difference.samples, difference.covered, difference.wrong,
                                 difference.missing, difference.unexpected);
  if (difference.wrong != 0) {
    const auto samples = static_cast<std::size_t>(observed.samples);
    const std::size_t pixel = difference.first_wrong / samples;
    const auto width = static_cast<std::size_t>(observed.width);
    text += fmt::format(
        "first column {} row {} sample {}: {} has {} front {} back, {} has {} front {} back\n",
        pixel % width, pixel / width, difference.first_wrong % samples, options.subject,
        observed.front[difference.first_wrong], observed.back[difference.first_wrong],
        options.against, expected.front[difference.first_wrong],
        expected.back[difference.first_wrong]);
  }
  if (!options.png.empty()) {
    io::WriteFile(options.png, io::EncodePng(report::PaintDifference(observed, expected)));
  }
  io::WriteStandardOutput(text);
  return difference.wrong == 0 ? kExitHolds : kExitViolated;
}

}  // namespace rasterproof::tool
