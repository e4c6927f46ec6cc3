// Exact coverage of clip-space triangles: no division, defined at w = 0.
#ifndef RASTERPROOF_EXACT_HOMOGENEOUS_H_
#define RASTERPROOF_EXACT_HOMOGENEOUS_H_

#include <array>

#include "core/tie_rule.h"
#include "core/vertex.h"
#include "exact/edge.h"

namespace rasterproof::exact {

/// The sign of N_ij . (p.x, p.y, 1) with N_ij = V_j x V_i over (x, y, w): w_i w_j E(a, b; p) of the
/// projected edge.
///
/// Domain:     every finite double; w of any sign, 0 included.
int HomogeneousEdgeSign(const Vertex& vi, const Vertex& vj, Point2 p,
                        Decider decider = Decider::kFast);
int ShiftedHomogeneousEdgeSign(const Vertex& vi, const Vertex& vj, Point2 p, const TieRule& rule,
                               Decider decider = Decider::kFast);
Rational HomogeneousEdgeValue(const Vertex& vi, const Vertex& vj, Point2 p);

/// Sign of det(V0, V1, V2) over rows (x, y, w). The sign of the projected area is its negative when
/// every w > 0.
int DeterminantSign(const std::array<Vertex, 3>& v, Decider decider = Decider::kFast);

/// Returns whether the ray through p (t > 0) meets the triangle, under the tie rule. No near
/// clipping.
bool HomogeneousCovers(const std::array<Vertex, 3>& v, Point2 p, const TieRule& rule,
                       Decider decider = Decider::kFast);

/// +1 front, -1 back, 0 covers nothing: -DeterminantSign.
int HomogeneousFacing(const std::array<Vertex, 3>& v, Decider decider = Decider::kFast);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_HOMOGENEOUS_H_
