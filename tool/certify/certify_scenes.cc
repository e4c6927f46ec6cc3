// The scenes of a certificate: found, loaded, drawn by the subject, compared with the oracle.
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/result.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/placed_scene.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/scene_set.h"
#include "legal/joint.h"
#include "model/snap_scene.h"
#include "props/compare/compare.h"
#include "props/compare/yardsticks.h"
#include "props/judging/as_shown.h"
#include "props/judging/gate.h"
#include "props/property.h"
#include "props/run/conclude.h"
#include "tool/certify/certify.h"
#include "tool/interrupt.h"
#include "tool/legal/legality.h"
#include "tool/not_stated.h"
#include "tool/scene_source.h"
#include "tool/session.h"
#include "tool/shared_files.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

std::string WhyNotTaken(const SubjectInfo& info, const Scene& scene) {
  if (scene.clip_space && !info.takes_clip) return "the scene is in clip space";
  if (!scene.clip_space && !info.takes_window) return "the scene is in window space";
  return info.profile.fixed ? "coordinates out of range of the subject's integers"
                            : "the scene is float64";
}

// What came of drawing a scene.
struct Attempt {
  std::shared_ptr<const Drawing> drawing;
  std::optional<OneCall> call;  ///< of a profile that leaves something free
  CallEnd end;                  ///< why one of the two is missing
  double seconds = 0;
};

CallEnd InWords(Stop stop, const std::string& why) {
  if (IsBreakdown(stop)) return {stop, "the subject failed: " + why};
  if (IsALimit(stop)) return {stop, "not judged: " + why};
  if (stop == Stop::kRefused) return {stop, "the subject refused it: " + why};
  return {stop, "the subject can't take it: " + why};
}

Attempt TryToDraw(Subject& subject, const Scene& scene) {
  Attempt attempt;
  if (!Takes(subject.Info(), scene)) {
    attempt.end = {Stop::kNotDrawable, WhyNotTaken(subject.Info(), scene)};
    return attempt;
  }
  const auto start = Clock::now();
  try {
    const auto drawing = std::make_shared<Drawing>();
    drawing->counts = Draw(subject, scene);
    attempt.drawing = drawing;
    if (!subject.Info().profile.freedom.IsNone()) attempt.call = DrawInOneCall(subject, scene);
  } catch (const SubjectStop& stop) {
    attempt.end = InWords(stop.stop(), stop.what());
  } catch (const InputError& error) {
    attempt.end = InWords(Stop::kNotDrawable, error.what());
  }
  attempt.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return attempt;
}

// With the time that is left to a subject that hung on another scene.
Attempt TryInTime(Subject& subject, const Scene& scene, props::Pace& pace) {
  const double limit = IsOutside(subject.Info().name) ? OutsideLimits().seconds : 0;
  const bool is_short = pace.hangs && limit > 0;
  if (is_short) {
    const std::chrono::duration<double> left(pace.LimitAfterAHang(limit));
    subject.SetDeadline(Clock::now() + std::chrono::duration_cast<Clock::duration>(left));
  }
  Attempt attempt = TryToDraw(subject, scene);
  subject.SetDeadline(Clock::time_point::max());
  if (attempt.drawing) pace.Answered(attempt.seconds);
  if (attempt.end.stop == Stop::kHung || attempt.end.stop == Stop::kDeadline) {
    pace.hangs = true;
    ++pace.silent;
  }
  if (is_short && attempt.end.stop == Stop::kDeadline) {
    attempt.end.why = "no answer in time; after a hang, scenes get less than --time-limit";
  }
  return attempt;
}

// The oracle's counts under the profile, of what the subject can show; `difference` takes how the
// drawing differs from them.
props::Yardstick ByTruth(MeasuredScene& measured, const Profile& profile, bool as_shown,
                         CoverageDifference& difference) {
  return [&, as_shown](const props::CaseAtHand&) -> props::Judging {
    return {"", [&, as_shown](const props::Drawn& drawn) -> props::Reading {
              try {
                const CoverageCounts& truth = measured.Truth(profile);
                const CoverageCounts& counts = drawn.drawing->counts;
                const CoverageCounts expected = as_shown ? props::AsShown(truth) : truth;
                difference = Compare(counts, expected);
                return {.wrong = props::WrongSamples(counts, expected)};
              } catch (const InputError& error) {
                return {.end = {Stop::kNotDrawable, error.what()}};
              }
            }};
  };
}

