// Highway, header-only, for the one target that this translation unit is compiled for.
//
// Everything that is included after this lives in the namespace of the target, is always inlined or
// a template of it, and uses no function of the standard library: see kernel_table.h.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VECTORS_H_
#define RASTERPROOF_LIBRARY_KERNELS_VECTORS_H_

#include <cstddef>
#include <cstdint>

// No assertions, which would need Highway's library; no dispatch but ours.
#define HWY_IS_DEBUG_BUILD 0
#ifndef HWY_COMPILE_ONLY_SCALAR
#define HWY_COMPILE_ONLY_STATIC
#endif
#include "hwy/highway.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Triangles that are set up together.
constexpr int kBlock = 16;

template <class D>
constexpr int kLanesOf = static_cast<int>(hn::MaxLanes(D()));

using DF = hn::CappedTag<float, kBlock>;
using DI = hn::Rebind<std::int32_t, DF>;
using DU = hn::Rebind<std::uint32_t, DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
constexpr int kLanes = kLanesOf<DF>;

/// Half as many lanes, for doubles beside them.
using DD = hn::CappedTag<double, kBlock / 2>;
using DDF = hn::Rebind<float, DD>;
using DDI = hn::Rebind<std::int32_t, DD>;
using VD = hn::Vec<DD>;
constexpr int kDoubles = kLanesOf<DD>;

/// Bit i is lane i.
template <class D, class M>
HWY_INLINE std::uint64_t MaskBits(D /*d*/, M mask) {
#if HWY_TARGET == HWY_SCALAR
  return mask.bits != 0 ? 1 : 0;
#elif HWY_TARGET <= HWY_AVX3
  return static_cast<std::uint64_t>(mask.raw);
#else
  return hn::detail::BitsFromMask(mask);
#endif
}

/// The mask with lane i as bit i of `bits`; bits beyond the lanes do not matter.
template <class D>
HWY_INLINE hn::Mask<D> MaskOf(D d, std::uint64_t bits) {
#if HWY_TARGET == HWY_SCALAR
  (void)d;
  return hn::Mask<D>::FromBool((bits & 1) != 0);
#elif HWY_TARGET <= HWY_AVX3
  (void)d;
  return hn::Mask<D>{static_cast<decltype(hn::Mask<D>::raw)>(bits)};
#else
  return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
#endif
}

/// first, first + 1, ... in float32, exact: Highway's Iota adds lane by lane.
alignas(64) constexpr float kFirstFloats[kBlock] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                    8, 9, 10, 11, 12, 13, 14, 15};
template <class D>
HWY_INLINE hn::Vec<D> FloatsFrom(D d, float first) {
  return hn::Add(hn::Set(d, first), hn::Load(d, kFirstFloats));
}

/// v, or the end of [least, most] that it lies beyond.
///
/// Domain:     neither NaN nor -0.
template <class D>
HWY_INLINE hn::Vec<D> Clamped(D d, hn::Vec<D> v, float least, float most) {
#if HWY_TARGET == HWY_SCALAR
  (void)d;
  const float from = v.raw < least ? least : v.raw;  // Highway's Max looks for NaN
  return hn::Vec<D>(from > most ? most : from);
#else
  return hn::Min(hn::Max(v, hn::Set(d, least)), hn::Set(d, most));
#endif
}

/// v towards zero.
///
/// Domain:     |v| < 2^31; other lanes become any number.
HWY_INLINE VI Truncated(VF v) {
#if HWY_TARGET == HWY_AVX3
  return VI{_mm512_cvttps_epi32(v.raw)};  // Highway's own looks for what is beyond
#elif HWY_TARGET == HWY_AVX2
  return VI{_mm256_cvttps_epi32(v.raw)};
#elif HWY_TARGET == HWY_SSE4
  return VI{_mm_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(DI(), v);
#endif
}

HWY_INLINE int CountTrailingZeros(std::uint64_t bits) { return __builtin_ctzll(bits); }
template <class T>
HWY_INLINE constexpr T Least(T a, T b) {
  return a < b ? a : b;
}
template <class T>
HWY_INLINE constexpr T Greatest(T a, T b) {
  return a < b ? b : a;
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_VECTORS_H_
