// Whether a property may be judged of a subject, and on a case: as data.
#ifndef RASTERPROOF_PROPS_JUDGING_GATE_H_
#define RASTERPROOF_PROPS_JUDGING_GATE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/evaluators.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The description of a subject that properties see, before any question.
///
/// The bounds are statements, not measurements: pure functions of the question.
struct Description {
  SubjectInfo info;
  const EdgeBounds* edges = nullptr;                ///< of its edge values; nullptr: it shows none
  const BarycentricBounds* barycentrics = nullptr;  ///< of its barycentrics; nullptr: it shows none
  bool has_twin = false;                            ///< it can be made twice: Subject::Twin
};

enum class Space : std::uint8_t { kWindow, kClip, kEither };

/// What a subject must show, or take as an option.
enum class Shows : std::uint8_t {
  kCoverage,  ///< every subject does
  kFacings,   ///< counts by facing
  kEdgeValues,
  kSteps,
  kBarycentrics,
  kFragments,    ///< barycentrics, of vertices that are given, or that the profile places
  kDepths,       ///< of such fragments
  kCentroids,    ///< of such fragments
  kValues,       ///< of channels
  kDerivatives,  ///< of values
  kPrimitiveIds,
  kTiles,
  kThreads,
  kFloatModes,
  kScissor,
  kCulling,
  kBatches,
  kTwin  ///< it can be made twice
};

/// The weakest contract about coverage that the property follows from.
enum class ContractNeeded : std::uint8_t {
  kNone,        ///< the property is not about the coverage that a contract states
  kAny,         ///< every contract but `none`
  kClosed,      ///< `closed` or `sample-exact`
  kWatertight,  ///< `watertight` or `sample-exact`, whichever grid points and tie rule are chosen
  kSampleExact
};

/// Which limits of the profile bind a property.
enum class BoundBy : std::uint8_t {
  kLimits,  ///< all
  kSizes,   ///< those of sizes: it also holds of coordinates beyond, and of what is not finite
  kNothing  ///< none: it holds of whatever is drawn
};

/// Something that the profile must say.
struct ProfileRule {
  bool (*holds)(const Profile&);
  std::string_view words;       ///< completes "the profile ...": "owns shared edges"
  std::string_view why_not;     ///< a sentence, for where it does not hold
  bool names_contract = false;  ///< the words say what the gate's contract would
};

/// The conditions under which a property may be judged.
struct Gate {
  Space space = Space::kWindow;
  Shows shows = Shows::kCoverage;
  ContractNeeded contract = ContractNeeded::kSampleExact;
  /// True for a property that every legal model has, whichever one the subject chose.
  bool any_model = false;
  /// True for a property of fragments that holds for any legal grid points of their barycentrics.
  bool any_owners = false;
  /// True if the property separates samples that the profile's edge_samples leaves open.
  bool judges_shared_edge_samples = false;
  /// True for a property that holds even if clipping has moved the edges of triangles that leave
  /// the profile's guard-band rectangle.
  bool judges_clipped = false;
  /// True for a property that also holds for triangles of zero area with unspecified coverage: they
  /// too must not crash the subject or write outside the target.
  bool judges_degenerates = false;
  /// A case is not exercised that exceeds these limits, or of which the property would draw a scene
  /// that does; but see Check::may_be_refused.
  BoundBy bound_by = BoundBy::kLimits;
  /// True for a property that is not stated where a coordinate wraps.
  bool unwrapped = false;
  /// True for a property that needs counts by facing: a mesh that is judged as the subject shows it
  /// has none (judging/as_shown.h).
  bool needs_facings = false;
  std::span<const ProfileRule> rules = {};
  /// True for a property that compares with the oracle's coverage of the case's scene.
  bool asks_oracle = false;
  /// The part of an admitted case that the property is about, in words, if not all cases:
  /// "two triangles or more". The property's `ask` checks it.
  std::string_view where = {};
};

/// Returns the gate with the words of a property that is about fewer cases.
constexpr Gate Where(Gate gate, std::string_view where) {
  gate.where = where;
  return gate;
}

/// Whether legal models of the profile put a vertex on different grid points.
bool LeavesGridPointsOpen(const Profile& profile);
/// Whether the subject says that the barycentrics of its fragments belong to grid points, and the
/// profile leaves these free.
bool LeavesBarycentricsOpen(const SubjectInfo& info, const Profile& profile);

/// Returns whether the subject shows this, or takes it as an option.
bool IsShownBy(Shows shows, const Description& subject);

/// Returns which of these limits the scene exceeds, as a clause that names its key, or nothing.
std::optional<std::string> WhyBeyond(BoundBy limits, const Scene& scene, const Profile& profile);

/// Returns why the property does not apply to the subject, whatever the case, or nothing if it may.
///
/// Domain:     the profile that the subject is judged by. Where it states models by target size,
///             the gate's rules are asked for each case, the contract now.
std::optional<std::string> DoesNotApply(const Gate& gate, const Description& subject);

/// Returns the verdict to give instead of judging, or nothing if the property may be judged.
///
/// Not applicable: as DoesNotApply; the subject does not take scenes of this kind or precision; or
///                 the oracle is asked and does not decide the scene.
/// Not exercised:  the case is of the other space; it culls or has a scissor, which the subject
///                 does not take; it is of clip space, under a snapped profile, and not wholly in
///                 front of the eye; the profile has keys that speak of window space alone;
///                 it exceeds the limits, is not finite, or wraps; a triangle leaves the profile's
///                 guard-band rectangle; the property needs facings, and the mesh is judged as it
///                 is shown.
std::optional<Verdict> Refusal(const Gate& gate, const Description& subject, const PlacedCase& c);

/// Returns the conditions of DoesNotApply and Refusal in words, and `where`, as `rasterproof list`
/// prints them.
std::string WordsOf(const Gate& gate);

/// The case's drawing options without culling and scissor.
DrawOptions WholeTarget(const PlacedCase& c);

// Rules that several properties have.
inline constexpr ProfileRule kOwnsEdges{
    [](const Profile& p) { return p.tie_rule.IsConsistent(); },
    "a tie rule that gives each sample of a shared edge to one side",
    "the tie rule does not give each sample of a shared edge to one side"};
inline constexpr ProfileRule kClosesEdges{
    [](const Profile& p) { return p.tie_rule.IsConsistent() || !p.tie_rule.exclusive; },
    "a tie rule that owns shared edges", "an exclusive tie rule never covers shared edges"};
inline constexpr ProfileRule kCountsTies{
    [](const Profile& p) { return !p.shares_edge_samples; }, "no shared ties",
    "the profile does not say how often samples on a shared edge are covered"};
inline constexpr ProfileRule kStatesSamplePositions{
    [](const Profile& p) { return p.sample_positions == SamplePositions::kStated; },
    "stated sample positions", "the profile does not state where samples lie"};
inline constexpr ProfileRule kFixesSamplePositions{
    [](const Profile& p) { return p.sample_positions != SamplePositions::kVary; },
    "sample positions that are the same in every pixel",
    "sample positions may differ between pixels"};
inline constexpr ProfileRule kDrawsBothFacings{
    [](const Profile& p) { return p.culls == Cull::kNone; }, "no side that is always culled",
    "the profile always culls one side"};
inline constexpr ProfileRule kSaysWhatSinglesCover{
    [](const Profile& p) { return p.contract == Contract::kSampleExact; }, "contract sample-exact",
    "the profile's contract does not say what single triangles cover", true};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_GATE_H_