// Draws the scene, and compares it with the truth under each profile.
Attempt Measure(Subject& subject, MeasuredScene& measured, const std::vector<Profile>& profiles,
                props::Pace& pace, std::vector<SceneResult>& results) {
  const Scene& scene = measured.scene();
  const SubjectInfo& info = subject.Info();
  const bool as_shown = props::IsJudgedAsShown(info, scene);
  Attempt attempt;
  const props::Row row{
      .cases = 1,
      .at = [&](std::uint64_t) { return Case{scene, info.profile, {}, measured.name()}; },
      .draw = [&](const props::CaseAtHand&) -> props::Drawn {
        attempt = TryInTime(subject, scene, pace);
        return {attempt.drawing ? CallEnd{} : attempt.end, attempt.drawing};
      }};
  std::vector<CoverageDifference> differences(profiles.size());
  std::vector<props::Yardstick> yardsticks;
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    yardsticks.push_back(ByTruth(measured, profiles[k], as_shown, differences[k]));
  }
  const std::vector<Cell> cells = props::CompareRow(row, yardsticks);
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    const bool is_compared = cells[k].cases > cells[k].ended;
    results.push_back({.scene = measured.name(),
                       .subject = info.name,
                       .profile = profiles[k].name,
                       .triangles = scene.triangles.size(),
                       .difference = differences[k],
                       .as_shown = as_shown,
                       .applicable = is_compared,
                       .message = is_compared ? WhyNotStated(scene, profiles[k]) : cells[k].why,
                       .seconds = attempt.seconds});
  }
  return attempt;
}

// The property's result on one scene, of which nothing is said yet.
PropertyResult ResultOn(const MeasuredScene& measured, const SubjectInfo& info,
                        const props::Property& property) {
  PropertyResult result = props::NothingRun(info, property, /*seed=*/0);
  result.property = fmt::format("{} on {}", property.name, measured.name());
  result.cases = 1;
  return result;
}

// A breakdown over a given scene, or a draw that took too long, as a result of the property that a
// draw comes back.
PropertyResult AsResult(const SubjectInfo& info, const MeasuredScene& measured,
                        const Attempt& attempt) {
  PropertyResult result =
      ResultOn(measured, info, *props::FindProperty("DrawStaysInsideItsTarget"));
  const bool is_breakdown = IsBreakdown(attempt.end.stop);
  result.outcome = is_breakdown ? Outcome::kViolated : Outcome::kInconclusive;
  if (is_breakdown) result.cases_exercised = result.exercised = 1;
  result.message = attempt.end.why;
  result.seconds = attempt.seconds;
  return result;
}

// Whether one legal model explains what one call shows of the scene.
PropertyResult JudgeJointly(const SubjectInfo& info, const MeasuredScene& measured,
                            const OneCall& call) {
  const props::Property& property = *props::FindProperty("OneLegalModelExplainsTheMesh");
  const Scene& scene = measured.scene();
  PropertyResult result = ResultOn(measured, info, property);
  result.is_of_a_scene = true;
  result.outcome = Outcome::kNotApplicable;
  if (const auto why = props::DoesNotApply(property.gate, {info})) {
    result.message = *why;
  } else if (const auto no_models = legal::WhyNotJoint(scene, {info.profile, scene})) {
    result.message = *no_models;
  } else {
    const auto start = Clock::now();
    const legal::JointVerdict verdict =
        legal::JudgeJointly(scene, {info.profile, scene}, call.Observed());
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    result.not_judged = verdict.not_judged;
    result.exercised = verdict.samples - verdict.not_judged;
    result.cases_exercised = 1;
    switch (verdict.legality) {
      case legal::Legality::kLegal:
        result.outcome = Outcome::kHolds;
        break;
      case legal::Legality::kNotLegal:
        result.outcome = Outcome::kViolated;
        result.message = CoreLine(*verdict.core, scene, info.profile.pattern.samples());
        break;
      case legal::Legality::kNotJudged:
        result.outcome = Outcome::kNotExercised;
        result.message = fmt::format("a component of {} triangles is too large to judge",
                                     verdict.largest_given_up);
        break;
    }
  }
  return result;
}

