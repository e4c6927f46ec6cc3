// Contracts without which a domain is useless.
#ifndef RASTERPROOF_PROPS_DOMAINS_IS_STATED_H_
#define RASTERPROOF_PROPS_DOMAINS_IS_STATED_H_

#include "core/profile.h"

namespace rasterproof::props {

/// Returns whether legal models put a vertex elsewhere.
inline bool LeavesGridPoints(const Profile& profile) {
  return profile.freedom.MovesVertices() || profile.contract == Contract::kWatertight ||
         profile.contract == Contract::kClosed;
}

/// Returns whether coordinates lie between the grid's points.
inline bool SnapsItsInput(const Profile& profile) {
  const Snap& snap = profile.snap;
  return !snap.IsNone() && (!profile.fixed || profile.fixed->fraction_bits > snap.bits);
}

inline bool StatesSquares(const Profile& profile) { return profile.squares.has_value(); }

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_IS_STATED_H_
