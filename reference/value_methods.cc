#include "reference/value_methods.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

namespace rasterproof::reference {
namespace {

template <class T>
using Three = std::array<T, 3>;

// Each sum is rounded from the left to the right.
template <class T>
T Sum(const Three<T>& x) {
  return (x[0] + x[1]) + x[2];
}
template <class T>
T Dot(const Three<T>& x, const Three<T>& y) {
  return (x[0] * y[0] + x[1] * y[1]) + x[2] * y[2];
}
template <class T>
T FusedDot(const Three<T>& x, const Three<T>& y) {
  return std::fma(x[2], y[2], std::fma(x[1], y[1], x[0] * y[0]));
}

// x0 y1 - x1 y0, as the forms below round it.
struct Plain {
  template <class T>
  static T Cross(T x0, T y0, T x1, T y1) {
    return x0 * y1 - x1 * y0;
  }
  template <class T>
  static T Dot(const Three<T>& x, const Three<T>& y) {
    return reference::Dot(x, y);
  }
  // c + a x + b y.
  template <class T>
  static T Onto(T c, T a, T x, T b, T y) {
    return (c + a * x) + b * y;
  }
  // a x + b y + c.
  template <class T>
  static T Plane(T a, T x, T b, T y, T c) {
    return (a * x + b * y) + c;
  }
};
struct Fused {
  template <class T>
  static T Cross(T x0, T y0, T x1, T y1) {
    return std::fma(x0, y1, -(x1 * y0));
  }
  template <class T>
  static T Dot(const Three<T>& x, const Three<T>& y) {
    return FusedDot(x, y);
  }
  template <class T>
  static T Onto(T c, T a, T x, T b, T y) {
    return std::fma(b, y, std::fma(a, x, c));
  }
  template <class T>
  static T Plane(T a, T x, T b, T y, T c) {
    return std::fma(a, x, std::fma(b, y, c));
  }
};

// Sum l_i a_i with l_i = E_i / (E_0 + E_1 + E_2), each edge value from its own start. At a vertex
// two edge values are 0, the difference of equal products, and the third is the sum: its l_i is 1.
struct EdgeProducts {
  template <class T>
  static T At(const ValueTask<T>& t) {
    Three<T> e;
    for (std::size_t i = 0; i < 3; ++i) {
      const ValueCorner<T>& from = t.v[(i + 1) % 3];
      const ValueCorner<T>& to = t.v[(i + 2) % 3];
      e[i] = Plain::Cross<T>(to.x - from.x, to.y - from.y, t.x - from.x, t.y - from.y);
    }
    const T area = Sum(e);
    return Dot<T>({e[0] / area, e[1] / area, e[2] / area}, t.a);
  }
};

// The corners and the point from the first corner.
template <class T>
struct FromFirst {
  explicit FromFirst(const ValueTask<T>& t)
      : x1(t.v[1].x - t.v[0].x),
        y1(t.v[1].y - t.v[0].y),
        x2(t.v[2].x - t.v[0].x),
        y2(t.v[2].y - t.v[0].y),
        x(t.x - t.v[0].x),
        y(t.y - t.v[0].y),
        a1(t.a[1] - t.a[0]),
        a2(t.a[2] - t.a[0]) {}
  T x1, y1, x2, y2, x, y, a1, a2;
};

// a_0 + l_1 (a_1 - a_0) + l_2 (a_2 - a_0). Equal numbers: both differences are 0, and finite
// weights leave a_0.
template <class Form>
struct Differences {
  template <class T>
  static T At(const ValueTask<T>& t) {
    const FromFirst<T> d(t);
    const T area = Form::template Cross<T>(d.x1, d.y1, d.x2, d.y2);
    const T l1 = Form::template Cross<T>(d.x, d.y, d.x2, d.y2) / area;
    const T l2 = Form::template Cross<T>(d.x1, d.y1, d.x, d.y) / area;
    return Form::template Onto<T>(t.a[0], l1, d.a1, l2, d.a2);
  }
};

// A x + B y + C with (A, B, C) the sum of (V_j x V_k) a_i over the area.
struct OriginPlane {
  template <class T>
  static T At(const ValueTask<T>& t) {
    Three<T> nx;
    Three<T> ny;
    Three<T> nw;
    for (std::size_t i = 0; i < 3; ++i) {
      const ValueCorner<T>& j = t.v[(i + 1) % 3];
      const ValueCorner<T>& k = t.v[(i + 2) % 3];
      nx[i] = j.y - k.y;
      ny[i] = k.x - j.x;
      nw[i] = Plain::Cross<T>(j.x, j.y, k.x, k.y);
    }
    const T area = Sum(nw);
    return Plain::Plane<T>(Dot(nx, t.a) / area, t.x, Dot(ny, t.a) / area, t.y, Dot(nw, t.a) / area);
  }
};

// The gradient from differences; equal numbers make it 0.
template <class T>
std::array<T, 2> Gradient(const FromFirst<T>& d) {
  const T area = Plain::Cross<T>(d.x1, d.y1, d.x2, d.y2);
  return {Plain::Cross<T>(d.a1, d.y1, d.a2, d.y2) / area,
          Plain::Cross<T>(d.x1, d.a1, d.x2, d.a2) / area};
}

struct VertexPlane {
  template <class T>
  static T At(const ValueTask<T>& t) {
    const FromFirst<T> d(t);
    const auto [a, b] = Gradient(d);
    return t.a[0] + (a * d.x + b * d.y);
  }
};

struct Stepped {
  template <class T>
  static T At(const ValueTask<T>& t) {
    T value = VertexPlane::At(t);
    const T step = Gradient(FromFirst<T>(t))[0];
    for (int n = 0; n < t.steps; ++n) value += step;
    return value;
  }
};

// The planes of a/w and 1/w over the window.
template <class Form>
struct PerspectivePlanes {
  template <class T>
  static T At(const ValueTask<T>& t) {
    Three<T> x;
    Three<T> y;
    Three<T> r;
    Three<T> s;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = t.v[i].x / t.v[i].w;
      y[i] = t.v[i].y / t.v[i].w;
      r[i] = 1 / t.v[i].w;
      s[i] = t.a[i] * r[i];
    }
    const Three<T> nx{y[1] - y[2], y[2] - y[0], y[0] - y[1]};
    const Three<T> ny{x[2] - x[1], x[0] - x[2], x[1] - x[0]};
    const Three<T> nw{Form::template Cross<T>(x[1], y[1], x[2], y[2]),
                      Form::template Cross<T>(x[2], y[2], x[0], y[0]),
                      Form::template Cross<T>(x[0], y[0], x[1], y[1])};
    const auto plane = [&](const Three<T>& numbers) {
      return Form::template Plane<T>(Form::template Dot<T>(nx, numbers), t.x,
                                     Form::template Dot<T>(ny, numbers), t.y,
                                     Form::template Dot<T>(nw, numbers));
    };
    return plane(s) / plane(r);
  }
};

// V_j x V_k, the columns of the corners' adjugate matrix.
template <class T>
struct Adjugate {
  explicit Adjugate(const ValueTask<T>& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const ValueCorner<T>& j = t.v[(i + 1) % 3];
      const ValueCorner<T>& k = t.v[(i + 2) % 3];
      x[i] = Plain::Cross<T>(j.y, j.w, k.y, k.w);
      y[i] = Plain::Cross<T>(j.w, j.x, k.w, k.x);
      w[i] = Plain::Cross<T>(j.x, j.y, k.x, k.y);
    }
  }
  // Their sum with the numbers, at the point.
  T At(const ValueTask<T>& t, const Three<T>& numbers) const {
    return Plain::Plane<T>(Dot(x, numbers), t.x, Dot(y, numbers), t.y, Dot(w, numbers));
  }
  T SumAt(const ValueTask<T>& t) const { return Plain::Plane<T>(Sum(x), t.x, Sum(y), t.y, Sum(w)); }
  Three<T> x;
  Three<T> y;
  Three<T> w;
};

