// Shrinking works on the case's value, so it serves every engine.
#ifndef RASTERPROOF_PROPS_SHRINK_SHRINK_H_
#define RASTERPROOF_PROPS_SHRINK_SHRINK_H_

#include <cstdint>
#include <functional>
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

/// Shrinks greedily: as long as some candidate fails, the boldest of them takes the case's place.
///
/// Domain:     a case for which `fails` is true.
/// Returns:    a failing case of whose candidates none fails, or the smallest one found within
///             `budget` evaluations.
Shrunk Shrink(const Case& failing, const std::function<bool(const Case&)>& fails,
              std::uint64_t budget = 2000);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_SHRINK_SHRINK_H_
