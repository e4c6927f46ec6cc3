#include "props/infer/infer.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "core/question.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/infer/declarations.h"
#include "props/infer/locate.h"
#include "props/infer/race.h"
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
Case Shrunken(Observer& observer, const Case& c) {
  constexpr std::uint64_t kBudget = 600;
  const auto differs = [&](const Case& candidate) {
    return !observer.HasBrokenOff() && candidate.options == DrawOptions{} &&
           !candidate.scene.clip_space && candidate.scene.precision == c.scene.precision &&
           WithinLimits(candidate.scene, candidate.profile) &&
           IsUnclipped(candidate.scene, candidate.profile) &&
           Differs(observer, candidate, observer.Draw(candidate.scene));
  };
  return differs(c) ? Shrink(c, differs, kBudget).minimal : c;
}

void NameNearest(Observer& observer, const ModelSpace& space, Race& race, int checks,
                 Inference& inference) {
  race.Check(checks);
  if (observer.HasBrokenOff()) return;
  Model nearest;
  inference.nearest = race.Nearest(&nearest);
  // The profile's limit is the subject's own: what is beyond it is no witness.
  inference.nearest->profile.coordinate_limit = observer.info().profile.coordinate_limit;
  if (const Experiment* against = race.FirstAgainst(nearest)) {
    inference.witness = Shrunken(observer, CaseOf(against->scene, space.ProfileOf(nearest)));
  }
}

void RunRace(Race& race, const InferOptions& options) {
  race.Split();
  if (race.left().empty()) return;
  race.Check(options.checks);
  race.Split();
}

void Conclude(Observer& observer, const ModelSpace& space, const Race& race, Inference& inference) {
  const Profile& declared = observer.declared();
  for (const Model& model : race.left()) {
    inference.remaining.push_back(space.ProfileOf(model));
    inference.remaining.back().coordinate_limit = declared.coordinate_limit;
  }
  inference.declarations = VerifyDeclarations(declared, inference.facing, inference.remaining);
  if (inference.Agrees()) return;
  for (const Experiment& experiment : race.experiments()) {
    const Case c = CaseOf(experiment.scene, declared);
    if (!Differs(observer, c, experiment.seen)) continue;
    inference.against_declared = Shrunken(observer, c);
    break;
  }
}

// Facings can be told from vertices before they are snapped, or by somebody who only believes the
// profile: then the samples alone are explained. Returns whether they are.
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
  inference.message = "facings of some triangles are another matter than their samples: left out";
  Conclude(observer, space, race, inference);
  return true;
}

void FindModels(Observer& observer, const InferOptions& options, Inference& inference) {
  inference.message = TooLittleRoom(observer.info());
  inference.is_inconclusive = !inference.message.empty();
  if (inference.is_inconclusive) return;
  const Location location = Locate(observer);
  if (observer.HasBrokenOff()) return;
  inference.facing = observer.facing();
  const ModelSpace space(location.y_axis, location.lattices, observer.declared());
  inference.models = space.models().size();
  Race race(observer, space, options.seed);
  RunRace(race, options);
  if (observer.HasBrokenOff()) return;
  if (location.complaint.empty()) {
    if (!race.left().empty()) return Conclude(observer, space, race, inference);
    if (ConcludeWithoutFacings(observer, space, options, inference)) return;
  }
  inference.message = location.complaint.empty()
                          ? "each model draws some triangle in another way than the subject"
                          : location.complaint;
  NameNearest(observer, space, race, options.checks, inference);
}

// What was found so far rests on draws that came; what it was about to show does not.
void BreakOff(const Observer& observer, Inference& inference) {
  inference.remaining.clear();
  inference.against_declared.reset();
  inference.witness.reset();
  inference.is_inconclusive =
      observer.stop() == Stop::kTooSlow || observer.stop() == Stop::kDeadline;
  if (inference.is_inconclusive) {
    inference.message = "the subject was too slow to judge: " + observer.why();
    return;
  }
  inference.message = "the subject broke off: " + observer.why();
  inference.witness = CaseOf(observer.last_scene(), observer.info().profile);
}

}  // namespace

bool Inference::Agrees() const {
  return std::ranges::all_of(declarations, &DeclarationVerdict::agrees);
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

}  // namespace rasterproof::props
