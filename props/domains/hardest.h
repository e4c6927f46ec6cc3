// Hardest cases from number theory: the smallest edge values that a lattice allows.
#ifndef RASTERPROOF_PROPS_DOMAINS_HARDEST_H_
#define RASTERPROOF_PROPS_DOMAINS_HARDEST_H_

#include <cstdint>
#include <optional>

#include "core/vertex.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {

__extension__ using Int128 = __int128;

/// Returns the remainder of x in [0, m).
///
/// Domain:     m > 0.
constexpr Int128 Modulo(Int128 x, Int128 m) {
  const Int128 r = x % m;
  return r < 0 ? r + m : r;
}

/// Returns the least i >= 0 with low <= (a i) mod m <= high, or -1 if there is none below 2^53.
///
/// Domain:     0 <= a < m < 2^72; 0 <= low <= high < m.
/// Cost:       one division per step of Euclid's algorithm on (a, m).
Int128 FirstInRange(Int128 a, Int128 m, Int128 low, Int128 high);

/// Returns the i of [0, n) with the smallest (a i + c) mod m.
///
/// Domain:     0 < m < 2^72; a, c any; 0 < n <= 2^53.
/// Cost:       log2(m) calls of FirstInRange.
Int128 ArgMinModulo(Int128 a, Int128 c, Int128 m, Int128 n);

/// Returns the lattice place near v for which |E(place, q; p)| is smallest but not zero.
///
/// The search runs over every place of v's binade from v on, away from zero, along the axis on
/// which the line through q and p moves less per step.
///
/// Domain:     v, q on the lattice; v not on an axis; v nearly on the line through q and p.
/// Returns:    a place with 0 < E * sign; nothing where the line leaves v's binade at once, or
///             where the numbers need more than 72 bits.
/// Properties: no lattice place of the run searched has a smaller positive E * sign.
std::optional<Point2> HardestVertex(Point2 v, Point2 q, Point2 p, const InputLattice& lattice,
                                    int sign);

/// An integer sample position: pixel (i, j).
struct HardPixel {
  std::int64_t i = 0;
  std::int64_t j = 0;
};

/// Returns the pixel whose sample at `location` has the smallest E(a, b; sample) * sign that is not
/// zero, among those whose column (or row, for a steep edge) meets the edge.
///
/// Domain:     a, b multiples of 2^-24 and within +-2^16; location a multiple of 2^-8.
std::optional<HardPixel> HardestPixel(Point2 a, Point2 b, Point2 location, int sign);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_HARDEST_H_
