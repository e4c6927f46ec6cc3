#include "reference/bounds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rasterproof::reference {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::quiet_NaN();

/// What a bound needs to know of a number format.
struct Format {
  int digits;            ///< significand bits p
  int min_exponent;      ///< exponent of the smallest normal number
  int smallest_lattice;  ///< every value is a multiple of 2^this
  double epsilon;        ///< u = 2^-p
  double subnormal;      ///< eta
  double no_overflow;    ///< results up to this, roundings and all, stay finite
};

template <class T>
constexpr Format FormatOf() {
  using Limits = std::numeric_limits<T>;
  return {Limits::digits,        Limits::min_exponent - 1, Limits::min_exponent - Limits::digits,
          rounding_epsilon<T>(), Limits::denorm_min(),     static_cast<double>(Limits::max()) / 4};
}

Format FormatFor(Precision precision) {
  return precision == Precision::kFloat32 ? FormatOf<float>() : FormatOf<double>();
}

bool IsValueOf(Precision precision, double x) {
  return std::isfinite(x) && (precision == Precision::kFloat64 || IsFloat32(x));
}

bool AreValuesOf(Precision precision, Point2 a, Point2 b, Point2 p) {
  return IsValueOf(precision, a.x) && IsValueOf(precision, a.y) && IsValueOf(precision, b.x) &&
         IsValueOf(precision, b.y) && IsValueOf(precision, p.x) && IsValueOf(precision, p.y);
}

/// Whether every multiple of 2^lattice up to `magnitude` is a value of the format.
///
/// For float32 input, double computes differences and products that fit 24 bits exactly, so the
/// magnitude is no guess near the limit; for float64 it is rounded up first.
bool FitsLattice(Precision precision, double magnitude, int lattice) {
  const Format f = FormatFor(precision);
  const double bound = precision == Precision::kFloat64 ? RoundBoundUp(magnitude) : magnitude;
  return bound <= std::ldexp(1.0, f.digits + lattice);
}

/// Magnitudes of one evaluation of E, computed in double, not rounded up.
struct EdgeTerms {
  Precision precision;
  int lattice_x;  ///< a.x, b.x, p.x are multiples of 2^lattice_x
  int lattice_y;
  double px, py;  ///< |p.x - a.x|, |p.y - a.y|
  double dx, dy;  ///< |b.x - a.x|, |b.y - a.y|
  double sum;     ///< S
  double edge;    ///< |E|: exact for float32 if FitsLattice, an upper bound for float64

  EdgeTerms(Precision format, Point2 a, Point2 b, Point2 p)
      : precision(format),
        lattice_x(std::min({LatticeExponent(a.x), LatticeExponent(b.x), LatticeExponent(p.x)})),
        lattice_y(std::min({LatticeExponent(a.y), LatticeExponent(b.y), LatticeExponent(p.y)})),
        px(std::fabs(p.x - a.x)),
        py(std::fabs(p.y - a.y)),
        dx(std::fabs(b.x - a.x)),
        dy(std::fabs(b.y - a.y)),
        sum(px * dy + py * dx),
        edge(format == Precision::kFloat64
                 ? EdgeMagnitudeBound(a, b, p)
                 : std::fabs((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x))) {}

  int ProductLattice() const { return std::min(lattice_x + lattice_y, kAnyLattice); }
  bool MayOverflow() const {
    return !(std::max({sum, px, py, dx, dy}) <= FormatFor(precision).no_overflow);
  }
  /// n eta if a product can fall between two multiples of eta, else 0.
  double Underflow(int n) const {
    const Format f = FormatFor(precision);
    return ProductLattice() < f.smallest_lattice ? n * f.subnormal : 0;
  }
  bool ProductIsExact(double x, double y) const {
    if (x == 0 || y == 0) return true;
    return FitsLattice(precision, x, lattice_x) && FitsLattice(precision, y, lattice_y) &&
           FitsLattice(precision, x * y, ProductLattice());
  }
  /// Every intermediate result of the direct form, the fused one and Kahan's is exact.
  bool DirectIsExact() const {
    if (px == 0 && py == 0) return true;
    return ProductLattice() >= FormatFor(precision).smallest_lattice && ProductIsExact(px, dy) &&
           ProductIsExact(dx, py) && FitsLattice(precision, edge, ProductLattice());
  }
};

