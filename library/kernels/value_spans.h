// Values of covered rows, pixels along the lanes: planes and one division, or correctly rounded.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/nearest_spans.h"
#include "library/kernels/value_set_up.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

// Of a span's columns, in each plane that is asked for.
struct ValueRow {
  float *value, *dx, *dy;
};

HWY_INLINE void FillRow(float* row, int n, float with) {
  if (row == nullptr) return;
  const DF f;
  for (int at = 0; at < n; at += kLanes) StoreFirst(f, hn::Set(f, with), row + at, n - at);
}

/// value = n / d, and the derivatives (n.a - value d.a) / d and (n.b - value d.b) / d; n, n.a and
/// n.b where it does not divide.
template <bool kDivides, bool kDerivatives>
HWY_INLINE void FillValues(const ValuePlane& n, const ValuePlane& d, const KernelSpan& s,
                           const ValueRow& to) {
  const DF f;
  const float y = static_cast<float>(s.row) + 0.5F;
  const VF n_row = hn::Set(f, n.c + n.b * y);
  const VF d_row = hn::Set(f, d.c + d.b * y);
  const VF n_x = hn::Set(f, n.a);
  const VF d_x = hn::Set(f, d.a);
  const VF n_y = hn::Set(f, n.b);
  const VF d_y = hn::Set(f, d.b);
  const int width = s.x1 - s.x0;
  for (int at = 0; at < width; at += kLanes) {
    const VF x = FloatsFrom(f, static_cast<float>(s.x0 + at) + 0.5F);
    VF value = hn::Add(n_row, hn::Mul(n_x, x));
    [[maybe_unused]] const VF below = hn::Add(d_row, hn::Mul(d_x, x));
    if constexpr (kDivides) value = hn::Div(value, below);
    StoreFirst(f, value, to.value + at, width - at);
    if constexpr (kDerivatives) {
      VF dx = n_x;
      VF dy = n_y;
      if constexpr (kDivides) {
        dx = hn::Div(hn::Sub(n_x, hn::Mul(value, d_x)), below);
        dy = hn::Div(hn::Sub(n_y, hn::Mul(value, d_y)), below);
      }
      StoreFirst(f, dx, to.dx + at, width - at);
      StoreFirst(f, dy, to.dy + at, width - at);
    }
  }
}

HWY_INLINE bool Divides(const ValueDrawing& v) { return v.coordinates == 4 && !v.is_linear; }

HWY_INLINE ValueRow RowOf(const ValueDrawing& v, std::size_t channel, const KernelSpan& s) {
  const std::size_t row =
      channel * static_cast<std::size_t>(v.height) + static_cast<std::size_t>(s.row);
  const std::size_t pixel = row * v.pitch + static_cast<std::size_t>(s.x0);
  const auto at = [pixel](float* plane) { return plane == nullptr ? nullptr : plane + pixel; };
  return {v.values + pixel, at(v.dx), at(v.dy)};
}

// Rows of NaN and of equal numbers, which have no lines.
HWY_INLINE void FillWithout(const ValueChannel& of, const KernelSpan& s, const ValueRow& to) {
  const float with = of.fill == ValueFill::kConstant ? of.constant : __builtin_nanf("");
  for (float* const row : {to.value, to.dx, to.dy}) FillRow(row, s.x1 - s.x0, with);
}

inline void DrawFast(const void* state, const KernelSpan& s) {
  ValueDrawing& v = **static_cast<ValueDrawing* const*>(state);
  const bool divides = Divides(v);
  if (s.triangle != v.triangle) SetUpTriangle<false>(s, divides, v);
  for (std::size_t channel = 0; channel < v.channels; ++channel) {
    const ValueChannel& of = v.of_channels[channel];
    const ValueRow to = RowOf(v, channel, s);
    if (of.fill != ValueFill::kPlane) {
      FillWithout(of, s, to);
    } else if (divides) {
      to.dx != nullptr ? FillValues<true, true>(of.plane, of.d_plane, s, to)
                       : FillValues<true, false>(of.plane, of.d_plane, s, to);
    } else {
      to.dx != nullptr ? FillValues<false, true>(of.plane, of.d_plane, s, to)
                       : FillValues<false, false>(of.plane, of.d_plane, s, to);
    }
  }
}

// All channels of a span, divided in one way.
template <Divided kHow>
HWY_INLINE void DrawNearestSpan(const ValueDrawing& v, const KernelSpan& s, const LocalSpan& at) {
  for (std::size_t channel = 0; channel < v.channels; ++channel) {
    const ValueChannel& of = v.of_channels[channel];
    const ValueRow to = RowOf(v, channel, s);
    if (of.fill != ValueFill::kPlane) {
      FillWithout(of, s, to);
      continue;
    }
    const auto decide = [&v, &s, channel](int x) {
      return v.decide(v, channel, v.set_up.left + x, s.row);
    };
    DrawNearest<kHow>({&of.n, &v.set_up.d, v.set_up.r}, of.quick, at, v.reciprocals, to.value,
                      decide);
  }
}

inline void DrawNearestValues(const void* state, const KernelSpan& s) {
  ValueDrawing& v = **static_cast<ValueDrawing* const*>(state);
  if (s.triangle != v.triangle) SetUpTriangle<true>(s, Divides(v), v);
  const LocalSpan at(v.set_up, s.row, s.x0, s.x1);
  if (v.set_up.r != 0) {
    DrawNearestSpan<Divided::kByNumber>(v, s, at);
  } else if (v.channels == 1) {
    DrawNearestSpan<Divided::kByLine>(v, s, at);
  } else {
    // One division a pixel for all channels.
    const RowLine d = RowOf(v.set_up.d, at);
    const DD dd;
    const VD step = hn::Set(dd, static_cast<double>(kDoubles));
    VD x = CentresFrom(at.x0);
    for (int k = 0; k < at.x1 - at.x0; k += kDoubles) {
      const VD below = hn::MulAdd(hn::Set(dd, d.x), x, hn::Set(dd, d.row));
      hn::StoreU(Reciprocal(below), dd, v.reciprocals + k);
      x = hn::Add(x, step);
    }
    DrawNearestSpan<Divided::kByReciprocals>(v, s, at);
  }
}

constexpr ValueTable kValues = {&DrawFast, &DrawNearestValues};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_
