// Which properties speak for which contract.
#ifndef RASTERPROOF_PROPS_PROPERTIES_CONTRACT_PROPERTIES_H_
#define RASTERPROOF_PROPS_PROPERTIES_CONTRACT_PROPERTIES_H_

#include <array>
#include <span>
#include <string_view>

#include "core/profile.h"

namespace rasterproof::props {

// A subject can hold every other property of the catalogue and still cover nothing as it states:
// that it draws the same twice, or writes nowhere else, is not its contract.

inline constexpr auto kSampleExactProperties = std::to_array<std::string_view>(
    {"CoverageEqualsTheModel", "ClipSpaceCoverageEqualsTheModel", "OneLegalModelExplainsTheMesh",
     "EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
     "SignedCoverageEqualsTheWindingNumber", "NeighboursAreClippedAlike"});
inline constexpr auto kWatertightProperties = std::to_array<std::string_view>(
    {"EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
     "NeighboursAreClippedAlike"});
inline constexpr auto kClosedProperties = std::to_array<std::string_view>(
    {"ClosedMeshCancels", "ClosedSurfaceAroundTheEyeIsSeenEquallyOften"});
inline constexpr auto kSideProperties =
    std::to_array<std::string_view>({"CoverageKeepsToItsSideOfTheModel"});

inline constexpr auto kSquareProperties = std::to_array<std::string_view>(
    {"SquaresThatMustBeAreCovered", "SquaresOutsideTheMayRegionStayFree"});

/// The names of the properties that put the contract to the test; none for the contract `none`.
constexpr std::span<const std::string_view> PropertiesOf(Contract contract) {
  switch (contract) {
    case Contract::kSampleExact:
      return kSampleExactProperties;
    case Contract::kWatertight:
      return kWatertightProperties;
    case Contract::kClosed:
      return kClosedProperties;
    case Contract::kAtLeastModel:
    case Contract::kAtMostModel:
      return kSideProperties;
    case Contract::kSquares:
      return kSquareProperties;
    case Contract::kNone:
      break;
  }
  return {};
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_CONTRACT_PROPERTIES_H_