template <class T>
double DirectBound(const EdgeTerms& t) {
  if (t.MayOverflow()) return kNoBound;
  if (t.DirectIsExact()) return 0;
  constexpr double u = rounding_epsilon<T>();
  // Two products, each off by eta / 2, then one rounding: (1 + u) eta.
  return RoundBoundUp(kDirectEdgeErrorMultiplier<T> * u * t.sum + u * t.edge + t.Underflow(2));
}

template <class T>
double KahanBound(const EdgeTerms& t) {
  if (t.MayOverflow()) return kNoBound;
  if (t.DirectIsExact()) return 0;
  constexpr double u = rounding_epsilon<T>();
  // Each fma is off by eta / 2 where its residual falls below eta; w's own error cancels.
  return RoundBoundUp(kKahanEdgeErrorMultiplier<T> * u * t.sum + kKahanEdgeRelError<T> * t.edge +
                      t.Underflow(2));
}

template <class T>
double AffineBound(const EdgeTerms& t, Point2 a, Point2 b, Point2 p, double line_multiplier,
                   double constant_multiplier) {
  constexpr double u = rounding_epsilon<T>();
  const double ax = t.dy * std::fabs(p.x);
  const double by = t.dx * std::fabs(p.y);
  const double c0 = std::fabs(b.x * a.y);
  const double c1 = std::fabs(a.x * b.y);
  const double sum = ax + by + c0 + c1;
  if (!(std::max({sum, t.dx, t.dy}) <= FormatFor(t.precision).no_overflow)) return kNoBound;
  const int lattice = t.ProductLattice();
  // If the sum of all four terms fits, so does every partial sum, in whichever order.
  if (lattice >= FormatFor(t.precision).smallest_lattice &&
      FitsLattice(t.precision, t.dx, t.lattice_x) && FitsLattice(t.precision, t.dy, t.lattice_y) &&
      FitsLattice(t.precision, sum, lattice)) {
    return 0;
  }
  // Four products or fused sums, each off by eta / 2, grown by at most (1 + u)^3.
  return RoundBoundUp(line_multiplier * u * (ax + by) + constant_multiplier * u * (c0 + c1) +
                      t.Underflow(3));
}

template <class T>
double FreshBound(EdgeArithmetic arithmetic, const EdgeTerms& t, Point2 a, Point2 b, Point2 p) {
  switch (arithmetic) {
    case EdgeArithmetic::kKahan:
      return KahanBound<T>(t);
    case EdgeArithmetic::kAffine:
      return AffineBound<T>(t, a, b, p, kAffineLineErrorMultiplier<T>,
                            kAffineConstantErrorMultiplier<T>);
    case EdgeArithmetic::kAffineFma:
      return AffineBound<T>(t, a, b, p, kAffineFmaLineErrorMultiplier<T>,
                            kAffineFmaConstantErrorMultiplier<T>);
    case EdgeArithmetic::kDirect:
    case EdgeArithmetic::kDirectFma:
    case EdgeArithmetic::kIncremental:  // those that walk start from the direct form
    case EdgeArithmetic::kIncrementalRow:
    case EdgeArithmetic::kIncremental16:
    case EdgeArithmetic::kCompensated:
    case EdgeArithmetic::kIndex:
    case EdgeArithmetic::kIndexFma:
      // The fused form's multiplier is the direct form's.
      static_assert(kDirectFmaEdgeErrorMultiplier<T> == kDirectEdgeErrorMultiplier<T>);
      return DirectBound<T>(t);
  }
  return kNoBound;
}

