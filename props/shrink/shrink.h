// Shrinking works on the case's value, so it serves every engine.
#ifndef RASTERPROOF_PROPS_SHRINK_SHRINK_H_
#define RASTERPROOF_PROPS_SHRINK_SHRINK_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/case.h"

namespace rasterproof::props {

/// Smaller cases to try, boldest first: fewer triangles, smaller target, default options, whole
/// pixels, shorter mantissas, powers of two, zeros. Every candidate is a valid case and strictly
/// simpler in a well-founded order.
std::vector<Case> ShrinkCandidates(const Case& c);

struct Shrunk {
  Case minimal;                   ///< it fails
  std::uint64_t evaluations = 0;  ///< calls of `fails`
};

/// Whether a candidate fails; nothing: shrinking ends here.
using FailsOrEnd = std::function<std::optional<bool>(const Case&)>;

/// Shrinks greedily: as long as some candidate fails, the boldest of them takes the case's place.
///
/// Domain:     a case for which `fails` is true.
/// Returns:    a failing case of whose candidates none fails, or the smallest one found within
///             `budget` evaluations and before `fails` ended it.
Shrunk Shrink(const Case& failing, const FailsOrEnd& fails, std::uint64_t budget = 2000);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_SHRINK_SHRINK_H_
