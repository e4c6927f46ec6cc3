#include "reference/edge_values.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rasterproof::reference {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool IsFinitePoint(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// The n-th point of a walk, or NaN where double would have to round it.
Point2 StepPoint(Point2 p, const Step& step, int n) {
  const double moved = static_cast<double>(step.sign) * step.length * n;
  double& c = step.along_y ? p.y : p.x;
  const double sum = c + moved;
  c = sum - moved == c && sum - c == moved ? sum : kNaN;
  return p;
}

/// f at every point of a walk: what methods do that start afresh at each sample.
template <class F>
std::vector<double> AtEachPoint(Point2 p, const Step& step, int steps, const F& f) {
  std::vector<double> values;
  for (int n = 0; n <= steps; ++n) values.push_back(f(StepPoint(p, step, n)));
  return values;
}

/// A bound on how far the snap moves E when every coordinate moves by at most 2^-(bits + 1) = h.
///
/// A difference of coordinates moves by at most 2h = g, a product of two by g (|x| + |y|) + g^2.
double SnapMovesEdgeBy(Point2 a, Point2 b, Point2 p, int bits) {
  const double g = std::ldexp(1.0, -bits);
  const double sides =
      std::fabs(p.x - a.x) + std::fabs(b.y - a.y) + std::fabs(p.y - a.y) + std::fabs(b.x - a.x);
  return RoundBoundUp(g * sides + 2 * g * g);
}

}  // namespace

double ExactEdgeValues::Value(Point2 a, Point2 b, Point2 p) const {
  if (!IsFinitePoint(a) || !IsFinitePoint(b) || !IsFinitePoint(p)) return kNaN;
  return library::ExactEdge(a, b, p).ToDouble();
}

double ExactEdgeValues::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  const double value = Value(a, b, p);
  if (!std::isfinite(value)) return kNaN;
  library::ExactSum error = library::ExactEdge(a, b, p);
  error.Subtract(value, 1.0);
  // Half a unit in the last place is at most u |value|; among subnormals, half of the smallest.
  return std::fabs(error.ToDouble()) == 0 && error.Sign() == 0
             ? 0
             : std::fabs(value) * rounding_epsilon<double>() +
                   std::numeric_limits<double>::denorm_min();
}

std::vector<double> ExactEdgeValues::Steps(Point2 a, Point2 b, Point2 p, Step step,
                                           int steps) const {
  return AtEachPoint(p, step, steps, [&](Point2 at) { return Value(a, b, at); });
}

std::vector<double> ExactEdgeValues::SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                         int steps) const {
  return AtEachPoint(p, step, steps, [&](Point2 at) { return ErrorBound(a, b, at); });
}

template <class I, int kBits>
double IntegerEdgeValues<I, kBits>::Value(Point2 a, Point2 b, Point2 p) const {
  using Form = IntegerForm<I, kBits>;
  const Point2 sa = Form::Snapped(a);
  const Point2 sb = Form::Snapped(b);
  const Point2 sp = Form::Snapped(p);
  if (!Form::Fits(sa) || !Form::Fits(sb) || !Form::Fits(sp)) {
    return ExactEdgeValues().Value(sa, sb, sp);
  }
  const auto at = Form::Convert(sp);
  const I e = Form(Form::Convert(sa), Form::Convert(sb), false).At(at.x, at.y);
  return std::ldexp(static_cast<double>(e), -2 * kBits);
}

template <class I, int kBits>
double IntegerEdgeValues<I, kBits>::ErrorBound(Point2 a, Point2 b, Point2 p) const {
  using Form = IntegerForm<I, kBits>;
  const Point2 sa = Form::Snapped(a);
  const Point2 sb = Form::Snapped(b);
  const Point2 sp = Form::Snapped(p);
  // What is shown is the nearest double of the exact value, in the domain and out of it.
  const double shown = ExactEdgeValues().ErrorBound(sa, sb, sp);
  const bool on_grid = sa == a && sb == b && sp == p;
  return on_grid ? shown : RoundBoundUp(shown + SnapMovesEdgeBy(a, b, p, kBits));
}

template <class I, int kBits>
std::vector<double> IntegerEdgeValues<I, kBits>::Steps(Point2 a, Point2 b, Point2 p, Step step,
                                                       int steps) const {
  using Form = IntegerForm<I, kBits>;
  const Point2 sa = Form::Snapped(a);
  const Point2 sb = Form::Snapped(b);
  const Point2 sp = Form::Snapped(p);
  // The sums pass through E at every point of the walk, so its far end bounds them all.
  if (!Form::Fits(sa) || !Form::Fits(sb) || !Form::Fits(sp) ||
      !Form::Fits(StepPoint(sp, step, steps))) {
    return AtEachPoint(sp, step, steps, [&](Point2 at) { return Value(a, b, at); });
  }
  const Form form(Form::Convert(sa), Form::Convert(sb), false);
  const auto at = Form::Convert(sp);
  I e = form.At(at.x, at.y);
  std::vector<double> values{std::ldexp(static_cast<double>(e), -2 * kBits)};
  for (int n = 1; n <= steps; ++n) {
    e += static_cast<I>(step.sign * step.length) * (step.along_y ? form.StepY() : form.StepX());
    values.push_back(std::ldexp(static_cast<double>(e), -2 * kBits));
  }
  return values;
}

template <class I, int kBits>
std::vector<double> IntegerEdgeValues<I, kBits>::SteppingErrorBounds(Point2 a, Point2 b, Point2 p,
                                                                     Step step, int steps) const {
  return AtEachPoint(p, step, steps, [&](Point2 at) { return ErrorBound(a, b, at); });
}

template class IntegerEdgeValues<std::int64_t, 8>;
template class IntegerEdgeValues<std::int32_t, 4>;

}  // namespace rasterproof::reference
