// Observations, and their requirements on the legal models of one family.
#ifndef RASTERPROOF_LEGAL_NEEDS_H_
#define RASTERPROOF_LEGAL_NEEDS_H_

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "legal/family_samples.h"
#include "legal/joint.h"

namespace rasterproof::legal {

/// One observation: the value of a sample in the draw of one triangle, or of all in one call.
struct Seen {
  static constexpr std::size_t kTogether = SIZE_MAX;

  std::size_t triangle = kTogether;  ///< the one that was drawn alone
  std::size_t sample = 0;            ///< index in counts of the target

  friend auto operator<=>(const Seen&, const Seen&) = default;
};

/// The requirement of an observation on one family: how many of these open decisions cover the
/// sample. A primitive id has several requirements.
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

/// Returns the needs that a legal model of the family has to meet: one for every sample that it
/// leaves open, and one for every sample that it decides differently from the observation.
///
/// Domain:     `all` holds every sample; if not, only the samples it holds are examined.
std::vector<Need> NeedsOf(const FamilySamples& all, const Observed& observed);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_NEEDS_H_
