// Policies of the frame in value_frame.h. Each has SetUp(triangle), Row(y) and At(x), in the order
// of operations of the method that it is named for in reference/value_methods.cc.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_POLICIES_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_POLICIES_H_

#include "bench/values/value_kernels.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

using bench::ValueTriangle;

template <class D>
using NumberOf = hn::TFromD<D>;

// x0 y1 - x1 y0 of numbers, a b - c d of vectors, and sums of products, rounded as each form does.
struct PlainForm {
  template <class T>
  HWY_INLINE static T Cross(T x0, T y0, T x1, T y1) {
    return x0 * y1 - x1 * y0;
  }
  template <class D, class V>
  HWY_INLINE static V Minor(D, V a, V b, V c, V d) {
    return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
  }
  // c + a x + b y.
  template <class V>
  HWY_INLINE static V Onto(V c, V a, V x, V b, V y) {
    return hn::Add(hn::Add(c, hn::Mul(a, x)), hn::Mul(b, y));
  }
  template <class T>
  HWY_INLINE static T Dot(const T (&x)[3], const T (&y)[3]) {
    return (x[0] * y[0] + x[1] * y[1]) + x[2] * y[2];
  }
};
struct FusedForm {
  template <class T>
  HWY_INLINE static T Fma(T a, T b, T c) {
    if constexpr (sizeof(T) == sizeof(float)) {
      return __builtin_fmaf(a, b, c);
    } else {
      return __builtin_fma(a, b, c);
    }
  }
  template <class T>
  HWY_INLINE static T Cross(T x0, T y0, T x1, T y1) {
    return Fma(x0, y1, -(x1 * y0));
  }
  template <class D, class V>
  HWY_INLINE static V Minor(D, V a, V b, V c, V d) {
    return hn::MulSub(a, b, hn::Mul(c, d));
  }
  template <class V>
  HWY_INLINE static V Onto(V c, V a, V x, V b, V y) {
    return hn::MulAdd(b, y, hn::MulAdd(a, x, c));
  }
  template <class T>
  HWY_INLINE static T Dot(const T (&x)[3], const T (&y)[3]) {
    return Fma(x[2], y[2], Fma(x[1], y[1], x[0] * y[0]));
  }
};

// (a x + b y) + c, or fused a x + (b y + c): b y and c are of the row.
template <class D, class Form>
struct ValueLine {
  using T = NumberOf<D>;
  T a = 0, b = 0, c = 0;
  T row = 0;

  HWY_INLINE void Row(T y) {
    if constexpr (HWY_NATIVE_FMA && __is_same(Form, FusedForm)) {
      row = FusedForm::Fma(b, y, c);
    } else {
      row = b * y;
    }
  }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    const D d;
    if constexpr (__is_same(Form, FusedForm)) {
      return hn::MulAdd(hn::Set(d, a), x, hn::Set(d, row));
    } else {
      return hn::Add(hn::Add(hn::Mul(hn::Set(d, a), x), hn::Set(d, row)), hn::Set(d, c));
    }
  }
};

template <class D_>
struct ConstantPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) { a = NumberOf<D>(t.a[0]); }
  HWY_INLINE void Row(NumberOf<D>) {}
  HWY_INLINE hn::Vec<D> At(hn::Vec<D>) const { return hn::Set(D(), a); }
  NumberOf<D> a;
};

template <class D_>
struct EdgeProductsPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    for (int i = 0; i < 3; ++i) {
      const int from = (i + 1) % 3;
      const int to = (i + 2) % 3;
      fx[i] = T(t.x[from]);
      fy[i] = T(t.y[from]);
      dx[i] = T(t.x[to]) - fx[i];
      dy[i] = T(t.y[to]) - fy[i];
      a[i] = T(t.a[i]);
    }
  }
  HWY_INLINE void Row(T y) {
    for (int i = 0; i < 3; ++i) row[i] = dx[i] * (y - fy[i]);
  }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    const D d;
    hn::Vec<D> e[3];
    for (int i = 0; i < 3; ++i) {
      const auto from = hn::Mul(hn::Sub(x, hn::Set(d, fx[i])), hn::Set(d, dy[i]));
      e[i] = hn::Sub(hn::Set(d, row[i]), from);
    }
    const auto area = hn::Add(hn::Add(e[0], e[1]), e[2]);
    const auto part = [&](int i) { return hn::Mul(hn::Div(e[i], area), hn::Set(d, a[i])); };
    return hn::Add(hn::Add(part(0), part(1)), part(2));
  }
  T fx[3], fy[3], dx[3], dy[3], a[3], row[3];
};

