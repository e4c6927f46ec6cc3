#include "props/infer/infer.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/question.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/infer/locate.h"
#include "props/infer/nearest.h"
#include "props/infer/race.h"
#include "props/infer/stated_keys.h"
#include "props/shrink/foresee.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

Case CaseOf(const Scene& scene, const Profile& profile) {
  Case c;
  c.scene = scene;
  c.profile = profile;
  c.origin = "infer";
  return c;
}

bool Differs(const Observer& observer, const Case& c, const CoverageCounts& seen) {
  return seen != observer.Expected(exact::Coverage(c.scene, c.profile));
}

// The smallest case of its kind in which the subject does not draw as the profile does.
Case Shrunken(Observer& observer, const InferOptions& options, const Case& c) {
  constexpr std::uint64_t kBudget = 600;
  const auto differs = [&](const Case& candidate) {
    const bool may_be = !observer.HasBrokenOff() && candidate.options == DrawOptions{} &&
                        !candidate.scene.clip_space &&
                        candidate.scene.precision == c.scene.precision &&
                        WithinLimits(candidate.scene, candidate.profile) &&
                        IsUnclipped(candidate.scene, {candidate.profile, candidate.scene});
    if (!may_be) return false;
    const std::vector<CoverageCounts> seen = observer.Draw(std::span(&candidate.scene, 1));
    return !seen.empty() && seen.front().size() != 0 && Differs(observer, candidate, seen.front());
  };
  if (const auto& ahead = options.ahead) {
    const auto known = [&](const Case& candidate) -> std::optional<bool> {
      const std::uint64_t before = ahead->missed();
      const bool fails = differs(candidate);
      return ahead->missed() == before ? std::optional(fails) : std::nullopt;
    };
    const auto want = [&](const Case& /*asked*/) { return ahead->has_room(); };
    // As the subject's likely model has it, and then as it may be otherwise.
    if (differs(c)) Shrink(c, differs, kBudget);
    if (known(c).value_or(true)) Foresee(c, {known, want}, kBudget);
    return c;
  }
  return differs(c) ? Shrink(c, differs, kBudget).minimal : c;
}

// By triangles that aim at no pair of models, which near ones would lose by chance. Its witness may
// be one of the aimed ones, where none of the others tells it from the subject.
void NameNearest(Observer& observer, const Location& location, std::span<const Experiment> aimed,
                 const InferOptions& options, Inference& inference) {
  const ModelSpace space(location.y_axis, location.culls,
                         WithUsualPatterns(location.patterns, observer.stated().pattern),
                         observer.stated());
  const std::vector<Experiment> experiments =
      AimlessExperiments(observer, options.seed, options.nearest_checks);
  if (observer.HasBrokenOff() || experiments.empty()) return;
  Model nearest;
  inference.nearest = Nearest(observer, space, experiments, &nearest);
  // The profile's limit is the subject's own: what is beyond it is no witness.
  inference.nearest->profile.coordinate_limit = observer.info().profile.coordinate_limit;
  const Experiment* against = FirstAgainst(nearest, observer, space, experiments);
  if (against == nullptr) against = FirstAgainst(nearest, observer, space, aimed);
  if (against != nullptr) {
    inference.witness =
        Shrunken(observer, options, CaseOf(against->scene, space.ProfileOf(nearest)));
  }
}

void RunRace(Race& race, const InferOptions& options) {
  race.Split();
  if (race.left().empty()) return;
  race.Check(options.checks);
  race.Split();
}

void Conclude(Observer& observer, const ModelSpace& space, const Race& race,
              const InferOptions& options, Inference& inference) {
  const Profile& stated = observer.stated();
  for (const Model& model : race.left()) {
    inference.remaining.push_back(space.ProfileOf(model));
    inference.remaining.back().coordinate_limit = stated.coordinate_limit;
  }
  inference.statements = VerifyStatements(stated, inference.facing, inference.remaining);
  if (inference.Agrees()) return;
  for (const Experiment& experiment : race.experiments()) {
    const Case c = CaseOf(experiment.scene, stated);
    if (!Differs(observer, c, experiment.seen)) continue;
    inference.against_stated = Shrunken(observer, options, c);
    break;
  }
}

// Explains the samples alone, for facings that were derived from unsnapped vertices or from a wrong
// belief about the profile. Returns whether that ends the inference: a model explains them, or the
// subject broke off.
bool ConcludeWithoutFacings(Observer& observer, const ModelSpace& space,
                            const InferOptions& options, Inference& inference) {
  if (inference.facing == FacingReport::kNotTold) return false;
  observer.SetFacing(FacingReport::kNotTold);
  Race race(observer, space, options.seed);
  RunRace(race, options);
  if (observer.HasBrokenOff()) return true;
  if (race.left().empty()) {
    observer.SetFacing(inference.facing);
    return false;
  }
  inference.facing = FacingReport::kNotTold;
  inference.message = "facings of some triangles contradict their samples: left out";
  Conclude(observer, space, race, options, inference);
  return true;
}

