// Counters by their names: what adds, writes and reads them goes by one row each.
#ifndef RASTERPROOF_CORE_COUNTERS_H_
#define RASTERPROOF_CORE_COUNTERS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace rasterproof {

/// A counter of T and its name in files.
template <class T>
using Counter = std::pair<std::string_view, std::uint64_t T::*>;
template <class T, std::size_t kCount>
using Counters = std::array<Counter<T>, kCount>;

template <class T, std::size_t kCount>
void AddCounters(const Counters<T, kCount>& counters, const T& more, T& sum) {
  for (const auto& [name, counter] : counters) sum.*counter += more.*counter;
}

/// How often each tier of the oracle's fast path decided.
struct TierCounts {
  std::uint64_t filter = 0;    ///< branch-free floating-point filter
  std::uint64_t stable = 0;    ///< two products compared, and their rounding errors if those tie
  std::uint64_t exact = 0;     ///< wide integers or rationals
  std::uint64_t symbolic = 0;  ///< E == 0: the tie rule's shift decided

  friend bool operator==(const TierCounts&, const TierCounts&) = default;
};
inline constexpr auto kTiers =
    std::to_array<Counter<TierCounts>>({{"filter", &TierCounts::filter},
                                        {"stable", &TierCounts::stable},
                                        {"exact", &TierCounts::exact},
                                        {"symbolic", &TierCounts::symbolic}});

inline TierCounts& operator+=(TierCounts& sum, const TierCounts& more) {
  AddCounters(kTiers, more, sum);
  return sum;
}

/// How near to edges the samples of a run lay, measured on the lattice in use.
struct NearEdgeCounts {
  std::uint64_t samples = 0;  ///< (edge, sample) pairs looked at
  std::uint64_t on_edge = 0;
  std::uint64_t within_1 = 0;  ///< not on the edge, within 1 ulp (or subpixel step) of it
  std::uint64_t within_16 = 0;
  std::uint64_t within_256 = 0;
};
inline constexpr auto kNearEdgeCounters =
    std::to_array<Counter<NearEdgeCounts>>({{"samples", &NearEdgeCounts::samples},
                                            {"on_edge", &NearEdgeCounts::on_edge},
                                            {"within_1", &NearEdgeCounts::within_1},
                                            {"within_16", &NearEdgeCounts::within_16},
                                            {"within_256", &NearEdgeCounts::within_256}});

inline NearEdgeCounts& operator+=(NearEdgeCounts& sum, const NearEdgeCounts& more) {
  AddCounters(kNearEdgeCounters, more, sum);
  return sum;
}

/// Cases that put a property to the test, or would have if they had not been refused.
struct PlaceCounts {
  std::uint64_t asked = 0;
  std::uint64_t refused = 0;
};
inline constexpr auto kPlaceCounters = std::to_array<Counter<PlaceCounts>>(
    {{"asked", &PlaceCounts::asked}, {"refused", &PlaceCounts::refused}});

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_COUNTERS_H_
