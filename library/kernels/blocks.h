// Setting up kBlock triangles at a time: corners, box, facing, plane.
#ifndef RASTERPROOF_LIBRARY_KERNELS_BLOCKS_H_
#define RASTERPROOF_LIBRARY_KERNELS_BLOCKS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// z = (zc + zy * y) + zx * x at the pixel centre (x, y), each operation rounded to float32, and
/// no less than `least` nor more than `most`, the vertices'. Never NaN, and never -0, of which
/// targets disagree what the lesser of it and 0 is.
///
/// Where a |coefficient| is not less than kSteepest (the area rounds to zero, say) z is `least`
/// throughout; it is infinite if a vertex's z is not finite.
struct Plane {
  float zc, zx, zy;
  float least, most;
};

/// z / w of a triangle in clip space, an affine function of the screen: (zc + zy y) + zx x in
/// double. NaN throughout if a vertex's z is not finite.
struct ClipPlane {
  double zc, zx, zy;
};

/// Pixels [x0, x1) x [y0, y1) of the target.
struct Box {
  int x0, x1, y0, y1;
};

/// What every method needs of a block of triangles; bit i and index i are triangle i.
struct alignas(64) Block {
  std::int32_t x0[kBlock], x1[kBlock], y0[kBlock], y1[kBlock];
  float zc[kBlock], zx[kBlock], zy[kBlock];
  float least_z[kBlock], most_z[kBlock];
  std::uint32_t drawn;
  std::uint32_t front;
  std::uint32_t small;  ///< those drawn whose box is at most 8x8
  int width;            ///< largest of those
  int height;

  Box BoxOf(int i) const { return {x0[i], x1[i], y0[i], y1[i]}; }
  Plane PlaneOf(int i) const { return {zc[i], zx[i], zy[i], least_z[i], most_z[i]}; }
  bool IsFront(int i) const { return ((front >> i) & 1) != 0; }
  bool IsSmall(int i) const { return ((small >> i) & 1) != 0; }
};

/// Corners of consecutive triangles, one a lane.
template <class V>
struct Corners {
  V x[3], y[3], z[3];
};

#if HWY_TARGET != HWY_SCALAR
/// The first kEach numbers of the vertices at vertex(0), vertex(kEach), vertex(2 kEach), ...
template <int kEach, class D, class VertexAt>
HWY_INLINE hn::Vec<D> LoadEvery(D d, const VertexAt& vertex) {
  if constexpr (kLanesOf<D> == kEach) {
    return hn::LoadU(d, vertex(0));
  } else {
    constexpr int kHalf = kLanesOf<D> / 2;
    const hn::Half<D> half;
    return hn::Combine(d, LoadEvery<kEach>(half, [&](int i) { return vertex(kHalf + i); }),
                       LoadEvery<kEach>(half, vertex));
  }
}
#endif

/// The corners of the triangles whose indices begin at `indices`.
///
/// Loaded one by one: gathering the same takes up to twice as long, since it keeps fewer cache
/// misses under way.
template <bool kWithZ, class D>
HWY_INLINE Corners<hn::Vec<D>> LoadCorners(D d, const float* vertices,
                                           const std::uint32_t* indices) {
  constexpr int kN = kLanesOf<D>;
  Corners<hn::Vec<D>> corners;
  alignas(64) float z[3][kN];
  for (int k = 0; k < 3; ++k) {
    const auto vertex = [&](int i) { return vertices + std::size_t{3} * indices[3 * i + k]; };
#if HWY_TARGET == HWY_SCALAR
    corners.x[k] = hn::Set(d, vertex(0)[0]);
    corners.y[k] = hn::Set(d, vertex(0)[1]);
#else
    const auto even = LoadEvery<2>(d, vertex);
    const auto odd = LoadEvery<2>(d, [&](int i) { return vertex(i + 1); });
    corners.x[k] = hn::OddEven(hn::DupEven(odd), even);
    corners.y[k] = hn::OddEven(odd, hn::DupOdd(even));
#endif
    if constexpr (kWithZ) {
      for (int i = 0; i < kN; ++i) z[k][i] = vertex(i)[2];
      corners.z[k] = hn::Load(d, z[k]);
    }
  }
  return corners;
}

template <class V>
HWY_INLINE V Min3(const V (&v)[3]) {
  return hn::Min(hn::Min(v[0], v[1]), v[2]);
}
template <class V>
HWY_INLINE V Max3(const V (&v)[3]) {
  return hn::Max(hn::Max(v[0], v[1]), v[2]);
}

/// The first pixel of [0, size] whose centre is at or beyond v.
///
/// Domain:     any v; NaN may give any pixel.
template <class D>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> FirstCentreFrom(D d, hn::Vec<D> v, int size) {
  const auto limit = hn::Set(d, static_cast<float>(size));
  const auto from = hn::Ceil(hn::Sub(v, hn::Set(d, 0.5F)));
  return hn::ConvertTo(hn::Rebind<std::int32_t, D>(), hn::Min(hn::Max(from, hn::Zero(d)), limit));
}

/// The first pixel of [0, size] whose centre is beyond v.
template <class D>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> FirstCentreBeyond(D d, hn::Vec<D> v, int size) {
  const auto limit = hn::Set(d, static_cast<float>(size));
  const auto beyond = hn::Add(hn::Floor(hn::Sub(v, hn::Set(d, 0.5F))), hn::Set(d, 1.0F));
  return hn::ConvertTo(hn::Rebind<std::int32_t, D>(), hn::Min(hn::Max(beyond, hn::Zero(d)), limit));
}

