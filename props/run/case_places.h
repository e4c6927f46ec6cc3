// What a case was drawn for, as its scene shows it: the places where rasterizers differ.
#ifndef RASTERPROOF_PROPS_RUN_CASE_PLACES_H_
#define RASTERPROOF_PROPS_RUN_CASE_PLACES_H_

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "core/case.h"
#include "core/result.h"

namespace rasterproof::props {

/// In the order of their words, kCasePlaces.
enum class CasePlace : std::uint8_t {
  kTieOnHorizontalEdge,
  kTieOnVerticalEdge,
  kTieOnSlantedEdge,
  kTieOnSharedEdge,
  kVertexOnASample,
  kFlatTriangle,
  kOffTarget,
  kPositiveArea,
  kNegativeArea,
  kClipped
};

using CasePlaces = std::bitset<kKindsOfPlaces>;

constexpr std::size_t IndexOf(CasePlace place) { return static_cast<std::size_t>(place); }

/// What is seen of a case without drawing it.
struct CaseEvidence {
  NearEdgeCounts near_edge;
  CasePlaces places;
};

/// As CountNearEdges of near_edge.h, with the places. Samples count as on an edge between its ends,
/// and on the target; an edge is shared if another triangle of the case has it by its whole length.
/// The sign of an area is that of the scene's axes, y down; behind the eye it is that of the part
/// in front. In clip space without a snap vertices are taken from quotients in long double.
CaseEvidence EvidenceOfCase(const Case& c);

/// Of fewer cases at a place it says nothing that all were refused: a subject that refuses any half
/// of all cases refuses 16 given ones once in 65,536 times.
inline constexpr std::uint64_t kFewestCasesAtAPlace = 16;

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CASE_PLACES_H_
