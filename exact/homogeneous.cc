#include "exact/homogeneous.h"

#include <array>

#include "core/tie_rule.h"
#include "core/vertex.h"
#include "exact/deciders.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "exact/signs.h"
#include "exact/tie.h"

namespace rasterproof::exact {
namespace {

std::array<double, 3> Row(const Vertex& v) { return {v.x, v.y, v.w}; }

int Count(TieredSign decided) {
  ++(ThreadTiers().*decided.tier);
  return decided.sign;
}

int SignOf(const Rows3& rows, Decider decider) {
  if (decider == Decider::kIntegers) return IntegerDeterminantSign(rows);
  if (decider == Decider::kCgal) return CgalDeterminantSign(rows);
  return Count(FastDeterminantSign(rows));
}

// N . (p, 1) = det(p1, V_j, V_i): expanded along the sample's row, whose factors are the normal's
// components.
Rows3 EdgeRows(const Vertex& vi, const Vertex& vj, Point2 p) {
  return {{{p.x, p.y, 1}, Row(vj), Row(vi)}};
}

}  // namespace

int HomogeneousEdgeSign(const Vertex& vi, const Vertex& vj, Point2 p, Decider decider) {
  return SignOf(EdgeRows(vi, vj, p), decider);
}

int ShiftedHomogeneousEdgeSign(const Vertex& vi, const Vertex& vj, Point2 p, const TieRule& rule,
                               Decider decider) {
  // N_x = y_j w_i - w_j y_i and N_y = w_j x_i - x_j w_i. Each backend gets their signs from its own
  // planar edge function: seen from the origin that is the same 2x2 determinant.
  const auto cross_sign = [&](double a, double b, double c, double d) {
    if (decider == Decider::kFast) return ProductDifferenceSign(a, b, c, d);
    return EdgeSign({0, 0}, {c, b}, {a, d}, decider);
  };
  const auto tie = [&] {
    return TieSign(cross_sign(vj.y, vi.w, vj.w, vi.y), cross_sign(vj.w, vi.x, vj.x, vi.w), rule);
  };
  if (decider != Decider::kFast) {
    const int sign = HomogeneousEdgeSign(vi, vj, p, decider);
    return sign != 0 ? sign : tie();
  }
  const TieredSign decided = FastDeterminantSign(EdgeRows(vi, vj, p));
  ++(ThreadTiers().*(decided.sign != 0 ? decided.tier : &TierCounts::symbolic));
  return decided.sign != 0 ? decided.sign : tie();
}

Rational HomogeneousEdgeValue(const Vertex& vi, const Vertex& vj, Point2 p) {
  const auto cross = [](double a, double b, double c, double d) {
    return Rational(a) * b - Rational(c) * d;
  };
  return cross(vj.y, vi.w, vj.w, vi.y) * p.x + cross(vj.w, vi.x, vj.x, vi.w) * p.y +
         cross(vj.x, vi.y, vj.y, vi.x);
}

int DeterminantSign(const std::array<Vertex, 3>& v, Decider decider) {
  return SignOf({Row(v[0]), Row(v[1]), Row(v[2])}, decider);
}

int HomogeneousFacing(const std::array<Vertex, 3>& v, Decider decider) {
  return -DeterminantSign(v, decider);
}

bool HomogeneousCovers(const std::array<Vertex, 3>& v, Point2 p, const TieRule& rule,
                       Decider decider) {
  // The ray through p meets the triangle at t > 0 iff p = sum c_k V_k with all c_k >= 0. By Cramer
  // N_ij . p = -c_k det: compared with the sign of the facing, not of w.
  const int facing = HomogeneousFacing(v, decider);
  if (facing == 0) return false;
  for (unsigned k = 0; k < 3; ++k) {
    const int side = facing * ShiftedHomogeneousEdgeSign(v[k], v[(k + 1) % 3], p, rule, decider);
    if (side < 0 || (side == 0 && !rule.inclusive)) return false;
  }
  return true;
}

}  // namespace rasterproof::exact
