// Edge functions in float32 or float64, inside where all three reach `least`. At (x, y) that of an
// edge from (vx, vy) with a = dy, b = -dx is
//   direct   (x - vx) a + (y - vy) b
//   affine   A x + (B y + C), C = -(vx a + vy b)
//   stepped  the direct one of the first place, and multiples of b and a
#ifndef RASTERPROOF_LIBRARY_RIVALS_EDGES_H_
#define RASTERPROOF_LIBRARY_RIVALS_EDGES_H_

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/reals.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// The smallest normal number: what an edge that does not own its ties must reach.
template <class T>
constexpr T kAboveZero = static_cast<T>(sizeof(T) == sizeof(float) ? 0x1p-126 : 0x1p-1022);

template <class T>
struct alignas(64) EdgeBlock : Block {
  T vx[3][kBlock], vy[3][kBlock];
  T a[3][kBlock], b[3][kBlock];
  T c[3][kBlock];               ///< affine: C
  T least[3][kBlock];           ///< 0 for a top or left edge, else kAboveZero
  T e[3][kBlock];               ///< stepped: at the centre of the box's first pixel
  std::uint64_t masks[kBlock];  ///< of small ones: coverage of the 8x8 pixels from the box's corner

  /// The direct form at a pixel's centre, each operation rounded.
  T At(int k, int i, int x, int y) const {
    return (static_cast<T>(x) + T{0.5} - vx[k][i]) * a[k][i] +
           (static_cast<T>(y) + T{0.5} - vy[k][i]) * b[k][i];
  }
};