// How a reader on any machine names a file of the bundled set: "scenes/ties.json" (Located). A file
// that lies elsewhere is named by its path.
std::string SharedName(const std::string& file, const std::string& scene_set) {
  const std::filesystem::path folder = std::filesystem::path(scene_set).parent_path();
  const std::filesystem::path name =
      std::filesystem::path(file).lexically_relative(folder.parent_path());
  return name.empty() || *name.begin() == ".." ? file : name.string();
}

}  // namespace

MeasuredScene::MeasuredScene(const io::SceneEntry& entry, const std::string& path, Scene scene)
    : name_(entry.name),
      real_(entry.real),
      mesh_(IsMeshPath(entry.path)),
      arguments_(ShellWord(path)),
      scene_(std::move(scene)) {
  if (!mesh_) return;
  if (!entry.camera.empty()) arguments_ += " --camera " + ShellWord(entry.camera);
  if (entry.project != "auto") arguments_ += " --project " + entry.project;
  arguments_ += fmt::format(" --width {} --height {}", entry.width, entry.height);
}

std::string MeasuredScene::CommandOf(const std::string& verb) const {
  return fmt::format("rasterproof {} {}", verb, arguments_);
}

std::string MeasuredScene::CommandThatShows(const std::string& subject) const {
  // explain takes no mesh.
  const std::string command =
      mesh_ ? CommandOf("coverage") + " --against exact" : CommandOf("explain");
  return fmt::format("{} --subject {}", command, ShellWord(subject));
}

const CoverageCounts& MeasuredScene::Truth(const Profile& profile) {
  const std::lock_guard lock(mutex_);
  for (const Known& known : truths_) {
    if (!SameModel(known.profile, profile)) continue;
    exact::CreditTiers(known.tiers);
    return known.counts;
  }
  const exact::TierScope scope;
  CoverageCounts counts = exact::Coverage(scene_, profile);
  return truths_.emplace_back(Known{profile, std::move(counts), scope.Counts()}).counts;
}

MeasuredScenes LoadSceneSet(const std::string& path, Progress& progress) {
  const std::optional<std::string> found = path.empty() ? FindShared(kSceneSet) : Located(path);
  if (!found) {
    throw InputError(kSceneSet,
                     fmt::format("there is no scene set beside the command (looked in {})",
                                 fmt::join(SharedFolders(), ", ")),
                     "name one with --scenes FILE");
  }
  MeasuredScenes scenes;
  for (const io::SceneEntry& entry : io::ReadSceneSet(*found)) {
    progress.Stage("reading " + entry.name);
    scenes.push_back(std::make_unique<MeasuredScene>(
        entry, path.empty() ? SharedName(entry.path, *found) : entry.path,
        LoadScene({entry.path, entry.camera, entry.project, entry.width, entry.height})));
  }
  return scenes;
}

void MeasureOne(Subject& subject, MeasuredScene& measured, report::Certificate& certificate,
                props::Pace& pace) {
  const Profile real = *PresetProfile("real");
  const SubjectInfo& info = subject.Info();
  std::vector<Profile> profiles{info.profile};
  if (!SameModel(info.profile, real) && info.profile.pattern == real.pattern) {
    profiles.push_back(real);
  }
  std::vector<SceneResult> results;
  const Attempt attempt = Measure(subject, measured, profiles, pace, results);
  certificate.interrupted = Interrupted();
  if (Interrupted() && !attempt.drawing) return;  // whatever came of it, the interrupt did it
  if (IsBreakdown(attempt.end.stop) || IsALimit(attempt.end.stop)) {
    certificate.tested.push_back(AsResult(info, measured, attempt));
    certificate.replay[certificate.tested.back().property] = measured.CommandThatShows(info.name);
  }
  if (attempt.call) {
    certificate.tested.push_back(JudgeJointly(info, measured, *attempt.call));
    certificate.replay[certificate.tested.back().property] =
        fmt::format("{} --subject {}", measured.CommandOf("legal"), ShellWord(info.name));
  }
  certificate.measured = std::move(results);
}

}  // namespace rasterproof::tool
