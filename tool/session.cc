#include "tool/session.h"

#include <memory>
#include <string>
#include <utility>

#include "core/call_end.h"
#include "core/error.h"
#include "core/target_size.h"
#include "fmt/format.h"
#include "props/judging/as_shown.h"
#include "props/run/facings.h"
#include "tool/interrupt.h"

namespace rasterproof::tool {

CoverageCounts Draw(Subject& subject, const Scene& scene, const DrawOptions& options) {
  const int samples = subject.Info().profile.pattern.samples();
  RequireTargetSize("scene", scene.width, scene.height, samples);
  CoverageCounts counts(scene.width, scene.height, samples);
  const CallEnd end = props::DrawByFacing(subject, scene, options, counts);
  if (end.stop != Stop::kNone) throw SubjectStop(end);
  return counts;
}

CoverageCounts ShownBy(const SubjectInfo& subject, const Scene& scene, CoverageCounts counts) {
  const bool as_shown = props::IsJudgedAsShown(subject, scene);
  return as_shown ? props::AsShown(std::move(counts)) : counts;
}

std::optional<CoverageCounts> DrawUnlessItFails(Subject& subject, const Scene& scene,
                                                const DrawOptions& options, std::string& reason) {
  try {
    return Draw(subject, scene, options);
  } catch (const SubjectStop& stop) {
    if (!IsBreakdown(stop.stop())) throw;
    reason = std::string("the subject failed: ") + stop.what();
    return std::nullopt;
  }
}

void RequireTakes(const Subject& subject, const Scene& scene, const std::string& place) {
  const SubjectInfo& info = subject.Info();
  if (Takes(info, scene)) return;
  if (scene.clip_space && !info.takes_clip) {
    throw InputError(place,
                     "the scene is in clip space and subject " + info.name + " takes window space",
                     "use a subject that takes clip space (hom-..., exact), or vertices [x, y]");
  }
  if (!scene.clip_space && !info.takes_window) {
    throw InputError(place,
                     "the scene is in window space and subject " + info.name + " takes clip space",
                     "give vertices [x, y, z, w], or use another subject");
  }
  if (info.profile.fixed) {
    const FixedInput& fixed = *info.profile.fixed;
    throw InputError(place,
                     fmt::format("subject {} does not take a coordinate: fixed point {}.{}, {}",
                                 info.name, fixed.integer_bits, fixed.fraction_bits,
                                 fixed.is_signed ? "signed" : "unsigned"),
                     fmt::format("give multiples of 2^-{} from {} to {}", fixed.fraction_bits,
                                 fixed.Least(), fixed.Largest()));
  }
  throw InputError(place, "the scene is float64 and subject " + info.name + " computes in float32",
                   "use a float64 subject (f64-..., spans-exact), or \"precision\": \"float32\"");
}

void RequireDrawsSamples(const Subject& subject, const Profile& profile, const std::string& place) {
  const SubjectInfo& info = subject.Info();
  const bool is_fixed = BuiltInKind(info.name) != nullptr;
  const int drawn = (is_fixed ? subject.OwnInfo() : info).profile.pattern.samples();
  const int needed = profile.pattern.samples();
  if (drawn == needed) return;
  const auto samples = [](int n) { return n == 1 ? "one sample" : fmt::format("{} samples", n); };
  const std::string remedy =
      fmt::format("name another subject, such as --subject exact{}",
                  is_fixed ? ", or a --plugin" : ", or state its samples by --profile");
  throw InputError(place,
                   fmt::format("subject {} draws {} a pixel, and this case has {}", info.name,
                               samples(drawn), needed),
                   remedy);
}

props::CampaignOptions CampaignOn(const Subject& subject, props::CampaignOptions options,
                                  SubjectMaker make) {
  options.stop = Interrupted;
  if (!IsOutside(subject.Info().name)) return options;
  options.time_limit = OutsideLimits().seconds;
  if (!make) return options;
  options.afresh = [make = std::move(make)]() -> std::unique_ptr<Subject> {
    try {
      return make();
    } catch (const InputError&) {
      return nullptr;
    } catch (const SubjectStop&) {  // it was interrupted
      return nullptr;
    }
  };
  return options;
}

}  // namespace rasterproof::tool
