#include "props/catalog/fragment_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "props/catalog/exact_comparison.h"
#include "props/catalog/fragment_queries.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {

Verdict FragmentDepthStaysInTheHull(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskFragments(subject, c)) return *refusal;
  std::uint64_t exercised = 0;
  for (const Fragment& f : SomeFragments(subject, c)) {
    if (!f.query.inside || !Claims(f.depth_tolerance)) continue;
    ++exercised;
    const auto [low, high] = std::minmax({f.z[0], f.z[1], f.z[2]});
    // The nearest depth of the hull; NaN has none, and is within of nothing.
    const double nearest = std::isfinite(f.depth) ? std::clamp(f.depth, low, high) : low;
    if (CompareWithExact(f.depth, exact::Rational(nearest), f.depth_tolerance).within) continue;
    return FragmentViolation(f, -1, exercised, "the depth of a fragment leaves the hull",
                             HexText(f.depth),
                             "a depth of [" + HexText(low) + ", " + HexText(high) + "] within " +
                                 HexText(f.depth_tolerance));
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
