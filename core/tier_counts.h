// Which tier of the oracle decided how often.
#ifndef RASTERPROOF_CORE_TIER_COUNTS_H_
#define RASTERPROOF_CORE_TIER_COUNTS_H_

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace rasterproof {

/// How often each tier of the oracle's fast path decided.
struct TierCounts {
  std::uint64_t filter = 0;    ///< branch-free floating-point filter
  std::uint64_t stable = 0;    ///< two products compared, and their rounding errors if those tie
  std::uint64_t exact = 0;     ///< wide integers or rationals
  std::uint64_t symbolic = 0;  ///< E == 0: the tie rule's shift decided

  TierCounts& operator+=(const TierCounts& more) {
    filter += more.filter;
    stable += more.stable;
    exact += more.exact;
    symbolic += more.symbolic;
    return *this;
  }
  friend bool operator==(const TierCounts&, const TierCounts&) = default;
};

/// The tiers by their names, in the order that certificates have them.
inline constexpr std::array<std::pair<std::string_view, std::uint64_t TierCounts::*>, 4> kTiers{
    {{"exact", &TierCounts::exact},
     {"filter", &TierCounts::filter},
     {"stable", &TierCounts::stable},
     {"symbolic", &TierCounts::symbolic}}};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TIER_COUNTS_H_
