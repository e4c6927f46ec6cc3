#include "tests/model/second_definition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterproof::second {
namespace {

using Kind = Value::Kind;

const Value kNaN{Kind::kNaN, false, 0};

mpz_class Floor(const mpq_class& v) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), v.get_num_mpz_t(), v.get_den_mpz_t());
  return whole;
}

bool IsEven(const mpz_class& n) { return mpz_even_p(n.get_mpz_t()) != 0; }

// The e for which 2^e <= v < 2^(e + 1), v > 0.
int ExponentOf(const mpq_class& v) {
  int e = static_cast<int>(mpz_sizeinbase(v.get_num_mpz_t(), 2)) -
          static_cast<int>(mpz_sizeinbase(v.get_den_mpz_t(), 2));
  while (v < TwoTo(e)) --e;
  while (v >= TwoTo(e + 1)) ++e;
  return e;
}

}  // namespace

mpq_class TwoTo(int exponent) {
  mpq_class power(1);
  if (exponent >= 0) {
    mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return power;
}

Value FromDouble(double x) {
  if (std::isnan(x)) return kNaN;
  if (std::isinf(x)) return {Kind::kInfinite, x < 0, 0};
  return {Kind::kFinite, std::signbit(x), mpq_class(x)};
}

bool IsSame(const Value& value, double x) {
  const Value other = FromDouble(x);
  if (value.kind != other.kind) return false;
  return value.kind == Kind::kNaN ||
         (value.negative == other.negative && value.number == other.number);
}

Value Negated(Value a) {
  a.negative = !a.negative;
  a.number = -a.number;
  return a;
}

Value Product(const Value& a, const Value& b) {
  const bool negative = a.negative != b.negative;
  if (a.kind == Kind::kNaN || b.kind == Kind::kNaN) return kNaN;
  if (a.kind == Kind::kFinite && b.kind == Kind::kFinite) {
    return {Kind::kFinite, negative, a.number * b.number};
  }
  return a.IsZero() || b.IsZero() ? kNaN : Value{Kind::kInfinite, negative, 0};
}

Value Quotient(const Value& a, const Value& b) {
  const bool negative = a.negative != b.negative;
  if (b.kind == Kind::kInfinite) {
    return a.kind == Kind::kFinite ? Value{Kind::kFinite, negative, 0} : kNaN;
  }
  if (b.IsZero()) {
    return a.kind == Kind::kNaN || a.IsZero() ? kNaN : Value{Kind::kInfinite, negative, 0};
  }
  return b.kind == Kind::kNaN ? kNaN
                              : Product(a, {Kind::kFinite, b.negative, mpq_class(1) / b.number});
}

Value Sum(const Value& a, const Value& b) {
  if (a.kind == Kind::kNaN || b.kind == Kind::kNaN) return kNaN;
  if (a.kind == Kind::kInfinite && b.kind == Kind::kInfinite) {
    return a.negative == b.negative ? a : kNaN;
  }
  if (a.kind == Kind::kInfinite) return a;
  if (b.kind == Kind::kInfinite) return b;
  const mpq_class sum = a.number + b.number;
  // A sum that is zero is -0 if both numbers are.
  return {Kind::kFinite, sum < 0 || (sum == 0 && a.negative && b.negative), sum};
}

Value Rounded(const Value& exact, const Format& format) {
  if (exact.kind != Kind::kFinite || exact.IsZero()) return exact;
  const mpq_class size = abs(exact.number);
  const mpq_class unit = TwoTo(std::max(ExponentOf(size) - format.digits + 1, format.least));
  const mpq_class nearest = WholeByRule(size / unit, SnapRule::kNearestEven) * unit;
  if (nearest >= TwoTo(format.beyond)) return {Kind::kInfinite, exact.negative, 0};
  return {Kind::kFinite, exact.negative, exact.negative ? mpq_class(-nearest) : nearest};
}

mpz_class WholeByRule(const mpq_class& v, SnapRule rule) {
  const mpz_class below = Floor(v);
  const mpz_class above = below + 1;
  const mpq_class rest = v - below;
  const int side = cmp(rest, mpq_class(1, 2));  // of the middle between the two
  switch (rule) {
    case SnapRule::kNearestEven:
      return side < 0 || (side == 0 && IsEven(below)) ? below : above;
    case SnapRule::kNearestAway:
      return side < 0 || (side == 0 && v < 0) ? below : above;
    case SnapRule::kHalfUp:
      return side < 0 ? below : above;
    case SnapRule::kFloor:
      return below;
    case SnapRule::kTruncate:
      return v < 0 && v != below ? above : below;
  }
  return below;
}

mpq_class Snapped(const mpq_class& x, const Snap& snap) {
  if (snap.IsNone()) return x;
  const mpq_class step = TwoTo(-snap.bits);
  const mpq_class origin = snap.form == SnapForm::kCoordinate ? mpq_class(0) : snap.origin;
  mpq_class moved = x - origin;
  if (snap.form == SnapForm::kFloat32Difference) {
    moved = Rounded({Kind::kFinite, moved < 0, moved}, kFloat32).number;
  }
  return origin + WholeByRule(moved / step, snap.rule) * step;
}

std::vector<mpq_class> GridPoints(const mpq_class& x, const Snap& snap, double tolerance) {
  const mpq_class step = TwoTo(-snap.bits);
  const mpq_class most = tolerance * step;
  const mpq_class origin = snap.form == SnapForm::kCoordinate ? mpq_class(0) : snap.origin;
  const mpz_class below = Floor((x - origin) / step);
  std::vector<mpq_class> points{Snapped(x, snap)};
  for (int k = -2; k <= 3; ++k) {
    const mpq_class point = origin + (below + k) * step;
    if (abs(mpq_class(point - x)) <= most && point != points[0]) points.push_back(point);
  }
  std::ranges::sort(points);
  return points;
}

mpq_class Wrapped(const mpq_class& x, const FixedInput& fixed) {
  if (!fixed.wraps) return x;
  const mpq_class span = TwoTo(fixed.integer_bits);
  const mpq_class least = fixed.is_signed ? mpq_class(-span / 2) : mpq_class(0);
  return x - span * Floor((x - least) / span);
}

bool IsLarger(const std::array<std::array<mpq_class, 2>, 3>& corners,
              const MaxPrimitiveExtent& extent) {
  for (const auto& a : corners) {
    for (const auto& b : corners) {
      if (a[0] - b[0] > mpq_class(extent.width) || a[1] - b[1] > mpq_class(extent.height)) {
        return true;
      }
    }
  }
  return false;
}

Value InWindow(double x, const Vertex& clip, const Transform& transform, int size, bool flips) {
  if (!IsFinite(clip) || (!transform.map && clip.w <= 0)) return kNaN;
  const Format& format = transform.precision == Precision::kFloat32 ? kFloat32 : kFloat64;
  const auto rounded = [&](const Value& exact) { return Rounded(exact, format); };
  const Value one = FromDouble(1);
  const Value half = {Kind::kFinite, false, mpq_class(size) / 2};
  const Value given = rounded(FromDouble(x));
  const auto divided = [&](const Value& v, double by) {
    const Value w = rounded(FromDouble(by));
    return transform.division == Division::kQuotient
               ? rounded(Quotient(v, w))
               : rounded(Product(v, rounded(Quotient(one, w))));
  };
  if (const auto& map = transform.map) {
    const Value origin = rounded(FromDouble(flips ? map->y0 : map->x0));
    return divided(rounded(Sum(given, Negated(origin))), flips ? map->dy : map->dx);
  }
  Value q = divided(given, clip.w);
  if (flips && transform.flips_y) q = Negated(q);
  switch (transform.viewport) {
    case ViewportForm::kNone:
      break;
    case ViewportForm::kMultiplyAdd:
      return rounded(Sum(rounded(Product(q, half)), half));
    case ViewportForm::kFused:
      return rounded(Sum(Product(q, half), half));
    case ViewportForm::kAddMultiply:
      return rounded(Product(rounded(Sum(q, one)), half));
  }
  return q;
}

}  // namespace rasterproof::second
