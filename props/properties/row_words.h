// What several rows of the catalogue say alike.
#ifndef RASTERPROOF_PROPS_PROPERTIES_ROW_WORDS_H_
#define RASTERPROOF_PROPS_PROPERTIES_ROW_WORDS_H_

#include <span>
#include <string_view>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

// Gates.
inline constexpr Gate kAsksBarycentrics{
    .shows = Shows::kBarycentrics, .contract = ContractNeeded::kNone, .unwrapped = true};
inline constexpr Gate kAsksFragments{.shows = Shows::kFragments,
                                     .contract = ContractNeeded::kNone,
                                     .any_owners = true,
                                     .unwrapped = true};
inline constexpr Gate kAsksDepths{.shows = Shows::kDepths,
                                  .contract = ContractNeeded::kNone,
                                  .any_owners = true,
                                  .unwrapped = true};

inline constexpr Gate kAsksValues{.space = Space::kEither,
                                  .shows = Shows::kValues,
                                  .contract = ContractNeeded::kNone,
                                  .any_owners = true,
                                  .unwrapped = true};

/// The gate of a property about values or derivatives, with its rules and its cases.
constexpr Gate AsksOf(Shows shows, std::span<const ProfileRule> rules, std::string_view where) {
  Gate gate = kAsksValues;
  gate.shows = shows;
  gate.rules = rules;
  gate.where = where;
  return gate;
}

inline constexpr ProfileRule kStatesCentroids{
    [](const Profile& p) {
      return p.centroid == Centroid::kInside ||
             (p.centroid == Centroid::kDirect3D && p.sample_positions == SamplePositions::kStated);
    },
    "centroid inside, or centroid direct3d and stated sample positions",
    "the profile does not state where centroids lie"};

// Where: see Gate.
inline constexpr std::string_view kAreaNotZero = "area not zero";
inline constexpr std::string_view kInTheTriangle = "area not zero; samples in the closed triangle";
inline constexpr std::string_view kTellsMistakes =
    "area not zero; exchanged vertices, or the other plane, would give another number";
inline constexpr std::string_view kTwoTriangles = "two triangles or more";

// Tolerances.
inline constexpr std::string_view kDepthTolerance =
    "the stated depth error; none stated: the barycentrics' tolerances and 6 u, times the "
    "vertices' "
    "depths";
inline constexpr std::string_view kValueTolerance =
    "the stated error; none stated: 16 u times the condition, where every w is 2^-30 to 2^30";
inline constexpr std::string_view kBothBounds = "the sum of both proven ErrorBounds";
inline constexpr std::string_view kOwnBound =
    "the subject's proven ErrorBound; where that is 0, none: exact";
inline constexpr std::string_view kWireframeBound =
    "kWireframeErrorMultiplier and the proven BarycentricErrorBounds";
inline constexpr std::string_view kBarycentricBounds =
    "the subject's proven BarycentricErrorBounds";
inline constexpr std::string_view kInterpolationBound =
    "the subject's proven InterpolationErrorBound";
inline constexpr std::string_view kSteppingBounds = "the subject's proven SteppingErrorBounds";
inline constexpr std::string_view kExact = "none: exact";

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_ROW_WORDS_H_