struct InverseMatrix {
  template <class T>
  static T At(const ValueTask<T>& t) {
    const Adjugate<T> matrix(t);
    return matrix.At(t, t.a) / matrix.SumAt(t);
  }
};

struct PerspectiveWeights {
  template <class T>
  static T At(const ValueTask<T>& t) {
    const Adjugate<T> n(t);
    Three<T> beta;
    for (std::size_t i = 0; i < 3; ++i) {
      beta[i] = Plain::Plane<T>(n.x[i], t.x, n.y[i], t.y, n.w[i]);
    }
    const T sum = Sum(beta);
    return Dot<T>({beta[0] / sum, beta[1] / sum, beta[2] / sum}, t.a);
  }
};

// 1/d to the nearest number of so many bits, as a table has it.
template <int kBits, class T>
T EstimatedReciprocal(T d) {
  int exponent = 0;
  const double significand = std::frexp(1 / double{d}, &exponent);
  return static_cast<T>(
      std::ldexp(std::nearbyint(std::ldexp(significand, kBits)), exponent - kBits));
}

template <int kBits, int kNewtonSteps>
struct ByReciprocal {
  template <class T>
  static T At(const ValueTask<T>& t) {
    const Adjugate<T> matrix(t);
    const T d = matrix.SumAt(t);
    T r = EstimatedReciprocal<kBits>(d);
    for (int step = 0; step < kNewtonSteps; ++step) r = r * (2 - d * r);
    return matrix.At(t, t.a) * r;
  }
};

struct QuadDifference {
  template <class T>
  static T At(const ValueTask<T>& t) {
    ValueTask<T> right = t;
    right.x += 1;
    return Differences<Plain>::At(right) - Differences<Plain>::At(t);
  }
};