// Corners and numbers from the first corner.
template <class T>
struct FromFirstCorner {
  HWY_INLINE explicit FromFirstCorner(const ValueTriangle& t)
      : x0(T(t.x[0])),
        y0(T(t.y[0])),
        a0(T(t.a[0])),
        x1(T(t.x[1]) - x0),
        y1(T(t.y[1]) - y0),
        x2(T(t.x[2]) - x0),
        y2(T(t.y[2]) - y0),
        a1(T(t.a[1]) - a0),
        a2(T(t.a[2]) - a0) {}
  HWY_INLINE FromFirstCorner() = default;
  T x0, y0, a0, x1, y1, x2, y2, a1, a2;
};

template <class D_, class Form>
struct DifferencesPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    f = FromFirstCorner<T>(t);
    area = Form::template Cross<T>(f.x1, f.y1, f.x2, f.y2);
  }
  HWY_INLINE void Row(T y) { dy = y - f.y0; }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    const D d;
    const auto set = [](T v) { return hn::Set(D(), v); };
    const auto dx = hn::Sub(x, set(f.x0));
    const auto l1 = hn::Div(Form::Minor(d, dx, set(f.y2), set(f.x2), set(dy)), set(area));
    const auto l2 = hn::Div(Form::Minor(d, set(f.x1), set(dy), dx, set(f.y1)), set(area));
    return Form::Onto(set(f.a0), l1, set(f.a1), l2, set(f.a2));
  }
  FromFirstCorner<T> f;
  T area, dy;
};

// d/dx as the next pixel's value less this one's.
template <class Of>
struct QuadDifferencePolicy {
  using D = typename Of::D;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) { of.SetUp(t); }
  HWY_INLINE void Row(T y) { of.Row(y); }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    return hn::Sub(of.At(hn::Add(x, hn::Set(D(), T(1)))), of.At(x));
  }
  Of of;
};

template <class D_>
struct OriginPlanePolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    T nx[3], ny[3], nw[3], a[3];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      nx[i] = T(t.y[j]) - T(t.y[k]);
      ny[i] = T(t.x[k]) - T(t.x[j]);
      nw[i] = PlainForm::Cross<T>(t.x[j], t.y[j], t.x[k], t.y[k]);
      a[i] = T(t.a[i]);
    }
    const T area = (nw[0] + nw[1]) + nw[2];
    line = {PlainForm::Dot(nx, a) / area, PlainForm::Dot(ny, a) / area,
            PlainForm::Dot(nw, a) / area, 0};
  }
  HWY_INLINE void Row(T y) { line.Row(y); }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const { return line.At(x); }
  ValueLine<D, PlainForm> line;
};

template <class D_>
struct VertexPlanePolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    const FromFirstCorner<T> f(t);
    const T area = PlainForm::Cross<T>(f.x1, f.y1, f.x2, f.y2);
    x0 = f.x0;
    y0 = f.y0;
    a0 = f.a0;
    a = PlainForm::Cross<T>(f.a1, f.y1, f.a2, f.y2) / area;
    b = PlainForm::Cross<T>(f.x1, f.a1, f.x2, f.a2) / area;
  }
  HWY_INLINE void Row(T y) { row = b * (y - y0); }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    const D d;
    const auto along = hn::Mul(hn::Set(d, a), hn::Sub(x, hn::Set(d, x0)));
    return hn::Add(hn::Set(d, a0), hn::Add(along, hn::Set(d, row)));
  }
  T x0, y0, a0, a, b, row;
};

