// Values of covered rows, pixels along the lanes: planes and one division.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> v, float* p, int n) {
  if (n >= kLanesOf<D>) {
    hn::StoreU(v, d, p);
  } else {
    hn::BlendedStore(v, hn::FirstN(d, static_cast<std::size_t>(n)), d, p);
  }
}

template <bool kDivides, bool kDerivatives>
HWY_INLINE void FillValues(const ValueSpan& s) {
  const DF f;
  const float y = static_cast<float>(s.row) + 0.5F;
  const VF n_row = hn::Set(f, s.n.c + s.n.b * y);
  const VF d_row = hn::Set(f, s.d.c + s.d.b * y);
  const VF n_x = hn::Set(f, s.n.a);
  const VF d_x = hn::Set(f, s.d.a);
  const VF n_y = hn::Set(f, s.n.b);
  const VF d_y = hn::Set(f, s.d.b);
  const int width = s.x1 - s.x0;
  for (int at = 0; at < width; at += kLanes) {
    const VF x = FloatsFrom(f, static_cast<float>(s.x0 + at) + 0.5F);
    VF value = hn::Add(n_row, hn::Mul(n_x, x));
    [[maybe_unused]] const VF d = hn::Add(d_row, hn::Mul(d_x, x));
    if constexpr (kDivides) value = hn::Div(value, d);
    StoreFirst(f, value, s.value + at, width - at);
    if constexpr (kDerivatives) {
      VF dx = n_x;
      VF dy = n_y;
      if constexpr (kDivides) {
        dx = hn::Div(hn::Sub(n_x, hn::Mul(value, d_x)), d);
        dy = hn::Div(hn::Sub(n_y, hn::Mul(value, d_y)), d);
      }
      StoreFirst(f, dx, s.dx + at, width - at);
      StoreFirst(f, dy, s.dy + at, width - at);
    }
  }
}

inline void Values(const ValueSpan& s) {
  if (s.divides) {
    s.dx != nullptr ? FillValues<true, true>(s) : FillValues<true, false>(s);
  } else {
    s.dx != nullptr ? FillValues<false, true>(s) : FillValues<false, false>(s);
  }
}

/// n / d within kQuotientError.
///
/// With AVX-512 by an estimate r of 14 bits: h = 1 - d r, |h| <= 2^-14, and n/d = n r (1 + h + h^2
/// + h^3 / (1 - h)): without the last part off by 2^-42 (1 + 2^-13) and three roundings.
HWY_INLINE VD Quotient(VD n, VD d) {
#if HWY_TARGET == HWY_AVX3
  const VD r{_mm512_rcp14_pd(d.raw)};
  const VD h = hn::NegMulAdd(d, r, hn::Set(DD(), 1.0));
  const VD q = hn::Mul(n, r);
  return hn::MulAdd(q, hn::MulAdd(h, h, h), q);
#else
  return hn::Div(n, d);
#endif
}

/// A double has 29 bits more than a float: the middles of two floats are those of which the first
/// alone is set.
constexpr std::int64_t kMiddle = std::int64_t{1} << 28;

inline void Nearest(const NearestSpan& s) {
  const DD dd;
  const DDF df;
  const hn::RebindToSigned<DD> di;
  const VD n_x = hn::Set(dd, s.n_x);
  const VD d_x = hn::Set(dd, s.d_x);
  const VD n_row = hn::Set(dd, s.n_row);
  const VD d_row = hn::Set(dd, s.d_row);
  const auto shift = hn::Set(di, s.doubt - kMiddle);
  const auto low_bits = hn::Set(di, 2 * kMiddle - 1);
  const auto doubtful = hn::Set(di, 2 * s.doubt + 1);
  const VD first = hn::Iota(dd, 0.5);
  const int width = s.x1 - s.x0;
  for (int at = 0; at < width; at += kDoubles) {
    const VD x = hn::Add(hn::Set(dd, static_cast<double>(s.x0 + at)), first);
    const VD q = Quotient(hn::MulAdd(n_x, x, n_row), hn::MulAdd(d_x, x, d_row));
    StoreFirst(df, hn::DemoteTo(df, q), s.value + at, width - at);
    const auto bits = hn::And(hn::Add(hn::BitCast(di, q), shift), low_bits);
    std::uint64_t open = MaskBits(di, hn::Lt(bits, doubtful));
    if (HWY_UNLIKELY(open != 0)) {
      if (width - at < kDoubles) open &= (std::uint64_t{1} << (width - at)) - 1;
      for (; open != 0; open &= open - 1) {
        const int lane = CountTrailingZeros(open);
        s.value[at + lane] = s.decide(s.state, s.x0 + at + lane);
      }
    }
  }
}

constexpr ValueTable kValues = {&Values, &Nearest};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_SPANS_H_
