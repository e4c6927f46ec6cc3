#include "tool/certify.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/environment.h"
#include "fmt/format.h"
#include "io/scene_set.h"
#include "props/catalog/degenerate.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/builtin/builtin.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Empty if the counts of the scene's samples are promised.
std::string WhyNotJudged(const Scene& scene, const Profile& profile) {
  if (!WithinLimits(scene, profile)) {
    return "coordinates beyond what the profile promises: observed, not judged";
  }
  if (!IsUnclipped(scene, profile)) {
    return "triangles leave the profile's no-clip rectangle: observed, not judged";
  }
  if (profile.zero_area == ZeroArea::kNothing) return "";
  if (scene.clip_space && !profile.snap.IsNone()) {
    return "areas after the division and snapping are not decided: observed, not judged";
  }
  Case c;
  c.scene = scene;
  c.profile = profile;
  return props::FlatTriangles(c).empty()
             ? ""
             : "triangles of zero area, which the profile leaves unspecified: observed, not judged";
}

SceneResult Measure(Subject& subject, MeasuredScene& measured, const Profile& profile,
                    const CoverageCounts* observed, double seconds) {
  SceneResult result;
  result.scene = measured.name();
  result.subject = subject.Info().name;
  result.profile = profile.name;
  result.triangles = measured.scene().triangles.size();
  result.seconds = seconds;
  if (observed == nullptr) {
    result.applicable = false;
    result.message = measured.scene().clip_space ? "the scene is in clip space"
                     : subject.Info().profile.fixed
                         ? "coordinates that the subject's integers do not hold"
                     : subject.Info().takes_window ? "the scene is float64"
                                                   : "the scene is in window space";
    return result;
  }
  try {
    result.difference = Compare(*observed, measured.Truth(profile));
  } catch (const InputError& error) {
    result.applicable = false;
    result.message = error.what();
  }
  if (result.applicable) result.message = WhyNotJudged(measured.scene(), profile);
  return result;
}

// A breakdown over a given scene, as a violation of the claim that a draw comes back.
PropertyResult BrokeDown(const SubjectInfo& info, const Scene& scene, const std::string& failure) {
  const props::Property& property = *props::FindProperty("DrawStaysInsideItsTarget");
  PropertyResult result;
  result.property = property.name;
  result.subject = info.name;
  result.clause = property.clause;
  result.tolerance = property.tolerance;
  result.outcome = Outcome::kViolated;
  result.cases = result.cases_exercised = result.exercised = 1;
  result.message = scene.name + ": " + failure;
  return result;
}

void MeasureScenes(Subject& subject, std::vector<std::unique_ptr<MeasuredScene>>& scenes,
                   report::Certificate& certificate) {
  const Profile real = *PresetProfile("real");
  for (const std::unique_ptr<MeasuredScene>& measured : scenes) {
    const SubjectInfo& info = subject.Info();
    const auto start = Clock::now();
    std::optional<CoverageCounts> observed;
    std::string failure;
    if (Takes(info, measured->scene())) {
      observed = DrawUnlessItFails(subject, measured->scene(), {}, failure);
    }
    if (!failure.empty()) {
      certificate.tested.push_back(BrokeDown(info, measured->scene(), failure));
    }
    const double seconds = SecondsSince(start);
    const CoverageCounts* counts = observed ? &*observed : nullptr;
    certificate.measured.push_back(Measure(subject, *measured, info.profile, counts, seconds));
    if (!SameModel(info.profile, real) && info.profile.lattice == real.lattice) {
      certificate.measured.push_back(Measure(subject, *measured, real, counts, seconds));
    }
  }
}

void TestProperties(Subject& subject, const CertifyOptions& options,
                    report::Certificate& certificate) {
  for (const props::Property& property : props::Catalog()) {
    props::CampaignOptions campaign;
    campaign.seed = options.campaign.seed;
    campaign.cases = options.campaign.cases;
    campaign.seconds = options.campaign.seconds;
    PropertyResult result = props::RunCampaign(subject, property, campaign);
    if (result.outcome == Outcome::kNotApplicable) {
      certificate.not_applicable.push_back({result.property, result.message});
    }
    certificate.tested.push_back(std::move(result));
  }
  for (const char* later : {"thread-dependent results of foreign subjects", "C ABI plugins",
                            "programs on a pipe", "profile inference"}) {
    certificate.not_applicable.push_back({later, "this build has no such way in yet"});
  }
}

std::map<std::string, std::string> DescribeEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  return {{"compiler", environment.compiler},
          {"flags", environment.flags},
          {"rounding", environment.round_to_nearest ? "to nearest" : "directed"},
          {"subnormals", environment.subnormals_kept ? "kept" : "flushed"},
          {"contraction", environment.contraction_off ? "off" : "on"}};
}

}  // namespace

MeasuredScene::MeasuredScene(std::string name, bool real, std::string command_arguments,
                             Scene scene)
    : name_(std::move(name)),
      real_(real),
      arguments_(std::move(command_arguments)),
      scene_(std::move(scene)) {}

const CoverageCounts& MeasuredScene::Truth(const Profile& profile) {
  const std::lock_guard lock(mutex_);
  for (const auto& [known, counts] : truths_) {
    if (SameModel(known, profile)) return counts;
  }
  return truths_.emplace_back(profile, exact::Coverage(scene_, profile)).second;
}

std::vector<std::unique_ptr<MeasuredScene>> LoadSceneSet(const std::string& path,
                                                         Progress& progress) {
  std::vector<std::unique_ptr<MeasuredScene>> scenes;
  for (const io::SceneEntry& entry : io::ReadSceneSet(path)) {
    progress.Stage("reading " + entry.name);
    SceneOptions options{entry.path, entry.camera, entry.project, entry.width, entry.height};
    std::string arguments = entry.path;
    if (!entry.camera.empty()) {
      arguments += fmt::format(" --camera {} --width {} --height {}", entry.camera, entry.width,
                               entry.height);
    }
    scenes.push_back(
        std::make_unique<MeasuredScene>(entry.name, entry.real, arguments, LoadScene(options)));
  }
  return scenes;
}

report::Certificate CertifySubject(const std::string& name, const CertifyOptions& options,
                                   std::vector<std::unique_ptr<MeasuredScene>>& scenes) {
  exact::ResetTiers();
  const std::unique_ptr<Subject> subject = MakeSubject(name);
  report::Certificate certificate;
  certificate.tool_version = RASTERPROOF_VERSION;
  certificate.subject = subject->Info();
  certificate.claims_exact = subjects::ClaimsExact(name) || name.starts_with("exact");
  certificate.command = options.command;
  certificate.environment = DescribeEnvironment();
  certificate.seed = options.campaign.seed;
  certificate.proved = ProvedOf(name);
  TestProperties(*subject, options, certificate);
  MeasureScenes(*subject, scenes, certificate);
  const exact::TierCounts tiers = exact::Tiers();
  certificate.oracle_tiers = {{"filter", tiers.filter},
                              {"stable", tiers.stable},
                              {"exact", tiers.exact},
                              {"symbolic", tiers.symbolic}};
  return certificate;
}

}  // namespace rasterproof::tool
