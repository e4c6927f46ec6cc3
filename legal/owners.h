// Who owns a sample on an edge, `edge_samples` and `tie_ownership` read together.
#ifndef RASTERPROOF_LEGAL_OWNERS_H_
#define RASTERPROOF_LEGAL_OWNERS_H_

#include "core/freedom.h"
#include "core/profile.h"

namespace rasterproof::legal {

/// Returns who owns a sample on an edge. Where triangles may share it, nothing is stated of one.
inline TieOwnership OwnersOfTies(const Profile& profile) {
  return profile.shares_edge_samples ? TieOwnership::kOpen : profile.freedom.ties;
}

/// Returns whether several triangles may cover a sample on an edge that they share: the profile
/// says `edge_samples` may be shared, or its tie rule is inclusive.
inline bool SharesTies(const Profile& profile) {
  return profile.shares_edge_samples || profile.tie_rule.inclusive;
}

/// Returns whether a single tie rule decides every sample on an edge: the profile's, or one that is
/// chosen once for everything.
inline bool HasOneTieRule(const Profile& profile) {
  const TieOwnership owners = OwnersOfTies(profile);
  return owners == TieOwnership::kStated || owners == TieOwnership::kAxisAligned;
}

/// Returns whether the contract states one side of the canonical model, and nothing of the other.
inline bool StatesOneSide(const Profile& profile) {
  const bool is_a_side =
      profile.contract == Contract::kAtLeastModel || profile.contract == Contract::kAtMostModel;
  return is_a_side && profile.freedom.IsNone() && OwnersOfTies(profile) == TieOwnership::kStated;
}

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_OWNERS_H_
