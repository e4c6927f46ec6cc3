// What was seen, and what it asks of the legal models of one family.
#ifndef RASTERPROOF_LEGAL_NEEDS_H_
#define RASTERPROOF_LEGAL_NEEDS_H_

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "legal/family_samples.h"
#include "legal/joint.h"

namespace rasterproof::legal {

/// One thing that was seen: the value of a sample, of a triangle alone or of all in one call.
struct Seen {
  static constexpr std::size_t kTogether = SIZE_MAX;

  std::size_t triangle = kTogether;  ///< the one that was drawn alone
  std::size_t sample = 0;            ///< index in counts of the target

  friend auto operator<=>(const Seen&, const Seen&) = default;
};

/// What it asks of one family: so many of these open decisions cover the sample. A primitive id
/// asks for several things.
struct Need {
  Seen seen;
  std::vector<std::size_t> open;  ///< indices in FamilySamples::open
  int least = 0;
  int most = 0;

  bool IsEmpty() const { return least <= 0 && most >= static_cast<int>(open.size()); }
  /// Whether no choice can meet it.
  bool IsImpossible() const {
    return least > static_cast<int>(open.size()) || most < 0 || least > most;
  }
};

/// Returns what a legal model of the family has to explain: every sample that it leaves open, and
/// those that it decides otherwise than they were seen.
///
/// Domain:     `all` holds every sample; or those alone are looked at that it holds.
std::vector<Need> NeedsOf(const FamilySamples& all, const Observed& observed);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_NEEDS_H_
