#include "props/infer/observer.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>
#include <utility>

#include "exact/placed_scene.h"
#include "model/snap_scene.h"
#include "model/transform.h"
#include "props/domains/input_lattice.h"
#include "props/judging/redraw.h"
#include "props/property.h"
#include "props/run/submit.h"

namespace rasterproof::props {

Observer::Observer(Subject& subject)
    : subject_(subject),
      placed_(Case{{}, subject.Info().profile, {}, {}}),
      stated_(subject.Info().profile, kSmallTarget, kSmallTarget) {
  // Where it is not stated what is clipped, experiments reach beyond the target all the same: what
  // a model explains of the answers is believed.
  if (!StatesGuardBand(stated_)) stated_.guard_band.reset();
}

// A window-space vertex in clip space, as near as the subject's input takes it.
Vertex Observer::InClipSpace(const Vertex& v, const Scene& scene) const {
  Vertex clip = ToClip(v, 1, *info().profile.transform, scene.width, scene.height);
  if (info().input == Precision::kFloat64) return clip;
  clip.x = static_cast<float>(clip.x);
  clip.y = static_cast<float>(clip.y);
  return clip;
}

Scene Observer::AsGiven(const Scene& scene) const {
  Scene given = scene;
  given.clip_space = !info().takes_window;
  if (!OwnsViewport()) return given;  // w is 1 already
  for (Vertex& v : given.vertices) v = InClipSpace(v, scene);
  given.precision = info().input;
  return given;
}

bool Observer::OwnsViewport() const {
  const auto& transform = info().profile.transform;
  return !info().takes_window && transform && transform->viewport != ViewportForm::kNone;
}

// The subject's own viewport takes it back to just there.
bool Observer::MoveToWhereItsViewportTakes(Vertex& v, const Scene& scene) const {
  const auto taken = [&](const Vertex& place) {
    return ToWindow(InClipSpace(place, scene), *info().profile.transform, scene.width,
                    scene.height);
  };
  const Vertex place = taken(v);
  v.x = place.x;
  v.y = place.y;
  const Vertex again = taken(v);
  return again.x == v.x && again.y == v.y;
}

std::vector<CoverageCounts> Observer::Ask(std::span<const Scene> scenes, bool may_refuse) {
  std::vector<CoverageCounts> seen;
  if (HasBrokenOff()) return seen;
  std::vector<Check> checks(scenes.size());
  std::vector<Request> requests;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    checks[k].questions.draws = {CountsOf(AsGiven(scenes[k]), info().profile, {})};
    requests.push_back({&placed_, &checks[k], nullptr});
  }
  for (Answers& answers : Submit(subject_, requests)) {
    ++draws_;
    last_scene_ = scenes[seen.size()];
    if (may_refuse && answers.end.stop == Stop::kRefused) {
      seen.emplace_back();
      continue;
    }
    end_ = std::move(answers.end);
    if (HasBrokenOff()) break;
    seen.push_back(answers.draws.front()->counts);
  }
  return seen;
}

CoverageCounts Observer::Raw(const Scene& scene) {
  std::vector<CoverageCounts> seen = Ask({&scene, 1}, false);
  if (!seen.empty()) return std::move(seen.front());
  return {scene.width, scene.height, info().profile.pattern.samples()};
}

std::vector<CoverageCounts> Observer::Draw(std::span<const Scene> scenes) {
  std::vector<CoverageCounts> counts;
  for (CoverageCounts& seen : Ask(scenes, true)) counts.push_back(Normal(std::move(seen)));
  return counts;
}

void Observer::SetCulls(Cull side, YAxis y_axis) {
  sides_.culls = side;
  sides_.y_axis = y_axis;
}

Scene Observer::Turned(Scene scene) const {
  const exact::PlacedScene placed(scene, sides_);
  for (const std::size_t t : placed.culled) std::swap(scene.triangles[t][1], scene.triangles[t][2]);
  return scene;
}

std::optional<Scene> Observer::Given(const Scene& scene) const {
  // This is where the subject may take a vertex, not where its own grid may put it.
  Profile ungridded = stated_;
  ungridded.snap = {};
  Scene given = scene;
  if (stated_.fixed) given.precision = PrecisionOf(*stated_.fixed);
  const InputLattice lattice(ungridded, given.precision);
  for (Vertex& v : given.vertices) {
    v.x = lattice.RoundWithinLimit(v.x);
    v.y = lattice.RoundWithinLimit(v.y);
  }
  if (OwnsViewport()) {
    // Halves of these are powers of two, by which most products are exact.
    given.width = static_cast<int>(std::bit_ceil(static_cast<unsigned>(given.width)));
    given.height = static_cast<int>(std::bit_ceil(static_cast<unsigned>(given.height)));
    for (Vertex& v : given.vertices) {
      if (!MoveToWhereItsViewportTakes(v, given)) return std::nullopt;
    }
  }
  return IsUnclipped(given, stated_) ? std::optional(given) : std::nullopt;
}

CoverageCounts Observer::Normal(CoverageCounts counts) const {
  if (facing_ == FacingReport::kReversed) std::swap(counts.front, counts.back);
  if (facing_ == FacingReport::kNotTold) JoinFacings(counts);
  return counts;
}

CoverageCounts Observer::Expected(CoverageCounts exact) const {
  if (facing_ == FacingReport::kNotTold) JoinFacings(exact);
  return exact;
}

void JoinFacings(CoverageCounts& counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) counts.front[k] += counts.back[k];
  std::ranges::fill(counts.back, 0U);
}

}  // namespace rasterproof::props
