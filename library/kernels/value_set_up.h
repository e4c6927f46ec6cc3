// Triangles of values: lines in double, from float32 corners.
//
// The fast planes are the same bits by every instruction set: no operation here is fused.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_SET_UP_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_SET_UP_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/value_errors.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

HWY_INLINE double Magnitude(double v) { return __builtin_fabs(v); }

template <bool kReach>
HWY_INLINE void AddLine(const ReachLine& line, double factor, ReachLine& sum) {
  sum.a += line.a * factor;
  sum.b += line.b * factor;
  sum.c += line.c * factor;
  if constexpr (kReach) {
    const double reach = Magnitude(factor);
    sum.a_reach += line.a_reach * reach;
    sum.b_reach += line.b_reach * reach;
    sum.c_reach += line.c_reach * reach;
  }
}

// p q - r s: of float32 numbers one rounding.
template <bool kReach>
HWY_INLINE void SetMinor(double p, double q, double r, double s, double& of, double& reach) {
  const double first = p * q;
  const double second = r * s;
  of = first - second;
  if constexpr (kReach) reach = Magnitude(first) + Magnitude(second);
}

/// beta_i, and d: their sum where something is divided, else the determinant by its first column.
/// With reaches: where all w are one number the sum has neither a nor b.
template <bool kReach>
HWY_INLINE void SetUpCorners(bool divides, ValueSetUp& t) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    ReachLine& beta = t.beta[i];
    SetMinor<kReach>(t.y[j], t.w[k], t.w[j], t.y[k], beta.a, beta.a_reach);
    SetMinor<kReach>(t.w[j], t.x[k], t.x[j], t.w[k], beta.b, beta.b_reach);
    SetMinor<kReach>(t.x[j], t.y[k], t.y[j], t.x[k], beta.c, beta.c_reach);
  }
  t.d = {};
  if (divides) {
    for (const ReachLine& beta : t.beta) AddLine<kReach>(beta, 1, t.d);
    if (kReach && t.w[0] == t.w[1] && t.w[1] == t.w[2])
      t.d.a = t.d.b = t.d.a_reach = t.d.b_reach = 0;
  } else {
    const ReachLine& beta = t.beta[0];
    t.d.c = beta.a * t.x[0] + beta.b * t.y[0] + beta.c * t.w[0];
    if constexpr (kReach) {
      t.d.c_reach = beta.a_reach * Magnitude(t.x[0]) + beta.b_reach * Magnitude(t.y[0]) +
                    beta.c_reach * Magnitude(t.w[0]);
    }
  }
}

/// What a set-up knows of all covered pixels. There each beta_i is 0 or has the determinant's sign,
/// so |sum beta_i| is at least |sum beta_i w_i| / max |w_i|, and values lie between the least and
/// the greatest number; linear ones, whose weights are beta_i w_i, where no w is negative.
HWY_INLINE void BoundDenominator(bool divides, ValueSetUp& t) {
  const ReachLine& d = t.d;
  t.r = d.a == 0 && d.b == 0 ? 1 / d.c : 0;
  double least = Magnitude(d.c) - kLineError * d.c_reach;
  t.most_w = 1;
  if (divides) {
    const ReachLine& beta = t.beta[0];
    const double determinant = beta.a * t.x[0] + beta.b * t.y[0] + beta.c * t.w[0];
    const double reach = beta.a_reach * Magnitude(t.x[0]) + beta.b_reach * Magnitude(t.y[0]) +
                         beta.c_reach * Magnitude(t.w[0]);
    least = Magnitude(determinant) - kLineError * reach;
    t.most_w = Greatest(Magnitude(t.w[0]), Greatest(Magnitude(t.w[1]), Magnitude(t.w[2])));
  } else if (!(t.w[0] >= 0 && t.w[1] >= 0 && t.w[2] >= 0)) {
    least = 0;
  }
  t.least_d = least;
}

/// Up to which place, either way and down, a line is off by no more than kQuickShare of `least` /
/// most_w: (share least / most_w / kLineError - c) / (a + b), the reaches, less what is
/// rounded here.
HWY_INLINE int QuickPlaces(const ReachLine& line, double least, double most_w) {
  constexpr double kPart = (1 - 0x1p-10) * kQuickShare / kLineError;
  constexpr double kMost = 1 << 17;
  const double slope = most_w * (line.a_reach + line.b_reach);
  const double room = kPart * least - most_w * line.c_reach;
  if (!(room > 0)) return 0;
  return room >= kMost * slope ? 1 << 17 : static_cast<int>(room / slope);
}