// Which model there is, or none, says nothing of pixels that differ.
void LookAtSamples(Observer& observer, YAxis y_axis, Inference& inference) {
  if (observer.info().profile.pattern.samples() == 1 && inference.Fits()) return;
  if (observer.HasBrokenOff() || inference.is_inconclusive) return;
  inference.sample_places = FindSamplePlaces(observer, y_axis);
}

void RaceModels(Observer& observer, const Location& location, const InferOptions& options,
                Inference& inference) {
  inference.facing = observer.facing();
  const ModelSpace space(location.y_axis, location.culls, location.patterns, observer.stated());
  inference.models = space.models().size();
  Race race(observer, space, options.seed);
  RunRace(race, options);
  if (observer.HasBrokenOff()) return;
  if (location.complaint.empty()) {
    if (!race.left().empty()) return Conclude(observer, space, race, options, inference);
    if (ConcludeWithoutFacings(observer, space, options, inference)) return;
  }
  inference.message = location.complaint.empty()
                          ? "each model draws some triangle differently from the subject"
                          : location.complaint;
  constexpr int kFinest = 256;
  if (location.per_pixel < kFinest) {
    inference.message += "; sample locations were searched on multiples of 1/" +
                         std::to_string(location.per_pixel) +
                         " pixel, for the stated ranges leave no room for finer ones";
  }
  if (const auto& last = race.last_refuted()) {
    inference.last_refuted =
        CaseOf(race.experiments()[last->experiment].scene, space.ProfileOf(last->model));
  }
  NameNearest(observer, location, race.experiments(), options, inference);
}

void FindModels(Observer& observer, const InferOptions& options, Inference& inference) {
  inference.message = TooLittleRoom(observer.info());
  inference.is_inconclusive = !inference.message.empty();
  if (inference.is_inconclusive) return;
  const Location location = Locate(observer);
  if (observer.HasBrokenOff()) return;
  RaceModels(observer, location, options, inference);
  LookAtSamples(observer, location.y_axis, inference);
}

// What was found so far rests on draws that came; what it was about to show does not.
void BreakOff(const Observer& observer, Inference& inference) {
  inference.remaining.clear();
  inference.against_stated.reset();
  inference.witness.reset();
  inference.is_inconclusive = !IsBreakdown(observer.end().stop) && EndsTheCall(observer.end().stop);
  if (inference.is_inconclusive) {
    inference.message = "the subject was too slow to judge: " + observer.end().why;
    return;
  }
  inference.message = "the subject stopped: " + observer.end().why;
  inference.witness = CaseOf(observer.last_scene(), observer.info().profile);
}

}  // namespace

bool Inference::Agrees() const {
  return std::ranges::all_of(statements, &StatementVerdict::agrees);
}

Inference Infer(Subject& subject, const InferOptions& options) {
  const Clock::time_point start = Clock::now();
  Observer observer(subject);
  Inference inference;
  FindModels(observer, options, inference);
  if (observer.HasBrokenOff()) BreakOff(observer, inference);
  inference.experiments = observer.draws();
  inference.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return inference;
}

std::vector<LikelyModel> LikelyModels(Subject& subject, std::span<const Scene> scenes,
                                      std::size_t most) {
  std::vector<LikelyModel> likely;
  Observer observer(subject);
  if (!TooLittleRoom(observer.info()).empty()) return likely;
  const Location location = Locate(observer);
  std::vector<CoverageCounts> seen = observer.Draw(scenes);
  if (observer.HasBrokenOff()) return likely;
  std::vector<Experiment> experiments;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k].size() != 0) experiments.push_back({scenes[k], std::move(seen[k])});
  }
  if (experiments.empty()) return likely;
  const ModelSpace space(location.y_axis, location.culls,
                         WithUsualPatterns(location.patterns, observer.stated().pattern),
                         observer.stated());
  for (const Model& model : NearestModels(observer, space, experiments, most))
    likely.push_back({space.ProfileOf(model), observer.facing()});
  return likely;
}

void DrawAimless(Subject& subject, const InferOptions& options) {
  Observer observer(subject);
  if (!TooLittleRoom(observer.info()).empty()) return;
  AimlessExperiments(observer, options.seed, options.nearest_checks);
}

}  // namespace rasterproof::props
