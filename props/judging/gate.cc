#include "props/judging/gate.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/judging/as_shown.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// A requirement: the reason shown for a subject that lacks it, and its name in tables.
struct Wanted {
  bool (*has)(const Description&);
  std::string_view why_not;
  std::string_view words;
};

// NOLINTNEXTLINE(readability-function-size): a table
Wanted WantedBy(Shows shows) {
  using D = Description;
  switch (shows) {
    case Shows::kCoverage:
      break;
    case Shows::kFacings:
      return {[](const D& d) { return d.info.coverage == CoverageKind::kFacingCounts; },
              "the subject does not report facings", "the subject counts by facing"};
    case Shows::kEdgeValues:
      return {[](const D& d) { return d.edges != nullptr; }, "the subject shows no edge values",
              "the subject shows edge values and states a finite bound there"};
    case Shows::kSteps:
      return {[](const D& d) {
                return d.edges != nullptr &&
                       (!d.info.edges.shows_values || d.info.edges.shows_steps);
              },
              "the subject shows no steps",
              "the subject shows edge values and states a finite bound there"};
    case Shows::kBarycentrics:
      return {[](const D& d) { return d.barycentrics != nullptr; },
              "the subject shows no barycentrics",
              "the subject shows barycentrics and states a finite bound there"};
    case Shows::kFragments:
    case Shows::kDepths:
      return {[](const D& d) { return d.info.coverage == CoverageKind::kFragments; },
              "the subject shows no fragments", "the subject shows fragments"};
    case Shows::kCentroids:
      return {[](const D& d) {
                return d.info.coverage == CoverageKind::kFragments &&
                       d.info.fragments.shows_centroids;
              },
              "the subject shows no centroids", "the subject shows barycentrics at centroids"};
    case Shows::kValues:
      return {[](const D& d) { return d.info.fragments.shows_values; },
              "the subject shows no values", "the subject shows values"};
    case Shows::kDerivatives:
      return {[](const D& d) { return d.info.fragments.shows_derivatives; },
              "the subject shows no derivatives", "the subject shows derivatives of values"};
    case Shows::kPrimitiveIds:
      return {[](const D& d) { return ShowsPrimitiveIds(d.info); },
              "the subject does not show primitive ids", "the subject shows primitive ids"};
    case Shows::kTiles:
      return {[](const D& d) { return d.info.takes_tiles; },
              "the subject's tiles, if any, can't be chosen", "the subject takes a tile size"};
    case Shows::kThreads:
      return {[](const D& d) { return d.info.takes_threads; }, "the subject draws in one thread",
              "the subject takes a number of threads"};
    case Shows::kFloatModes:
      return {[](const D& d) { return d.info.takes_float_modes; },
              "the caller can't set the floating-point mode of the subject",
              "the subject draws in the floating-point mode of its caller"};
    case Shows::kScissor:
      return {[](const D& d) { return d.info.takes_scissor; }, "the subject takes no scissor",
              "the subject takes a scissor"};
    case Shows::kCulling:
      return {[](const D& d) { return d.info.takes_culling; }, "the subject does not cull",
              "the subject culls"};
    case Shows::kBatches:
      return {[](const D& d) { return d.info.takes_batches; }, "the subject takes no batches",
              "the subject takes batches"};
    case Shows::kTwin:
      return {[](const D& d) { return d.has_twin; },
              "the subject can't be made twice: it is no program or plugin",
              "the subject can be made twice"};
  }
  return {[](const D&) { return true; }, "", ""};
}

bool LeavesAChoice(const Profile& profile, const Gate& gate) {
  return !profile.freedom.IsNone() ||
         (!kCountsTies.holds(profile) && !gate.judges_shared_edge_samples);
}

std::optional<std::string> ContractDoesNotState(const Profile& profile, const Gate& gate) {
  if (gate.contract == ContractNeeded::kNone) return std::nullopt;
  if (gate.contract == ContractNeeded::kAny && profile.contract != Contract::kNone)
    return std::nullopt;
  switch (profile.contract) {
    case Contract::kSampleExact:
      if (profile.sample_positions != SamplePositions::kStated && !gate.any_model &&
          gate.contract != ContractNeeded::kWatertight) {
        return "the profile does not state where samples lie";
      }
      if (!LeavesAChoice(profile, gate) || gate.any_model ||
          gate.contract == ContractNeeded::kWatertight) {
        return std::nullopt;
      }
      return profile.freedom.IsNone()
                 ? "the profile does not say how often samples on a shared edge are covered"
                 : "the profile leaves the grid points or the tie rule free";
    case Contract::kWatertight:
      if (gate.contract == ContractNeeded::kWatertight) return std::nullopt;
      return "the profile's contract states watertight meshes only";
    case Contract::kClosed:
      if (gate.contract == ContractNeeded::kClosed) return std::nullopt;
      return "the profile's contract states closed surfaces only";
    case Contract::kAtLeastModel:
    case Contract::kAtMostModel:
      return "the profile's contract states a bound on coverage only";
    case Contract::kSquares:
      return "the profile's contract states what whole pixels show";
    case Contract::kNone:
      break;
  }
  return "the profile's contract states nothing about coverage";
}