/// The same of a channel of numbers a, of value n / d: between the least and the greatest of them.
HWY_INLINE int QuickPlacesOf(const ValueSetUp& t, const ReachLine& n, const double (&a)[3]) {
  const bool is_one_sign = (a[0] > 0) == (a[1] > 0) && (a[1] > 0) == (a[2] > 0);
  const double least = Least(Magnitude(a[0]), Least(Magnitude(a[1]), Magnitude(a[2])));
  const double most = Greatest(Magnitude(a[0]), Greatest(Magnitude(a[1]), Magnitude(a[2])));
  // No middle of subnormal floats, and none beyond the largest.
  if (!is_one_sign || !(least >= 0x1p-125) || !(most <= 0x1p126)) return 0;
  const int of_n = QuickPlaces(n, least * t.least_d, t.most_w);
  const int of_d = QuickPlaces(t.d, t.least_d, t.most_w);
  return Least(of_n, of_d);
}

// The most that a line is over the target.
HWY_INLINE double MostOf(const ReachLine& line, int width, int height) {
  return Magnitude(line.a) * width + Magnitude(line.b) * height + Magnitude(line.c);
}

HWY_INLINE ValuePlane Scaled(const ReachLine& line, double scale) {
  return {static_cast<float>(line.a * scale), static_cast<float>(line.b * scale),
          static_cast<float>(line.c * scale)};
}

// By a power of two, so that the greater of n and d is about 2^100 and the least part of the other
// one a normal float; where nothing divides, by d itself.
HWY_INLINE double PlaneScale(const ReachLine& n, const ReachLine& d, bool divides, int width,
                             int height) {
  if (!divides) return 1 / d.c;
  const double of_n = MostOf(n, width, height);
  const double of_d = MostOf(d, width, height);
  const double reach = Greatest(of_n, of_d);  // no product here is subnormal in double
  if (!(reach > 0)) return 1;
  const auto exponent = __builtin_bit_cast(std::uint64_t, reach) >> 52;
  return __builtin_bit_cast(double, (std::uint64_t{100 + 2 * 1023} - exponent) << 52);
}

HWY_INLINE bool IsFinite(double v) { return v - v == 0; }

template <bool kNearest>
HWY_INLINE void SetUpChannel(const ValueDrawing& v, bool divides, const double (&a)[3],
                             ValueChannel& channel) {
  channel.fill = ValueFill::kPlane;
  if (!IsFinite(a[0]) || !IsFinite(a[1]) || !IsFinite(a[2])) {
    channel.fill = ValueFill::kNothing;
    return;
  }
  if (kNearest && a[0] == a[1] && a[1] == a[2]) {
    channel.fill = ValueFill::kConstant;
    channel.constant = static_cast<float>(a[0]) + 0.0F;
    return;
  }
  const ValueSetUp& t = v.set_up;
  ReachLine n = {};
  for (int i = 0; i < 3; ++i) AddLine<kNearest>(t.beta[i], v.is_linear ? a[i] * t.w[i] : a[i], n);
  if constexpr (kNearest) {
    channel.n = n;
    channel.quick = QuickPlacesOf(t, n, a);
  } else {
    const double scale = PlaneScale(n, t.d, divides, v.width, v.height);
    channel.plane = Scaled(n, scale);
    channel.d_plane = Scaled(t.d, scale);
  }
}

/// Counts places from the corner of a pixel: x - left w, rounded once, for left w is exact.
HWY_INLINE void MoveCorners(int left, int top, ValueSetUp& t) {
  t.left = left;
  t.top = top;
  for (int k = 0; k < 3; ++k) {
    t.x[k] -= left * t.w[k];
    t.y[k] -= top * t.w[k];
  }
}

/// Of a triangle and its first span, in which the nearest values count places.
template <bool kNearest>
HWY_INLINE void SetUpTriangle(const KernelSpan& first, bool divides, ValueDrawing& v) {
  v.triangle = first.triangle;
  const std::uint32_t* const corners = &v.indices[std::size_t{3} * first.triangle];
  for (int k = 0; k < 3; ++k) {
    const float* const at = &v.positions[v.coordinates * corners[k]];
    v.set_up.x[k] = double{at[0]};
    v.set_up.y[k] = double{at[1]};
    v.set_up.w[k] = v.coordinates == 4 ? double{at[3]} : 1.0;
  }
  if constexpr (kNearest) MoveCorners(first.x0, first.row, v.set_up);
  SetUpCorners<kNearest>(divides, v.set_up);
  if constexpr (kNearest) BoundDenominator(divides, v.set_up);
  for (std::size_t channel = 0; channel < v.channels; ++channel) {
    double a[3];
    for (int k = 0; k < 3; ++k) a[k] = double{v.numbers[corners[k] * v.channels + channel]};
    SetUpChannel<kNearest>(v, divides, a, v.of_channels[channel]);
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_SET_UP_H_
