// What the derivatives of a value may be.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_DERIVATIVE_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_DERIVATIVE_QUERIES_H_

#include <array>
#include <vector>

#include "core/channel.h"
#include "core/value_rule.h"
#include "core/verdict.h"
#include "core/vertex.h"
#include "props/judging/values/value_queries.h"

namespace rasterproof::props {

inline constexpr Outputs kValuesAndDerivatives{.primitive_ids = true,
                                               .barycentrics = false,
                                               .depths = false,
                                               .centroids = false,
                                               .values = true,
                                               .derivatives = true};

/// p, moved along x (axis 0) or y (1).
inline Point2 Moved(Point2 p, int axis, double by) {
  return axis == 0 ? Point2{p.x + by, p.y} : Point2{p.x, p.y + by};
}

/// The ends of the differences that a derivative at `p` may be, by x (axis 0) or y (1); equal ends
/// are the plane's own derivative there. Without a stated alignment of quads a difference may be
/// that to the next pixel or from the one before; a coarse one that of the row (column) beside it.
std::vector<std::array<Point2, 2>> DerivativeEnds(const ValueRule& rule, Point2 p, int axis);

struct DerivativeCheck {
  bool is_judged = false;
  bool holds = true;
  /// Whether the derivative with the other sign, by the other axis, or twice as large would not
  /// hold.
  bool tells = false;
  double nearest = 0;    ///< of the numbers that it may be
  double tolerance = 0;  ///< about that one
  double ratio = 0;      ///< of the distance from it to the tolerance
  WitnessValue expected = {};
};

/// Holds a derivative by x (axis 0) or y (1) to the ways in which the rule lets it be computed:
/// those of DerivativeEnds().
///
/// Domain:     an interpolation other than kFlat. Not judged: owners that are not known.
DerivativeCheck CheckDerivative(const ShownValues& shown, const ValueFragment& f,
                                const ValueOwners& owners, const Channel& channel, int axis,
                                double x);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_DERIVATIVE_QUERIES_H_