/// The triangles of one group of lanes whose box is not empty.
template <class DI_>
HWY_INLINE std::uint32_t StoreBox(DI_ di, hn::Vec<DI_> x0, hn::Vec<DI_> x1, hn::Vec<DI_> y0,
                                  hn::Vec<DI_> y1, int at, Block& block) {
  hn::Store(x0, di, block.x0 + at);
  hn::Store(x1, di, block.x1 + at);
  hn::Store(y0, di, block.y0 + at);
  hn::Store(y1, di, block.y1 + at);
  return static_cast<std::uint32_t>(MaskBits(di, hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1))));
}

/// Of a plane: no z of a target overflows.
constexpr float kSteepest = 0x1p100F;

/// Stores planes, and what they are where they have no z or no finite one: see Plane.
template <class D>
HWY_INLINE void StoreTame(D d, hn::Vec<D> zc, hn::Vec<D> zx, hn::Vec<D> zy,
                          const hn::Vec<D> (&z)[3], int at, Block& block) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d);
  const auto is_tame = [&](V v) { return hn::Lt(hn::Abs(v), hn::Set(d, kSteepest)); };
  const auto tame = hn::And(is_tame(zc), hn::And(is_tame(zx), is_tame(zy)));
  V sum = zero;  // 0 of finite numbers, NaN of others
  for (const V v : z) sum = hn::Add(sum, hn::Sub(v, v));
  const auto finite = hn::Eq(sum, zero);
  const V infinite = hn::Set(d, __builtin_inff());
  const V least = hn::IfThenElse(finite, hn::Add(Min3(z), zero), infinite);
  const V most = hn::IfThenElse(finite, hn::Add(Max3(z), zero), infinite);
  hn::Store(hn::IfThenElseZero(tame, zx), d, block.zx + at);
  hn::Store(hn::IfThenElseZero(tame, zy), d, block.zy + at);
  hn::Store(hn::IfThenElse(tame, hn::Add(zc, zero), least), d, block.zc + at);
  hn::Store(least, d, block.least_z + at);
  hn::Store(most, d, block.most_z + at);
}

/// The planes of one group of lanes, from corners in any order.
template <class D>
HWY_INLINE void StorePlanes(D d, const Corners<hn::Vec<D>>& c, int at, Block& block) {
  using V = hn::Vec<D>;
  const V ux = hn::Sub(c.x[1], c.x[0]);
  const V uy = hn::Sub(c.y[1], c.y[0]);
  const V uz = hn::Sub(c.z[1], c.z[0]);
  const V vx = hn::Sub(c.x[2], c.x[0]);
  const V vy = hn::Sub(c.y[2], c.y[0]);
  const V vz = hn::Sub(c.z[2], c.z[0]);
  const V det = hn::Sub(hn::Mul(ux, vy), hn::Mul(vx, uy));
  const V zx = hn::Div(hn::Sub(hn::Mul(uz, vy), hn::Mul(vz, uy)), det);
  const V zy = hn::Div(hn::Sub(hn::Mul(vz, ux), hn::Mul(uz, vx)), det);
  const V zc = hn::Sub(hn::Sub(c.z[0], hn::Mul(zx, c.x[0])), hn::Mul(zy, c.y[0]));
  StoreTame(d, zc, zx, zy, c.z, at, block);
}

/// Fills in which of the triangles drawn are small.
HWY_INLINE void FindSmall(Block& block) {
  const DI di;
  auto width = hn::Zero(di);
  auto height = hn::Zero(di);
  std::uint32_t small = 0;
  for (int at = 0; at < kBlock; at += kLanes) {
    const auto w = hn::Sub(hn::Load(di, block.x1 + at), hn::Load(di, block.x0 + at));
    const auto h = hn::Sub(hn::Load(di, block.y1 + at), hn::Load(di, block.y0 + at));
    const auto drawn = MaskOf(di, block.drawn >> at);
    const auto is_small = hn::And(drawn, hn::Lt(hn::Max(w, h), hn::Set(di, 9)));
    small |= static_cast<std::uint32_t>(MaskBits(di, is_small)) << at;
    width = hn::Max(width, hn::IfThenElseZero(is_small, w));
    height = hn::Max(height, hn::IfThenElseZero(is_small, h));
  }
  block.small = small;
  block.width = hn::GetLane(hn::MaxOfLanes(di, width));
  block.height = hn::GetLane(hn::MaxOfLanes(di, height));
}

/// The pixels of a small triangle's box, as bits of an 8x8 mask at its corner.
HWY_INLINE std::uint64_t SmallBoxMask(const Block& block, int i) {
  const auto columns = (std::uint64_t{1} << (block.x1[i] - block.x0[i])) - 1;
  return columns * 0x0101010101010101U &
         (~std::uint64_t{0} >> (64 - 8 * (block.y1[i] - block.y0[i])));
}

/// Calls set_up(indices), which fills the block, and draw(i, triangle) for each one drawn, in
/// order. set_up may read the indices of kBlock triangles; those beyond the last have no area.
template <class SomeBlock, class SetUp, class DrawTriangle>
HWY_INLINE void ForEachTriangle(const KernelView& view, SomeBlock& block, const SetUp& set_up,
                                const DrawTriangle& draw) {
  std::uint32_t last[3 * kBlock] = {};
  for (std::size_t first = 0; first < view.triangles; first += kBlock) {
    const std::uint32_t* indices = view.indices + 3 * first;
    if (view.triangles - first < kBlock) {
      const std::size_t left = 3 * (view.triangles - first);
      for (std::size_t k = 0; k < left; ++k) last[k] = indices[k];
      indices = last;
    }
    block.drawn = 0;
    block.front = 0;
    set_up(indices);
    for (std::uint32_t drawn = block.drawn; drawn != 0; drawn &= drawn - 1) {
      const int i = CountTrailingZeros(drawn);
      draw(i, static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i));
    }
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_BLOCKS_H_