// A profile with such a rectangle says nothing about clip space.
bool MayBeClipped(const Gate& gate) {
  return gate.judges_clipped || gate.contract == ContractNeeded::kNone ||
         gate.space == Space::kClip;
}

std::optional<std::string> ProfileDoesNotState(const Gate& gate, const SubjectInfo& info,
                                               const Profile& profile) {
  for (const ProfileRule& rule : gate.rules) {
    if (!rule.holds(profile)) return std::string(rule.why_not);
  }
  const bool is_of_fragments = gate.shows == Shows::kFragments || gate.shows == Shows::kDepths ||
                               gate.shows == Shows::kCentroids;
  if (is_of_fragments && !gate.any_owners && LeavesBarycentricsOpen(info, profile)) {
    return "the profile does not state the grid points that the barycentrics belong to";
  }
  return ContractDoesNotState(profile, gate);
}

std::optional<std::string> SubjectLacks(const Gate& gate, const Description& subject) {
  const Wanted wanted = WantedBy(gate.shows);
  if (!wanted.has(subject)) {
    // A subject that shows no values at all gets that reason.
    const bool no_values = gate.shows == Shows::kSteps && subject.edges == nullptr;
    return std::string(no_values ? WantedBy(Shows::kEdgeValues).why_not : wanted.why_not);
  }
  if (gate.space == Space::kWindow && !subject.info.takes_window) {
    return "the subject takes no window-space scenes";
  }
  if (gate.space == Space::kClip && !subject.info.takes_clip) {
    return "the subject takes no clip-space scenes";
  }
  return std::nullopt;
}

// A snapped profile divides first and snaps then: what it says of w <= 0 depends on clipping.
bool IsInFrontOfTheEye(const Scene& scene) {
  return std::ranges::all_of(scene.vertices, [](const Vertex& v) { return v.w > 0; });
}

// Whether what is judged depends on where the vertices lie.
bool DependsOnPlaces(const Gate& gate) {
  switch (gate.contract) {
    case ContractNeeded::kNone:
    case ContractNeeded::kAny:
      return false;
    case ContractNeeded::kSampleExact:
      return !gate.any_model;
    case ContractNeeded::kWatertight:
    case ContractNeeded::kClosed:
      break;
  }
  return true;
}

std::optional<Verdict> CannotDraw(const Gate& gate, const SubjectInfo& info, const PlacedCase& c) {
  if (gate.space == Space::kWindow && c.scene.clip_space) {
    return Verdict::NotExercised("the case is in clip space");
  }
  if (gate.space == Space::kClip && !c.scene.clip_space) {
    return Verdict::NotExercised("the case is in window space");
  }
  if ((c.options.cull != Cull::kNone && !info.takes_culling) ||
      (c.options.scissor && !info.takes_scissor)) {
    return Verdict::NotExercised("the case needs culling or a scissor that the subject lacks");
  }
  if (c.scene.clip_space && (!PlacesClipSpace(c.profile) || StatesGuardBand(c.profile))) {
    return Verdict::NotExercised(
        "the case is in clip space, but the profile is about window space");
  }
  if (!Takes(info, c.scene)) {
    return Verdict::NotApplicable("the subject does not take scenes of this kind or precision");
  }
  if (c.scene.clip_space && !c.profile.freedom.transform_error && DependsOnPlaces(gate)) {
    return Verdict::NotExercised("the profile states no error of the transform from clip space");
  }
  if (c.scene.clip_space && !c.profile.snap.IsNone() && !IsInFrontOfTheEye(c.scene)) {
    return Verdict::NotExercised("snapped clip space: a vertex is not in front of the eye");
  }
  return std::nullopt;
}

void Add(std::string& words, std::string_view more) {
  if (more.empty()) return;
  if (!words.empty()) words += "; ";
  words += more;
}

std::string_view ContractWords(ContractNeeded contract) {
  switch (contract) {
    case ContractNeeded::kNone:
      break;
    case ContractNeeded::kAny:
      return "any contract but none";
    case ContractNeeded::kClosed:
      return "contract sample-exact or closed";
    case ContractNeeded::kWatertight:
      return "contract sample-exact or watertight";
    case ContractNeeded::kSampleExact:
      return "contract sample-exact";
  }
  return "";
}

}  // namespace