// The planes of a/w and 1/w over the window.
template <class D_, class Form>
struct PerspectivePlanesPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    T x[3], y[3], r[3], s[3];
    for (int i = 0; i < 3; ++i) {
      x[i] = T(t.x[i]) / T(t.w[i]);
      y[i] = T(t.y[i]) / T(t.w[i]);
      r[i] = 1 / T(t.w[i]);
      s[i] = T(t.a[i]) * r[i];
    }
    const T nx[3] = {y[1] - y[2], y[2] - y[0], y[0] - y[1]};
    const T ny[3] = {x[2] - x[1], x[0] - x[2], x[1] - x[0]};
    const T nw[3] = {Form::template Cross<T>(x[1], y[1], x[2], y[2]),
                     Form::template Cross<T>(x[2], y[2], x[0], y[0]),
                     Form::template Cross<T>(x[0], y[0], x[1], y[1])};
    n = {Form::Dot(nx, s), Form::Dot(ny, s), Form::Dot(nw, s), 0};
    d = {Form::Dot(nx, r), Form::Dot(ny, r), Form::Dot(nw, r), 0};
  }
  HWY_INLINE void Row(T y) {
    n.Row(y);
    d.Row(y);
  }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const { return hn::Div(n.At(x), d.At(x)); }
  ValueLine<D, Form> n, d;
};

// V_j x V_k.
template <class T>
struct AdjugateOf {
  HWY_INLINE explicit AdjugateOf(const ValueTriangle& t) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      x[i] = PlainForm::Cross<T>(t.y[j], t.w[j], t.y[k], t.w[k]);
      y[i] = PlainForm::Cross<T>(t.w[j], t.x[j], t.w[k], t.x[k]);
      w[i] = PlainForm::Cross<T>(t.x[j], t.y[j], t.x[k], t.y[k]);
    }
  }
  T x[3], y[3], w[3];
};

// n and d of the inverse matrix; By divides them.
template <class D_, class By>
struct InverseMatrixPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    const AdjugateOf<T> m(t);
    const T a[3] = {T(t.a[0]), T(t.a[1]), T(t.a[2])};
    n = {PlainForm::Dot(m.x, a), PlainForm::Dot(m.y, a), PlainForm::Dot(m.w, a), 0};
    d = {(m.x[0] + m.x[1]) + m.x[2], (m.y[0] + m.y[1]) + m.y[2], (m.w[0] + m.w[1]) + m.w[2], 0};
  }
  HWY_INLINE void Row(T y) {
    n.Row(y);
    d.Row(y);
  }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const { return By::Quotient(D(), n.At(x), d.At(x)); }
  ValueLine<D, PlainForm> n, d;
};

struct ByDivision {
  template <class D, class V>
  HWY_INLINE static V Quotient(D, V n, V d) {
    return hn::Div(n, d);
  }
};

// The processor's estimate: 14 bits with AVX-512, else 12 (within 1.5 2^-12).
template <int kSteps>
struct ByEstimate {
  template <class D, class V>
  HWY_INLINE static V Quotient(D tag, V n, V d) {
    V r = hn::ApproximateReciprocal(d);
    for (int k = 0; k < kSteps; ++k) {
      r = hn::Mul(r, hn::Sub(hn::Set(tag, 2.0F), hn::Mul(d, r)));
    }
    return hn::Mul(n, r);
  }
};

template <class D_>
struct PerspectiveWeightsPolicy {
  using D = D_;
  using T = NumberOf<D>;
  HWY_INLINE void SetUp(const ValueTriangle& t) {
    const AdjugateOf<T> m(t);
    for (int i = 0; i < 3; ++i) {
      beta[i] = {m.x[i], m.y[i], m.w[i], 0};
      a[i] = T(t.a[i]);
    }
  }
  HWY_INLINE void Row(T y) {
    for (auto& line : beta) line.Row(y);
  }
  HWY_INLINE hn::Vec<D> At(hn::Vec<D> x) const {
    const hn::Vec<D> b[3] = {beta[0].At(x), beta[1].At(x), beta[2].At(x)};
    const auto sum = hn::Add(hn::Add(b[0], b[1]), b[2]);
    const auto part = [&](int i) { return hn::Mul(hn::Div(b[i], sum), hn::Set(D(), a[i])); };
    return hn::Add(hn::Add(part(0), part(1)), part(2));
  }
  ValueLine<D, PlainForm> beta[3];
  T a[3];
};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_POLICIES_H_