/// A walk along one axis, in exact terms; entry n of the walk lies n * length pixels from p.
struct WalkTerms {
  Precision precision;
  Point2 a, b, p;
  Step step;
  double magnitude_0;       ///< bound on |E(p)|
  double edge_0;            ///< E(p) in double
  double difference;        ///< E(p + 1 pixel) - E(p), in double
  double difference_error;  ///< bound on the format's error of it
  double double_error;      ///< bound on double's own error of it
  double increment_error;   ///< bound on the format's error of L D
  int lattice;              ///< start, increments and every sum are multiples of 2^lattice

  WalkTerms(Precision format, Point2 a_in, Point2 b_in, Point2 p_in, Step step_in)
      : precision(format), a(a_in), b(b_in), p(p_in), step(step_in) {
    const EdgeTerms t(precision, a, b, p);
    magnitude_0 = EdgeMagnitudeBound(a, b, p);
    edge_0 = (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
    difference = step.sign * (step.along_y ? a.x - b.x : b.y - a.y);
    const double d = std::fabs(difference);
    const int d_lattice = step.along_y ? t.lattice_x : t.lattice_y;
    difference_error = SumRoundingError(precision, d, d_lattice);
    double_error = SumRoundingError(Precision::kFloat64, d, d_lattice);
    const Format f = FormatFor(precision);
    const double increment = RoundBoundUp(step.length * (d + difference_error));
    increment_error = step.length * difference_error;
    // L is a float; the product keeps D's lattice, and a power of two only moves the exponent.
    if (!std::has_single_bit(static_cast<unsigned>(step.length)) &&
        !FitsLattice(precision, increment, d_lattice)) {
      increment_error += f.epsilon * increment;
    }
    lattice = std::max(std::min(t.ProductLattice(), d_lattice), f.smallest_lattice);
  }

  /// A bound on |E(p + n length)|.
  double Magnitude(int n) const {
    const double k = double{static_cast<double>(n)} * step.length;
    const double own_error = magnitude_0 - std::fabs(edge_0) + k * double_error;
    return RoundBoundUp(std::fabs(edge_0 + k * difference) + own_error +
                        0x1p-51 * (magnitude_0 + k * std::fabs(difference)));
  }
  /// The sample after n steps, or NaN where the format would have to round it.
  Point2 Position(int n) const {
    Point2 at = p;
    double& c = step.along_y ? at.y : at.x;
    const double k = static_cast<double>(step.sign) * step.length * n;
    const double moved = c + k;
    const bool exact = moved - k == c && moved - c == k && IsValueOf(precision, moved);
    c = exact ? moved : kNoBound;
    return at;
  }
  double Fresh(EdgeArithmetic arithmetic, int n) const {
    return EdgeErrorBound(arithmetic, precision, a, b, Position(n));
  }
};

/// err(n) <= err(n-1) + (error of L D) + half an ulp of the exact sum, which is at most
/// |E_n| + err(n-1) + (error of L D) in size.
double AfterIncrement(const WalkTerms& w, double error, int n) {
  const double before = error + w.increment_error;
  return RoundBoundUp(
      before + SumRoundingError(w.precision, RoundBoundUp(w.Magnitude(n) + before), w.lattice));
}

/// Room for the bounds of a walk, and the first of them.
std::vector<double> FirstBound(const WalkTerms& w, int steps) {
  std::vector<double> bounds;
  bounds.reserve(static_cast<std::size_t>(steps) + 1);
  bounds.push_back(w.Fresh(EdgeArithmetic::kDirect, 0));
  return bounds;
}

std::vector<double> IncrementalBounds(const WalkTerms& w, int steps, int reanchor) {
  std::vector<double> bounds = FirstBound(w, steps);
  for (int n = 1; n <= steps; ++n) {
    const bool fresh = reanchor != 0 && n % reanchor == 0;
    const double previous = bounds.back();
    double next = fresh ? w.Fresh(EdgeArithmetic::kDirect, n) : AfterIncrement(w, previous, n);
    if (!fresh && previous == 0 && w.increment_error == 0 &&
        SumRoundingError(w.precision, w.Magnitude(n), w.lattice) == 0) {
      next = 0;
    }
    bounds.push_back(next);
  }
  return bounds;
}

/// TwoSum is exact: e_n + t_n = e_{n-1} + LD. So the pair e + l is off by the error of LD each step
/// and by the rounding of l, which is at most the sum of the half ulps that the t_n are.
std::vector<double> CompensatedBounds(const WalkTerms& w, int steps) {
  std::vector<double> bounds = FirstBound(w, steps);
  double pair_error = bounds.front();
  double low = 0;  // bound on |l|
  for (int n = 1; n <= steps; ++n) {
    const double magnitude = w.Magnitude(n);
    pair_error += w.increment_error;
    // |fl(e + LD)| is within `low` of the pair, so the sum before rounding is at most this:
    const double high = RoundBoundUp(magnitude + pair_error + low);
    const double t = SumRoundingError(w.precision, high, w.lattice);
    const double l = low + t;
    const double l_error = SumRoundingError(w.precision, RoundBoundUp(l), w.lattice);
    low = l == 0 ? 0 : RoundBoundUp(l + l_error);
    pair_error += l_error;
    if (pair_error != 0) pair_error = RoundBoundUp(pair_error);
    const double shown =
        low == 0 ? 0
                 : SumRoundingError(w.precision, RoundBoundUp(magnitude + pair_error), w.lattice);
    bounds.push_back(pair_error + shown == 0 ? 0 : RoundBoundUp(pair_error + shown));
  }
  return bounds;
}

std::vector<double> IndexBounds(const WalkTerms& w, int steps, bool fused) {
  std::vector<double> bounds = FirstBound(w, steps);
  const Format f = FormatFor(w.precision);
  for (int n = 1; n <= steps; ++n) {
    const double k = double{static_cast<double>(n)} * w.step.length;
    double before = bounds.front() + k * w.difference_error;
    const double product = RoundBoundUp(k * (std::fabs(w.difference) + w.difference_error));
    if (!fused && !FitsLattice(w.precision, product, w.lattice)) {
      before += f.epsilon * product;
    }
    const double last =
        SumRoundingError(w.precision, RoundBoundUp(w.Magnitude(n) + before), w.lattice);
    const double exact_last = SumRoundingError(w.precision, w.Magnitude(n), w.lattice);
    bounds.push_back(before + exact_last == 0 ? 0 : RoundBoundUp(before + last));
  }
  return bounds;
}

std::vector<double> FreshBounds(EdgeArithmetic arithmetic, const WalkTerms& w, int steps) {
  std::vector<double> bounds;
  bounds.reserve(static_cast<std::size_t>(steps) + 1);
  for (int n = 0; n <= steps; ++n) bounds.push_back(w.Fresh(arithmetic, n));
  return bounds;
}

/// Once a walk might have overflowed, nothing is stated of what follows.
void DropAfterOverflow(const WalkTerms& w, std::vector<double>& bounds) {
  const Format f = FormatFor(w.precision);
  bool lost = !(w.magnitude_0 <= f.no_overflow);
  for (std::size_t n = 0; n < bounds.size(); ++n) {
    const double k = static_cast<double>(n) * w.step.length;
    lost = lost || !(w.Magnitude(static_cast<int>(n)) + bounds[n] <= f.no_overflow) ||
           !(k * std::fabs(w.difference) <= f.no_overflow) || k > std::ldexp(1.0, f.digits);
    if (lost) bounds[n] = kNoBound;
  }
}

std::vector<double> SteppingBounds(EdgeArithmetic arithmetic, const WalkTerms& w, int steps) {
  switch (arithmetic) {
    case EdgeArithmetic::kIncremental:
      return IncrementalBounds(w, steps, 0);
    case EdgeArithmetic::kIncrementalRow:
      return IncrementalBounds(w, steps, w.step.along_y ? 1 : 0);
    case EdgeArithmetic::kIncremental16:
      return IncrementalBounds(w, steps, kReanchorSteps);
    case EdgeArithmetic::kCompensated:
      return CompensatedBounds(w, steps);
    case EdgeArithmetic::kIndex:
      return IndexBounds(w, steps, false);
    case EdgeArithmetic::kIndexFma:
      return IndexBounds(w, steps, true);
    case EdgeArithmetic::kDirect:
    case EdgeArithmetic::kDirectFma:
    case EdgeArithmetic::kKahan:
    case EdgeArithmetic::kAffine:
    case EdgeArithmetic::kAffineFma:
      return FreshBounds(arithmetic, w, steps);
  }
  return std::vector<double>(static_cast<std::size_t>(steps) + 1, kNoBound);
}

bool WalksFromStart(EdgeArithmetic arithmetic) {
  switch (arithmetic) {
    case EdgeArithmetic::kDirect:
    case EdgeArithmetic::kDirectFma:
    case EdgeArithmetic::kKahan:
    case EdgeArithmetic::kAffine:
    case EdgeArithmetic::kAffineFma:
      return false;
    case EdgeArithmetic::kIncremental:
    case EdgeArithmetic::kIncrementalRow:
    case EdgeArithmetic::kIncremental16:
    case EdgeArithmetic::kCompensated:
    case EdgeArithmetic::kIndex:
    case EdgeArithmetic::kIndexFma:
      return true;
  }
  return true;
}

}  // namespace