bool LeavesGridPointsOpen(const Profile& profile) {
  return profile.freedom.MovesVertices() || profile.contract == Contract::kWatertight ||
         profile.contract == Contract::kClosed;
}

bool LeavesBarycentricsOpen(const SubjectInfo& info, const Profile& profile) {
  return info.fragments.barycentrics_of == BarycentricsOf::kSnapped &&
         LeavesGridPointsOpen(profile);
}

bool IsShownBy(Shows shows, const Description& subject) { return WantedBy(shows).has(subject); }

std::optional<std::string> WhyBeyond(BoundBy limits, const Scene& scene, const Profile& profile) {
  switch (limits) {
    case BoundBy::kLimits:
      return WhyBeyondLimits(scene, profile);
    case BoundBy::kSizes:
      return WhyTooLarge(scene, profile);
    case BoundBy::kNothing:
      break;
  }
  return std::nullopt;
}

std::optional<std::string> DoesNotApply(const Gate& gate, const Description& subject) {
  if (std::optional<std::string> why = SubjectLacks(gate, subject)) return why;
  const Profile& profile = subject.info.profile;
  // Models by target size are examined for each case.
  return profile.by_target_size.empty() ? ProfileDoesNotState(gate, subject.info, profile)
                                        : ContractDoesNotState(profile, gate);
}

std::optional<Verdict> Refusal(const Gate& gate, const Description& subject, const PlacedCase& c) {
  if (std::optional<std::string> why = SubjectLacks(gate, subject)) {
    return Verdict::NotApplicable(*std::move(why));
  }
  if (std::optional<std::string> why = ProfileDoesNotState(gate, subject.info, c.profile)) {
    return Verdict::NotApplicable(*std::move(why));
  }
  if (std::optional<Verdict> refusal = CannotDraw(gate, subject.info, c)) return refusal;
  if (gate.unwrapped && !IsUnwrapped(c.scene, c.profile)) {
    return Verdict::NotExercised("a coordinate wraps");
  }
  if (gate.needs_facings && IsJudgedAsShown(subject.info, c.scene)) {
    return Verdict::NotExercised(std::string(kJudgedAsShown));
  }
  const bool keeps_limits = gate.bound_by == BoundBy::kLimits;
  if (auto why = keeps_limits ? WhyNotWithinLimits(c.scene, c.profile)
                              : WhyBeyond(gate.bound_by, c.scene, c.profile))
    return Verdict::NotExercised(*std::move(why));
  if (keeps_limits) {
    if (!MayBeClipped(gate) && !c.scene.clip_space && !IsUnclipped(c.scene, c.profile)) {
      return Verdict::NotExercised("a triangle leaves the profile's guard-band rectangle");
    }
  }
  if (!gate.asks_oracle) return std::nullopt;
  const std::optional<InputError> why = exact::WhyNotDecided(c);
  return why ? std::optional(Verdict::NotApplicable(why->what())) : std::nullopt;
}

std::string WordsOf(const Gate& gate) {
  std::string words;
  Add(words, WantedBy(gate.shows).words);
  const bool is_said = std::ranges::any_of(gate.rules, &ProfileRule::names_contract);
  if (!is_said) Add(words, ContractWords(gate.contract));
  if (gate.contract == ContractNeeded::kSampleExact && !gate.any_model) {
    Add(words, "no grid points or tie rule left free");
    const bool counts_ties = std::ranges::any_of(
        gate.rules, [](const ProfileRule& rule) { return rule.words == kCountsTies.words; });
    if (!gate.judges_shared_edge_samples && !counts_ties) Add(words, kCountsTies.words);
  }
  for (const ProfileRule& rule : gate.rules) Add(words, rule.words);
  if (gate.space == Space::kWindow) Add(words, "window space");
  if (gate.space == Space::kClip) Add(words, "clip space");
  if (gate.bound_by == BoundBy::kLimits) Add(words, "coordinates within the limits");
  if (gate.bound_by == BoundBy::kSizes) Add(words, "sizes within the limits");
  if (gate.unwrapped) Add(words, "no coordinate wraps");
  if (gate.bound_by == BoundBy::kLimits && !MayBeClipped(gate))
    Add(words, "no corner outside guard_band");
  if (gate.asks_oracle) Add(words, "a scene that the oracle decides");
  Add(words, gate.where);
  return words.empty() ? "every scene that the subject takes" : words;
}

DrawOptions WholeTarget(const PlacedCase& c) {
  DrawOptions options = c.options;
  options.cull = Cull::kNone;
  options.scissor.reset();
  return options;
}

}  // namespace rasterproof::props
