// The tiers of the fast path: filter, stable, exact. (The symbolic tier is in edge.cc.)
#ifndef RASTERPROOF_EXACT_SIGNS_H_
#define RASTERPROOF_EXACT_SIGNS_H_

#include <cstdint>

#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/filters.h"

namespace rasterproof::exact {

/// A sign and the tier that decided it.
struct TieredSign {
  int sign = 0;
  std::uint64_t TierCounts::* tier = &TierCounts::filter;
};

/// The decisions of this thread since it began; TierScope reads differences of it.
TierCounts& ThreadTiers();

/// Sign of E(a, b; p).
TieredSign FastEdgeSign(Point2 a, Point2 b, Point2 p);

/// Sign of the determinant with the given rows.
TieredSign FastDeterminantSign(const Rows3& rows);

/// Sign of a b - c d, for every finite factor.
int ProductDifferenceSign(double a, double b, double c, double d);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SIGNS_H_
