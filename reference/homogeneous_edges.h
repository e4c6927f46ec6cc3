// Homogeneous edge set-up: what each arithmetic keeps of an edge, and how it decides a sample.
#ifndef RASTERPROOF_REFERENCE_HOMOGENEOUS_EDGES_H_
#define RASTERPROOF_REFERENCE_HOMOGENEOUS_EDGES_H_

#include <array>
#include <cmath>
#include <concepts>

#include "core/tie_rule.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "reference/edge_ownership.h"
#include "reference/homogeneous.h"

namespace rasterproof::reference {

/// What a homogeneous edge can do: built of two clip-space vertices, the facing that makes its
/// inside positive, the tie rule and the largest |p.x| and |p.y| that it is asked about; then it
/// says whether a sample is inside.
template <class E>
concept HomogeneousEdge =
    std::constructible_from<E, const Vertex&, const Vertex&, int, const TieRule&, Point2> &&
    requires(const E& edge, const std::array<Vertex, 3>& v, double x, double y) {
      { E::Facing(v) } -> std::same_as<int>;
      { edge.Contains(x, y) } -> std::same_as<bool>;
      { edge.MayTouch(x, x, y) } -> std::same_as<bool>;
    };

/// N = V_j x V_i over (x, y, w), every operation rounded once to T.
template <class T>
struct HomogeneousNormal {
  T x, y, w;

  HomogeneousNormal(const Vertex& vi, const Vertex& vj)
      : x(Difference(vj.y, vi.w, vj.w, vi.y)),
        y(Difference(vj.w, vi.x, vj.x, vi.w)),
        w(Difference(vj.x, vi.y, vj.y, vi.x)) {}

  T Dot(T px, T py, T pw) const { return (x * px + y * py) + w * pw; }

 private:
  static T Difference(double a, double b, double c, double d) {
    return static_cast<T>(a) * static_cast<T>(b) - static_cast<T>(c) * static_cast<T>(d);
  }
};

/// T of kHomogeneousErrorMultiplier for N . (x, y, w), every operation rounded once.
template <class T>
T DotMagnitude(const Vertex& vi, const Vertex& vj, const T& x, const T& y, const T& w) {
  using std::fabs;
  const auto minor = [](double a, double b, double c, double d) {
    return fabs(static_cast<T>(a) * static_cast<T>(b)) +
           fabs(static_cast<T>(c) * static_cast<T>(d));
  };
  return minor(vj.y, vi.w, vj.w, vi.y) * fabs(x) + minor(vj.w, vi.x, vj.x, vi.w) * fabs(y) +
         minor(vj.x, vi.y, vj.y, vi.x) * fabs(w);
}

/// The filter of N . (x, y, w) in double: its sign is certain beyond multiplier u T, underflow
/// apart. T is computed with at most eight roundings: 1 + 2^-40 covers them and those here.
template <class T>
T DotErrorBound(const T& magnitude) {
  return T(kHomogeneousErrorMultiplier<double> * rounding_epsilon<double>()) * magnitude *
         T(1 + 0x1p-40);
}

/// Whether a sample exactly on the edge is the triangle's: the sample moves by the rule's shift,
/// and the value with it by (sign_x e) N.x and (sign_y e^2) N.y, in the rule's order.
template <class T>
bool OwnsTies(T nx, T ny, const TieRule& rule) {
  if (!rule.IsConsistent()) return rule.inclusive;
  const T by_x = rule.sign_x > 0 ? nx : -nx;
  const T by_y = rule.sign_y > 0 ? ny : -ny;
  const T first = rule.y_first ? by_y : by_x;
  const T second = rule.y_first ? by_x : by_y;
  return first > 0 || (first == 0 && second > 0);
}

/// An edge in floating point: its sign is taken as it comes out.
template <class T>
class FloatHomogeneousEdge {
 public:
  /// `facing`: +1 or -1, so that the inside is positive.
  FloatHomogeneousEdge(const Vertex& vi, const Vertex& vj, int facing, const TieRule& rule,
                       Point2 /*extent*/)
      : normal_(facing > 0 ? HomogeneousNormal<T>(vi, vj) : HomogeneousNormal<T>(vj, vi)),
        from_(InsideFrom<T>(OwnsTies(normal_.x, normal_.y, rule))) {}

  static int Facing(const std::array<Vertex, 3>& v) {
    const T determinant =
        HomogeneousNormal<T>(v[2], v[1])
            .Dot(static_cast<T>(v[0].x), static_cast<T>(v[0].y), static_cast<T>(v[0].w));
    return determinant < 0 ? 1 : (determinant > 0 ? -1 : 0);
  }

  bool Contains(double x, double y) const { return IsInside(At(x, y), from_); }
  /// False only if no sample between the two ends of a row is inside: every operation of At rounds
  /// monotonically, so the values between lie between the values at the ends.
  bool MayTouch(double x0, double x1, double y) const {
    return At(x0, y) >= from_ || At(x1, y) >= from_;
  }

 private:
  T At(double x, double y) const {
    return (normal_.x * static_cast<T>(x) + normal_.y * static_cast<T>(y)) + normal_.w;
  }

  HomogeneousNormal<T> normal_;
  T from_;
};

/// An edge whose sign is exact: decided in double outside the proven error, in integers inside it.
class ExactHomogeneousEdge {
 public:
  /// `extent`: the largest |p.x| and |p.y| that will be asked about.
  ExactHomogeneousEdge(const Vertex& vi, const Vertex& vj, int facing, const TieRule& rule,
                       Point2 extent);

  static int Facing(const std::array<Vertex, 3>& v) {
    return ExactHomogeneousFacing(v[0], v[1], v[2]);
  }

  bool Contains(double x, double y) const {
    const double value = At(x, y);
    if (value > error_) return true;
    if (value < -error_) return false;
    return ContainsExactly(x, y);
  }
  bool MayTouch(double x0, double x1, double y) const {
    return !(At(x0, y) < -error_ && At(x1, y) < -error_);
  }

 private:
  double At(double x, double y) const { return (normal_.x * x + normal_.y * y) + normal_.w; }
  bool ContainsExactly(double x, double y) const;

  Vertex vi_, vj_;  // in the order in which the inside is positive
  HomogeneousNormal<double> normal_;
  double error_;  ///< |At - exact| over the whole extent; NaN or infinite: ask the integers
  bool owns_ties_;
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_HOMOGENEOUS_EDGES_H_
