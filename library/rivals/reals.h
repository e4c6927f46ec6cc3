// What float32 and float64 differ in: vectors, and nothing else.
#ifndef RASTERPROOF_LIBRARY_RIVALS_REALS_H_
#define RASTERPROOF_LIBRARY_RIVALS_REALS_H_

#include <cstdint>

#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// How an edge is evaluated; of E = 0 and of its crossings x(y) alike.
enum class Form {
  kDirect,  ///< from one of its ends
  kAffine,  ///< by the coefficients of the plane
  kStepped  ///< from the first place that is asked for, and a multiple of the step
};

template <class T>
struct RealTags {
  using D = DF;
  using DFloat = DF;
  using DInt = DI;
};
template <>
struct RealTags<double> {
  using D = DD;
  using DFloat = DDF;
  using DInt = DDI;
};
template <class T>
using RealTag = typename RealTags<T>::D;
template <class T>
using RealVec = hn::Vec<RealTag<T>>;
template <class T>
constexpr int kReals = kLanesOf<RealTag<T>>;

/// The same numbers in T.
template <class T>
HWY_INLINE RealVec<T> ToReals(hn::Vec<typename RealTags<T>::DFloat> v) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return v;
  } else {
    return hn::PromoteTo(RealTag<T>(), v);
  }
}
template <class T>
HWY_INLINE RealVec<T> ToReals(hn::Vec<typename RealTags<T>::DInt> v) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return hn::ConvertTo(RealTag<T>(), v);
  } else {
    return hn::PromoteTo(RealTag<T>(), v);
  }
}

/// As many of the numbers from p on as T has lanes.
template <class T>
HWY_INLINE RealVec<T> LoadReals(const float* p) {
  return ToReals<T>(hn::LoadU(typename RealTags<T>::DFloat(), p));
}
template <class T>
HWY_INLINE RealVec<T> LoadReals(const std::int32_t* p) {
  return ToReals<T>(hn::LoadU(typename RealTags<T>::DInt(), p));
}

/// first, first + 1, ... exact.
alignas(64) constexpr double kDoublesFromZero[8] = {0, 1, 2, 3, 4, 5, 6, 7};
template <class T>
HWY_INLINE RealVec<T> RealsFrom(T first) {
  const RealTag<T> d;
  if constexpr (sizeof(T) == sizeof(float)) {
    return FloatsFrom(d, first);
  } else {
    return hn::Add(hn::Set(d, first), hn::Load(d, kDoublesFromZero));
  }
}

using DI64 = hn::Rebind<std::int64_t, DD>;
using VI64 = hn::Vec<DI64>;

/// Bit i: lane i is negative.
HWY_INLINE std::uint64_t NegativeLanes(VI64 v) {
#if HWY_TARGET == HWY_SCALAR
  return v.raw < 0 ? 1 : 0;
#else
  return MaskBits(DI64(), hn::MaskFromVec(v));  // of which the sign is the mask
#endif
}

/// Domain:     |v| < 2^51, whole.
HWY_INLINE VI64 ToInt64(VD v) {
  const VD magic = hn::Set(DD(), 0x1.8p52);
  return hn::Sub(hn::BitCast(DI64(), hn::Add(v, magic)), hn::BitCast(DI64(), magic));
}

/// Twice the signed area: positive where the corners turn counter-clockwise on screen.
template <class V>
HWY_INLINE V TwiceArea(const V (&x)[3], const V (&y)[3]) {
  return hn::Sub(hn::Mul(hn::Sub(x[2], x[0]), hn::Sub(y[1], y[0])),
                 hn::Mul(hn::Sub(y[2], y[0]), hn::Sub(x[1], x[0])));
}

/// Lanes of a triangle that has an area.
template <class D>
HWY_INLINE std::uint64_t HasArea(D d, hn::Vec<D> area) {
  const auto size = hn::Abs(area);
  const auto infinite = hn::Set(d, static_cast<hn::TFromD<D>>(__builtin_inff()));
  return MaskBits(d, hn::And(hn::Gt(size, hn::Zero(d)), hn::Lt(size, infinite)));
}

/// Rounded up. Lanes of 2^31 and more, or of no number, become any number.
HWY_INLINE VI CeiledToInt(VF v) {
#if HWY_TARGET == HWY_AVX3
  return VI{_mm512_cvt_roundps_epi32(v.raw, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)};
#else
  return Truncated(hn::Ceil(v));
#endif
}
#if HWY_TARGET != HWY_SCALAR
HWY_INLINE VI CeiledToInt(VD low, VD high) {
#if HWY_TARGET == HWY_AVX3
  constexpr int kUp = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;
  const hn::Vec<DDI> a{_mm512_cvt_roundpd_epi32(low.raw, kUp)};
  const hn::Vec<DDI> b{_mm512_cvt_roundpd_epi32(high.raw, kUp)};
#elif HWY_TARGET == HWY_AVX2
  const hn::Vec<DDI> a{_mm256_cvttpd_epi32(hn::Ceil(low).raw)};
  const hn::Vec<DDI> b{_mm256_cvttpd_epi32(hn::Ceil(high).raw)};
#else
  const auto a = hn::DemoteTo(DDI(), hn::Ceil(low));
  const auto b = hn::DemoteTo(DDI(), hn::Ceil(high));
#endif
  return hn::Combine(DI(), b, a);
}
#endif

/// kLanes numbers, rounded up: at(h) has those from the h-th on.
template <class T, class At>
HWY_INLINE VI CeiledLanes(const At& at) {
  if constexpr (kReals<T> == kLanes) {
    if constexpr (sizeof(T) == sizeof(float)) {
      return CeiledToInt(at(0));
    } else {
      return hn::DemoteTo(DI(), hn::Ceil(at(0)));
    }
  } else {
    return CeiledToInt(at(0), at(kReals<T>));
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_REALS_H_
