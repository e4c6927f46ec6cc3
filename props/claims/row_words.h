// What several rows of the catalogue say alike.
#ifndef RASTERPROOF_PROPS_CLAIMS_ROW_WORDS_H_
#define RASTERPROOF_PROPS_CLAIMS_ROW_WORDS_H_

#include <string_view>

namespace rasterproof::props {

inline constexpr std::string_view kEdgeValues =
    "the subject shows edge values and claims a finite bound there; window space within the limits";
inline constexpr std::string_view kWeightValues =
    "the subject shows weights and claims a finite bound there; window space within the limits, "
    "area not zero";
inline constexpr std::string_view kFragmentValues =
    "the subject shows fragments; window space within the limits, area not zero";
inline constexpr std::string_view kDepthTolerance =
    "the declared depth error; none declared: the weights' tolerances and 6 u, times the vertices' "
    "depths";
inline constexpr std::string_view kSampleExactOnly =
    "contract sample-exact; coordinates within the limit";
inline constexpr std::string_view kEmbeddedMeshes =
    "contract sample-exact or watertight; a fill rule that owns shared edges (shared ties: at "
    "least once, away from edges once); the snapped mesh has one facing, in clip space as seen "
    "from the eye, and does not overlap itself; where vertices may move away from the outline and "
    "from triangles that a legal choice turns";
inline constexpr std::string_view kSharedEdges =
    "contract sample-exact or watertight; a fill rule that owns shared edges (shared ties: at "
    "least once); two triangles of one facing with an edge in opposite directions; samples to "
    "which no other edge of theirs is nearer";
inline constexpr std::string_view kClippedNeighbours =
    "contract sample-exact or watertight; a fill rule that owns shared edges (shared ties: at "
    "least once); an edge shared in opposite directions by triangles of one facing "
    "of which one leaves the target or passes behind the eye; samples to which no "
    "other edge of theirs is nearer";
inline constexpr std::string_view kInTheTriangle =
    "the subject shows weights and claims a finite bound there; window space within the limits, "
    "area not zero; sample in the closed triangle";
inline constexpr std::string_view kBothBounds = "the sum of both proven ErrorBounds";
inline constexpr std::string_view kOwnBound =
    "the subject's proven ErrorBound; where that is 0, none: exact";
inline constexpr std::string_view kWireframeBound =
    "kWireframeErrorMultiplier and the proven WeightErrorBounds";

inline constexpr std::string_view kWeightBounds = "the subject's proven WeightErrorBounds";
inline constexpr std::string_view kInterpolationBound =
    "the subject's proven InterpolationErrorBound";
inline constexpr std::string_view kWalkBounds = "the subject's proven WalkErrorBounds";
inline constexpr std::string_view kExact = "none: exact";

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CLAIMS_ROW_WORDS_H_