double RoundBoundUp(double x) {
  return x * (1 + 0x1p-46) + 64 * std::numeric_limits<double>::denorm_min();
}

int LatticeExponent(double x) {
  if (x == 0) return kAnyLattice;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  std::uint64_t significand = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased != 0) significand |= std::uint64_t{1} << 52;
  return std::max(biased, 1) - 1075 + std::countr_zero(significand);
}

double SumRoundingError(Precision precision, double magnitude, int lattice) {
  const Format f = FormatFor(precision);
  if (FitsLattice(precision, magnitude, lattice)) return 0;
  if (magnitude <= std::ldexp(1.0, f.min_exponent)) return 0;
  if (!std::isfinite(magnitude)) return kNoBound;
  return std::ldexp(1.0, std::ilogb(magnitude) - f.digits);
}

double EdgeMagnitudeBound(Point2 a, Point2 b, Point2 p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double l = (p.x - a.x) * dy;
  const double r = (p.y - a.y) * dx;
  constexpr double u = rounding_epsilon<double>();
  const double off = kDirectEdgeErrorMultiplier<double> * u * (std::fabs(l) + std::fabs(r));
  // Relative to the computed value the last rounding is at most u as well.
  return RoundBoundUp(std::fabs(l - r) * (1 + 2 * u) + off);
}

double EdgeErrorBound(EdgeArithmetic arithmetic, Precision precision, Point2 a, Point2 b,
                      Point2 p) {
  if (!AreValuesOf(precision, a, b, p)) return kNoBound;
  const EdgeTerms terms(precision, a, b, p);
  return precision == Precision::kFloat32 ? FreshBound<float>(arithmetic, terms, a, b, p)
                                          : FreshBound<double>(arithmetic, terms, a, b, p);
}

std::vector<double> SteppingErrorBounds(EdgeArithmetic arithmetic, Precision precision, Point2 a,
                                        Point2 b, Point2 p, Step step, int steps) {
  if (!AreValuesOf(precision, a, b, p)) {
    return std::vector<double>(static_cast<std::size_t>(steps) + 1, kNoBound);
  }
  const WalkTerms terms(precision, a, b, p, step);
  std::vector<double> bounds = SteppingBounds(arithmetic, terms, steps);
  if (WalksFromStart(arithmetic)) DropAfterOverflow(terms, bounds);
  return bounds;
}

}  // namespace rasterproof::reference