struct CorrectlyRounded {
  template <class T>
  static T At(const ValueTask<T>& t) {
    return CorrectlyRoundedValue(t);
  }
};

struct Promises {
  bool equal = false;
  bool vertices = false;
  bool hull = false;
};

template <class Method>
ValueMethod Row(std::string_view name, std::string_view computes, ValueSpace space,
                ConditionAbout about, double conditions, Promises promises = {}) {
  return {name,
          computes,
          space,
          about,
          ValueTarget::kValue,
          {conditions, conditions},
          0,
          0,
          promises.equal,
          promises.vertices,
          promises.hull,
          &Method::template At<float>,
          &Method::template At<double>};
}

template <int kBits, int kNewtonSteps>
ValueMethod ReciprocalRow(std::string_view name, std::string_view computes) {
  ValueMethod row = Row<ByReciprocal<kBits, kNewtonSteps>>(name, computes, ValueSpace::kClip,
                                                           ConditionAbout::kOrigin, 0);
  row.conditions = {ReciprocalConditions<float>(kBits, kNewtonSteps),
                    ReciprocalConditions<double>(kBits, kNewtonSteps)};
  return row;
}

ValueMethod SteppedRow() {
  ValueMethod row = Row<Stepped>("stepped", "the same at the row's start, then A for each pixel",
                                 ValueSpace::kWindow, ConditionAbout::kFirstVertex,
                                 kSteppedConditions, {.equal = true});
  row.target = ValueTarget::kAfterSteps;
  row.conditions_a_step = kSteppedConditionsAStep;
  return row;
}

ValueMethod QuadRow() {
  ValueMethod row = Row<QuadDifference>("quad-difference",
                                        "the right pixel's value by differences "
                                        "less the left one's: d/dx",
                                        ValueSpace::kWindow, ConditionAbout::kFirstVertex,
                                        kQuadDifferenceConditions);
  row.target = ValueTarget::kDifference;
  return row;
}

ValueMethod RoundedRow() {
  ValueMethod row = Row<CorrectlyRounded>(
      "correctly-rounded", "a filter in double, then exact sums", ValueSpace::kClip,
      ConditionAbout::kOrigin, 0, {.equal = true, .vertices = true, .hull = true});
  row.ulps = kCorrectlyRoundedUlps;
  return row;
}

}  // namespace

std::span<const ValueMethod> ValueMethods() {
  using enum ConditionAbout;
  constexpr ValueSpace kWindow = ValueSpace::kWindow;
  constexpr ValueSpace kClip = ValueSpace::kClip;
  static const std::array methods{
      Row<EdgeProducts>("edge-products", "sum of E_i / (E_0 + E_1 + E_2) a_i", kWindow, kEdgeStart,
                        kEdgeProductsConditions, {.vertices = true}),
      Row<Differences<Plain>>("differences", "a_0 + l_1 (a_1 - a_0) + l_2 (a_2 - a_0)", kWindow,
                              kFirstVertex, kDifferencesConditions, {.equal = true}),
      Row<Differences<Fused>>("differences-fma", "the same, fused", kWindow, kFirstVertex,
                              kFusedDifferencesConditions, {.equal = true}),
      Row<OriginPlane>("origin-plane", "A x + B y + C", kWindow, kOrigin, kOriginPlaneConditions),
      Row<VertexPlane>("vertex-plane", "a_0 + (A (x - x_0) + B (y - y_0))", kWindow, kFirstVertex,
                       kVertexPlaneConditions, {.equal = true}),
      SteppedRow(),
      Row<PerspectivePlanes<Plain>>("perspective-planes", "the plane of a/w by the plane of 1/w",
                                    kClip, kOrigin, kPerspectivePlanesConditions),
      Row<PerspectivePlanes<Fused>>("perspective-planes-fma", "the same, fused", kClip, kOrigin,
                                    kFusedPerspectivePlanesConditions),
      Row<InverseMatrix>("inverse-matrix", "the adjugate of (x, y, w) times a, by times 1", kClip,
                         kOrigin, kInverseMatrixConditions),
      Row<PerspectiveWeights>("perspective-weights", "sum of beta_i / sum beta a_i", kClip, kOrigin,
                              kPerspectiveWeightsConditions),
      ReciprocalRow<12, 0>("reciprocal-12", "the inverse matrix with 1/d to 12 bits"),
      ReciprocalRow<12, 1>("reciprocal-12-newton", "and one Newton step"),
      ReciprocalRow<12, 2>("reciprocal-12-newton-2", "and two"),
      ReciprocalRow<14, 0>("reciprocal-14", "the inverse matrix with 1/d to 14 bits"),
      ReciprocalRow<14, 1>("reciprocal-14-newton", "and one Newton step"),
      ReciprocalRow<14, 2>("reciprocal-14-newton-2", "and two"),
      QuadRow(),
      RoundedRow(),
  };
  return methods;
}

}  // namespace rasterproof::reference