template <class T, Form kForm, bool kWithZ>
HWY_NOINLINE void SetUpEdges(const KernelView& view, const std::uint32_t* indices,
                             EdgeBlock<T>& block) {
  using DFloat = typename RealTags<T>::DFloat;
  using V = RealVec<T>;
  const RealTag<T> d;
  const DFloat df;
  const typename RealTags<T>::DInt di;
  const V zero = hn::Zero(d);
  const V half = hn::Set(d, T{0.5});
  for (int at = 0; at < kBlock; at += kReals<T>) {
    const auto corners = LoadCorners<kWithZ>(df, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(df, corners, at, block);
    const auto x0 = FirstCentreFrom(df, Min3(corners.x), view.width);
    const auto x1 = FirstCentreBeyond(df, Max3(corners.x), view.width);
    const auto y0 = FirstCentreFrom(df, Min3(corners.y), view.height);
    const auto y1 = FirstCentreBeyond(df, Max3(corners.y), view.height);
    const std::uint32_t boxed = StoreBox(di, x0, x1, y0, y1, at, block);
    V cx[3], cy[3];
    for (int k = 0; k < 3; ++k) {
      cx[k] = ToReals<T>(corners.x[k]);
      cy[k] = ToReals<T>(corners.y[k]);
    }
    // Counter-clockwise on screen from here on.
    const V area = TwiceArea(cx, cy);
    const auto is_front = hn::Gt(area, zero);
    for (V* const v : {cx, cy}) {
      const V one = hn::IfThenElse(is_front, v[1], v[2]);
      v[2] = hn::IfThenElse(is_front, v[2], v[1]);
      v[1] = one;
    }
    const V x = hn::Add(ToReals<T>(x0), half);
    const V y = hn::Add(ToReals<T>(y0), half);
    for (int k = 0; k < 3; ++k) {
      const int next = k == 2 ? 0 : k + 1;
      const V a = hn::Sub(cy[next], cy[k]);
      const V b = hn::Sub(cx[k], cx[next]);
      const auto owns_ties = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
      hn::Store(cx[k], d, block.vx[k] + at);
      hn::Store(cy[k], d, block.vy[k] + at);
      hn::Store(a, d, block.a[k] + at);
      hn::Store(b, d, block.b[k] + at);
      hn::Store(hn::IfThenElse(owns_ties, zero, hn::Set(d, kAboveZero<T>)), d, block.least[k] + at);
      if constexpr (kForm == Form::kAffine) {
        hn::Store(hn::Neg(hn::Add(hn::Mul(cx[k], a), hn::Mul(cy[k], b))), d, block.c[k] + at);
      }
      if constexpr (kForm == Form::kStepped) {
        hn::Store(hn::Add(hn::Mul(hn::Sub(x, cx[k]), a), hn::Mul(hn::Sub(y, cy[k]), b)), d,
                  block.e[k] + at);
      }
    }
    block.front |= static_cast<std::uint32_t>(MaskBits(d, is_front)) << at;
    block.drawn |= (static_cast<std::uint32_t>(HasArea(d, area)) & boxed) << at;
  }
  FindSmall(block);
}

/// One edge's share of a column (axis 0) or of a row (axis 1) of pixels `n` beyond the box's first,
/// one triangle a lane; the shares' sum is the edge function.
template <class T, Form kForm, int kAxis>
HWY_INLINE RealVec<T> ShareOf(const EdgeBlock<T>& block, int k, int at, int n) {
  const RealTag<T> d;
  const auto load = [&](const T(&p)[3][kBlock]) { return hn::Load(d, p[k] + at); };
  const auto step = kAxis == 0 ? load(block.a) : load(block.b);
  const auto count = hn::Set(d, static_cast<T>(n));
  if constexpr (kForm == Form::kStepped) {
    const auto steps = hn::Mul(step, count);
    if constexpr (kAxis == 0) return steps;
    return hn::Add(load(block.e), steps);
  } else {
    const auto first = LoadReals<T>((kAxis == 0 ? block.x0 : block.y0) + at);
    const auto centre = hn::Add(hn::Add(first, count), hn::Set(d, T{0.5}));
    if constexpr (kForm == Form::kDirect) {
      return hn::Mul(hn::Sub(centre, kAxis == 0 ? load(block.vx) : load(block.vy)), step);
    } else {
      const auto product = hn::Mul(step, centre);
      if constexpr (kAxis == 0) return product;
      return hn::Add(product, load(block.c));
    }
  }
}

/// Masks of 8x8 pixels, one triangle a lane, made bit by bit.
template <class D>
class LaneMasks {
 public:
  using U = std::make_unsigned_t<
      std::conditional_t<sizeof(hn::TFromD<D>) == 4, std::int32_t, std::int64_t> >;
  using DU_ = hn::Rebind<U, D>;

  HWY_INLINE LaneMasks() {
    for (auto& part : parts_) part = hn::Zero(DU_());
  }
  /// Sets the bits of column c of row r in the lanes of `inside`.
  HWY_INLINE void Add(int r, int c, hn::Mask<D> inside) {
    const DU_ du;
    const auto bit = hn::Set(du, U{1} << (8 * (r % kRows) + c));
    auto& part = parts_[r / kRows];
    part = hn::Or(part, hn::IfThenElseZero(hn::RebindMask(du, inside), bit));
  }
  /// The same in the lanes whose sign is positive.
  HWY_INLINE void AddUnless(int r, int c, hn::Vec<D> negative) {
    const DU_ du;
    const auto outside = hn::BitCast(du, hn::BroadcastSignBit(negative));
    const auto bit = hn::Set(du, U{1} << (8 * (r % kRows) + c));
    auto& part = parts_[r / kRows];
    part = hn::Or(part, hn::AndNot(outside, bit));
  }
  HWY_INLINE void Store(std::uint64_t* masks) const {
    constexpr int kN = kLanesOf<DU_>;
    alignas(64) U bits[kParts][kN];
    for (int part = 0; part < kParts; ++part) hn::Store(parts_[part], DU_(), bits[part]);
    for (int i = 0; i < kN; ++i) {
      masks[i] = bits[0][i];
      if constexpr (kParts == 2) masks[i] |= std::uint64_t{bits[1][i]} << 32;
    }
  }

 private:
  static constexpr int kRows = sizeof(U);  ///< of a part
  static constexpr int kParts = 8 / kRows;
  hn::Vec<DU_> parts_[kParts];
};

/// Fills in the masks of the small triangles, pixel by pixel of the largest box. kSummed: stepped
/// by sums, e + b + ... + b + a + ... + a.
template <class T, Form kForm, bool kSummed>
HWY_NOINLINE void FindSmallMasks(EdgeBlock<T>& block) {
  static_assert(!kSummed || kForm == Form::kStepped);
  const RealTag<T> d;
  using V = RealVec<T>;
  for (int at = 0; at < kBlock; at += kReals<T>) {
    if (((block.small >> at) & ((std::uint64_t{1} << kReals<T>)-1)) == 0) continue;
    V first[3], least[3], columns[3][8];
    for (int k = 0; k < 3; ++k) {
      least[k] = hn::Load(d, block.least[k] + at);
      if constexpr (kSummed) first[k] = hn::Load(d, block.e[k] + at);
      for (int c = 0; c < (kSummed ? 1 : block.width); ++c) {
        columns[k][c] =
            kSummed ? hn::Load(d, block.a[k] + at) : ShareOf<T, kForm, 0>(block, k, at, c);
      }
    }
    LaneMasks<RealTag<T> > masks;
    for (int r = 0; r < block.height; ++r) {
      V row[3];
      for (int k = 0; k < 3; ++k) {
        if constexpr (kSummed) {
          row[k] = first[k];
          first[k] = hn::Add(first[k], hn::Load(d, block.b[k] + at));
        } else {
          row[k] = ShareOf<T, kForm, 1>(block, k, at, r);
        }
      }
      for (int c = 0; c < block.width; ++c) {
        V e[3];
        for (int k = 0; k < 3; ++k) {
          if constexpr (kSummed) {
            e[k] = row[k];
            row[k] = hn::Add(row[k], columns[k][0]);
          } else {
            e[k] = hn::Add(row[k], columns[k][c]);
          }
        }
        masks.Add(r, c,
                  hn::And(hn::And(hn::Ge(e[0], least[0]), hn::Ge(e[1], least[1])),
                          hn::Ge(e[2], least[2])));
      }
    }
    masks.Store(block.masks + at);
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_EDGES_H_
