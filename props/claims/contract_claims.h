// Which claims speak for which contract.
#ifndef RASTERPROOF_PROPS_CLAIMS_CONTRACT_CLAIMS_H_
#define RASTERPROOF_PROPS_CLAIMS_CONTRACT_CLAIMS_H_

#include <array>
#include <span>
#include <string_view>

#include "core/profile.h"

namespace rasterproof::props {

// A subject can hold every other claim of the catalogue and still cover nothing as it promises:
// that it draws the same twice, or writes nowhere else, is not its contract.

inline constexpr auto kSampleExactClaims = std::to_array<std::string_view>(
    {"CoverageEqualsTheModel", "ClipSpaceCoverageEqualsTheModel", "OneLegalModelExplainsTheMesh",
     "EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
     "SignedCoverageEqualsTheWindingNumber", "NeighboursAreClippedAlike"});
inline constexpr auto kWatertightClaims = std::to_array<std::string_view>(
    {"EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
     "NeighboursAreClippedAlike"});
inline constexpr auto kClosedClaims = std::to_array<std::string_view>(
    {"ClosedMeshCancels", "ClosedSurfaceAroundTheEyeIsSeenEquallyOften"});
inline constexpr auto kConservativeClaims =
    std::to_array<std::string_view>({"ConservativeCoverageKeepsToItsSide"});

/// The names of the properties that put the contract to the test; none for the contract `none`.
constexpr std::span<const std::string_view> ClaimsOf(Contract contract) {
  switch (contract) {
    case Contract::kSampleExact:
      return kSampleExactClaims;
    case Contract::kWatertight:
      return kWatertightClaims;
    case Contract::kClosed:
      return kClosedClaims;
    case Contract::kConservativeOver:
    case Contract::kConservativeUnder:
      return kConservativeClaims;
    case Contract::kNone:
      break;
  }
  return {};
}

/// As a profile's `contract` key spells it.
constexpr std::string_view ContractName(Contract contract) {
  switch (contract) {
    case Contract::kSampleExact:
      return "sample-exact";
    case Contract::kWatertight:
      return "watertight";
    case Contract::kClosed:
      return "closed";
    case Contract::kConservativeOver:
      return "conservative-over";
    case Contract::kConservativeUnder:
      return "conservative-under";
    case Contract::kNone:
      break;
  }
  return "none";
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CLAIMS_CONTRACT_CLAIMS_H_
