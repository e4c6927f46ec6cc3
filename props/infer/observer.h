// Asks a subject for draws and records them in one form for all kinds of subjects.
#ifndef RASTERPROOF_PROPS_INFER_OBSERVER_H_
#define RASTERPROOF_PROPS_INFER_OBSERVER_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/question.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "model/target_profile.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The meaning of the facings in a subject's counts.
enum class FacingReport : std::uint8_t {
  kAsOnScreen,  ///< front is counter-clockwise on screen
  kReversed,    ///< front is clockwise on screen
  kNotTold      ///< all counts are in one place
};

/// The side, in pixels, of a target that has the model of all experiments.
inline constexpr int kSmallTarget = 8;

/// Draws scenes with a subject until it breaks off: from then on every target stays empty, and no
/// conclusion from it counts.
class Observer {
 public:
  explicit Observer(Subject& subject);

  /// The subject's counts for a window-space scene, as they come.
  CoverageCounts Raw(const Scene& scene);
  /// The same in the form of Expected() for exact draws: facings as on screen, or all in front.
  CoverageCounts Draw(const Scene& scene) { return Normal(Raw(scene)); }
  /// The counts of several scenes, in as few calls as the subject allows; for a refused scene,
  /// counts of no samples. Fewer if it breaks off.
  std::vector<CoverageCounts> Draw(std::span<const Scene> scenes);
  CoverageCounts Expected(CoverageCounts exact) const;

  void SetFacing(FacingReport facing) { facing_ = facing; }
  FacingReport facing() const { return facing_; }
  /// The side that the subject never draws.
  void SetCulls(Cull side, YAxis y_axis);
  /// The window-space scene with the triangles of that side turned over.
  Scene Turned(Scene scene) const;
  /// Whether the subject itself reports facings, so that none need be computed.
  bool TellsFacings() const { return info().coverage == CoverageKind::kFacingCounts; }
  const SubjectInfo& info() const { return subject_.Info(); }
  /// The stated profile, as it is on the small targets of all experiments.
  const TargetProfile& stated() const { return stated_; }
  /// The scene with its vertices moved to places that the subject takes: on the integers of a
  /// fixed-point input, within the stated limit; of one with a viewport of its own to where that
  /// takes a vertex, on a target whose sides are powers of two. Nothing if it still breaks a limit
  /// on the scenes that are judged.
  std::optional<Scene> Given(const Scene& scene) const;
  std::uint64_t draws() const { return draws_; }
  /// The last question to the subject.
  const Scene& last_scene() const { return last_scene_; }
  bool HasBrokenOff() const { return end_.stop != Stop::kNone; }
  const CallEnd& end() const { return end_; }

 private:
  // In the space that the subject takes.
  Scene AsGiven(const Scene& scene) const;
  bool OwnsViewport() const;
  Vertex InClipSpace(const Vertex& v, const Scene& scene) const;
  bool MoveToWhereItsViewportTakes(Vertex& v, const Scene& scene) const;
  std::vector<CoverageCounts> Ask(std::span<const Scene> scenes, bool may_refuse);
  CoverageCounts Normal(CoverageCounts counts) const;

  Subject& subject_;
  PlacedCase placed_;  ///< whose draws are asked for
  TargetProfile stated_;
  FacingReport facing_ = FacingReport::kNotTold;
  Profile sides_;  ///< states the y axis and the side that is never drawn
  std::uint64_t draws_ = 0;
  Scene last_scene_;
  CallEnd end_;
};

/// Adds the back counts to the front ones.
void JoinFacings(CoverageCounts& counts);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_OBSERVER_H_
