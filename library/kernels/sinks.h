// Where covered pixels go: one class a Sink, all with the same calls, fully inlined.
//
//   Begin(triangle, is_front, plane)  before the pixels of a triangle
//   Span(row, x0, x1)                 pixels [x0, x1) of a row; x0 < x1
//   ShortSpan<K>(row, x0, n)          the same, 0 <= n <= K of 16, 32 or 64, without a branch on n
//   Mask8x8(x, y, bits)               bit 8 r + c is pixel (x + c, y + r)
//   Row32(row, x, bits)               bit c is pixel (x + c, row)
//   ShortRows(row, rows, first, last) if kTakesRows: pixels [first, last) of rows from `row` on,
//                                     one a lane; false, with nothing drawn, if one is long
//
// Domain:     x and y of the target, covered pixels inside it. Vectors may read and rewrite, with
//             what is there, up to 64 pixels of the row beyond x: Surface has room for that. So
//             threads may share a surface by rows, not by columns.
#ifndef RASTERPROOF_LIBRARY_KERNELS_SINKS_H_
#define RASTERPROOF_LIBRARY_KERNELS_SINKS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// A sink with one number a pixel. Kind says what becomes of a vector of old ones:
///   T; kNeedsPlane; Kind(view); Begin(...); plane(); BeginRow(row); New(d, old, x)
template <class Kind>
class PixelSink {
 public:
  using T = typename Kind::T;
  static constexpr bool kNeedsPlane = Kind::kNeedsPlane;
  static constexpr bool kNeedsFacing = Kind::kNeedsFacing;
  static constexpr bool kTakesRows = false;

  HWY_INLINE explicit PixelSink(const KernelView& view) : kind_(view), pitch_(view.pitch) {}

  template <class P>
  HWY_INLINE void Begin(std::uint32_t triangle, bool is_front, const P& plane) {
    kind_.Begin(triangle, is_front, plane);
  }

  HWY_INLINE void Span(int row, int x0, int x1) {
    T* p = At(row, x0);
    kind_.BeginRow(row);
    int n = x1 - x0;
    int x = x0;
    for (; n >= kWide; n -= kWide, x += kWide, p += kWide) All(DWide(), p, x);
    if (n > 0) First(DWide(), p, x, n);
  }

  template <int kMost>
  HWY_INLINE void ShortSpan(int row, int x0, int n) {
    using D = hn::CappedTag<T, kMost>;
    constexpr int kN = kLanesOf<D>;
    T* p = At(row, x0);
    kind_.BeginRow(row);
    First(D(), p, x0, Least(n, kN));
    for (int at = kN; at < n; at += kN) First(D(), p + at, x0 + at, Least(n - at, kN));
  }

  HWY_INLINE void Mask8x8(int x, int y, std::uint64_t bits) {
    T* p = At(y, x);
    Rows<0>(p, x, y, bits);
    // Most small triangles end in the upper half; a branch for each row costs more than empty rows.
    if (bits >> 32 != 0) Rows<4>(p, x, y, bits);
  }

  HWY_INLINE void Row32(int row, int x, std::uint32_t bits) {
    kind_.BeginRow(row);
    Bits<32>(At(row, x), x, bits);
  }

 private:
  using DWide = hn::ScalableTag<T>;
  static constexpr int kWide = kLanesOf<DWide>;

  HWY_INLINE T* At(int row, int x) const { return kind_.plane() + row * pitch_ + x; }

  template <class D>
  HWY_INLINE void All(D d, T* p, int x) {
    hn::StoreU(kind_.New(d, hn::LoadU(d, p), x), d, p);
  }
  template <class D>
  HWY_INLINE void Some(D d, T* p, int x, hn::Mask<D> mask) {
    const auto old = hn::LoadU(d, p);
    hn::StoreU(hn::IfThenElse(mask, kind_.New(d, old, x), old), d, p);
  }
  template <class D>
  HWY_INLINE void First(D d, T* p, int x, int n) {
    Some(d, p, x, hn::FirstN(d, static_cast<std::size_t>(n)));
  }
  template <int kFirst>
  HWY_INLINE void Rows(T* p, int x, int y, std::uint64_t bits) {
    for (int r = kFirst; r < kFirst + 4; ++r) {
      kind_.BeginRow(y + r);
      Bits<8>(p + r * pitch_, x, bits >> (8 * r));
    }
  }
  template <int kMost>
  HWY_INLINE void Bits(T* p, int x, std::uint64_t bits) {
    using D = hn::CappedTag<T, kMost>;
    constexpr int kN = kLanesOf<D>;
    for (int at = 0; at < kMost; at += kN) Some(D(), p + at, x + at, MaskOf(D(), bits >> at));
  }

  Kind kind_;
  std::ptrdiff_t pitch_;
};

class Count8 {
 public:
  using T = std::uint8_t;
  static constexpr bool kNeedsPlane = false;
  static constexpr bool kNeedsFacing = false;

  HWY_INLINE explicit Count8(const KernelView& view) : plane_(static_cast<T*>(view.planes[0])) {}
  template <class P>
  HWY_INLINE void Begin(std::uint32_t /*triangle*/, bool /*is_front*/, const P& /*plane*/) {}
  HWY_INLINE T* plane() const { return plane_; }
  HWY_INLINE void BeginRow(int /*row*/) {}
  template <class D>
  HWY_INLINE hn::Vec<D> New(D d, hn::Vec<D> old, int /*x*/) const {
    return hn::SaturatedAdd(old, hn::Set(d, T{1}));
  }

 private:
  T* plane_;
};

class Facing {
 public:
  using T = std::uint32_t;
  static constexpr bool kNeedsPlane = false;
  static constexpr bool kNeedsFacing = true;

  HWY_INLINE explicit Facing(const KernelView& view)
      : front_(static_cast<T*>(view.planes[0])), back_(static_cast<T*>(view.planes[1])) {}
  template <class P>
  HWY_INLINE void Begin(std::uint32_t /*triangle*/, bool is_front, const P& /*plane*/) {
    plane_ = is_front ? front_ : back_;
  }
  HWY_INLINE T* plane() const { return plane_; }
  HWY_INLINE void BeginRow(int /*row*/) {}
  template <class D>
  HWY_INLINE hn::Vec<D> New(D d, hn::Vec<D> old, int /*x*/) const {
    return hn::Add(old, hn::Set(d, T{1}));
  }

 private:
  T* front_;
  T* back_;
  T* plane_ = nullptr;
};

class Id {
 public:
  using T = std::uint32_t;
  static constexpr bool kNeedsPlane = false;
  static constexpr bool kNeedsFacing = false;

  HWY_INLINE explicit Id(const KernelView& view) : plane_(static_cast<T*>(view.planes[0])) {}
  template <class P>
  HWY_INLINE void Begin(std::uint32_t triangle, bool /*is_front*/, const P& /*plane*/) {
    triangle_ = triangle;
  }
  HWY_INLINE T* plane() const { return plane_; }
  HWY_INLINE void BeginRow(int /*row*/) {}
  template <class D>
  HWY_INLINE hn::Vec<D> New(D d, hn::Vec<D> /*old*/, int /*x*/) const {
    return hn::Set(d, triangle_);
  }

 private:
  T* plane_;
  T triangle_ = 0;
};

class Depth {
 public:
  using T = float;
  static constexpr bool kNeedsPlane = true;
  static constexpr bool kNeedsFacing = false;

  HWY_INLINE explicit Depth(const KernelView& view) : plane_(static_cast<T*>(view.planes[0])) {}
  HWY_INLINE void Begin(std::uint32_t /*triangle*/, bool /*is_front*/, const Plane& plane) {
    z_ = plane;
  }
  HWY_INLINE T* plane() const { return plane_; }
  HWY_INLINE void BeginRow(int row) { row_z_ = z_.zc + z_.zy * (static_cast<float>(row) + 0.5F); }
  template <class D>
  HWY_INLINE hn::Vec<D> New(D d, hn::Vec<D> old, int x) const {
    const auto centres = FloatsFrom(d, static_cast<float>(x) + 0.5F);
    const auto plane = hn::Add(hn::Set(d, row_z_), hn::Mul(hn::Set(d, z_.zx), centres));
    const auto z = Clamped(d, plane, z_.least, z_.most);
    return hn::IfThenElse(hn::Lt(z, old), z, old);
  }

 private:
  T* plane_;
  Plane z_ = {};
  float row_z_ = 0;
};

/// z / w of clip space, computed in double and rounded to float32; beyond float32's range its
/// largest number of that sign.
class ClipDepth {
 public:
  using T = float;
  static constexpr bool kNeedsPlane = true;
  static constexpr bool kNeedsFacing = false;

  HWY_INLINE explicit ClipDepth(const KernelView& view) : plane_(static_cast<T*>(view.planes[0])) {}
  HWY_INLINE void Begin(std::uint32_t /*triangle*/, bool /*is_front*/, const ClipPlane& plane) {
    z_ = plane;
  }
  HWY_INLINE T* plane() const { return plane_; }
  HWY_INLINE void BeginRow(int row) { row_z_ = z_.zc + z_.zy * (row + 0.5); }
  template <class D>
  HWY_INLINE hn::Vec<D> New(D d, hn::Vec<D> old, int x) const {
    const auto z = At(d, x + 0.5);
    return hn::IfThenElse(hn::Lt(z, old), z, old);
  }

 private:
  static constexpr double kMostDepth = 0x1.fffffep127;

#if HWY_TARGET == HWY_SCALAR
  template <class D>
  HWY_INLINE hn::Vec<D> At(D d, double x) const {
    const double z = row_z_ + z_.zx * x;
    // NaN stays.
    return hn::Set(d, static_cast<float>(z > kMostDepth    ? kMostDepth
                                         : z < -kMostDepth ? -kMostDepth
                                                           : z));
  }
#else
  template <class D>
  HWY_INLINE hn::Vec<D> At(D d, double x) const {
    const hn::RepartitionToWide<hn::RebindToSigned<D> > wide_integers;
    const hn::RebindToFloat<decltype(wide_integers)> wide;
    const hn::Half<D> half;
    constexpr int kN = kLanesOf<decltype(wide)>;
    const auto zs = [&](double first) {
      const auto centres = hn::Add(hn::Set(wide, first), hn::Load(wide, kFirstDoubles));
      const auto z = hn::Add(hn::Set(wide, row_z_), hn::Mul(hn::Set(wide, z_.zx), centres));
      const auto most = hn::Set(wide, kMostDepth);
      const auto least = hn::Set(wide, -kMostDepth);
      const auto below = hn::IfThenElse(hn::Gt(z, most), most, z);  // NaN stays
      return hn::DemoteTo(half, hn::IfThenElse(hn::Lt(below, least), least, below));
    };
    return hn::Combine(d, zs(x + kN), zs(x));
  }
#endif

  T* plane_;
  ClipPlane z_ = {};
  double row_z_ = 0;
};

/// One bit a pixel, pixel x at bit x & 7 of byte x >> 3.
class MaskSink {
 public:
  static constexpr bool kNeedsPlane = false;
  static constexpr bool kNeedsFacing = false;
  static constexpr bool kTakesRows = true;

  HWY_INLINE explicit MaskSink(const KernelView& view)
      : plane_(static_cast<std::uint8_t*>(view.planes[0])), pitch_(view.pitch) {}
  template <class P>
  HWY_INLINE void Begin(std::uint32_t /*triangle*/, bool /*is_front*/, const P& /*plane*/) {}

  HWY_INLINE void Span(int row, int x0, int x1) {
    std::uint8_t* line = plane_ + row * pitch_;
    const int first = x0 >> 6;
    const int last = (x1 - 1) >> 6;
    const std::uint64_t from = ~std::uint64_t{0} << (x0 & 63);
    const std::uint64_t to = ~std::uint64_t{0} >> (63 - ((x1 - 1) & 63));
    if (first == last) {
      Or(line + 8 * first, from & to);
      return;
    }
    Or(line + 8 * first, from);
    if constexpr (kBytes > 1) {
      Fill(line + 8 * (first + 1), 8 * (last - first - 1));
    } else {
      for (int word = first + 1; word < last; ++word) {
        const std::uint64_t all = ~std::uint64_t{0};
        __builtin_memcpy(line + 8 * word, &all, 8);
      }
    }
    Or(line + 8 * last, to);
  }

  template <int kMost>
  HWY_INLINE void ShortSpan(int row, int x0, int n) {
    std::uint8_t* line = plane_ + row * pitch_;
    if constexpr (kMost <= 32) {
      Or(line + (x0 >> 3), ((std::uint64_t{1} << n) - 1) << (x0 & 7));
    } else {
      // A shift by 64 is undefined: by n - 1 and one more.
      const std::uint64_t bits = n > 0 ? ~std::uint64_t{0} >> (64 - n) : 0;
      const int shift = x0 & 7;
      Or(line + (x0 >> 3), bits << shift);
      line[(x0 >> 3) + 8] |= static_cast<std::uint8_t>(bits >> 1 >> (63 - shift));
    }
  }

  HWY_INLINE bool ShortRows(int row, int rows, VI first, VI last) {
    constexpr int kMost = 25;  // with up to 7 bits before them
    const DI di;
    const VI lane = hn::ConvertTo(di, FloatsFrom(DF(), 0));
    const auto valid = hn::Lt(lane, hn::Set(di, rows));
    const VI n = hn::IfThenElseZero(valid, hn::Sub(last, first));
    if (MaskBits(di, hn::Gt(n, hn::Set(di, kMost))) != 0) return false;
    if (pitch_ >= std::ptrdiff_t{1} << 26) return false;  // the last lane's row, in 32 bits
    const VI one = hn::Set(di, 1);
    const VI bits = hn::Shl(hn::Sub(hn::Shl(one, n), one), hn::And(first, hn::Set(di, 7)));
    const VI line = hn::Mul(lane, hn::Set(di, static_cast<std::int32_t>(pitch_)));
    const VI bytes = hn::IfThenElseZero(valid, hn::Add(line, hn::ShiftRight<3>(first)));
    alignas(64) std::int32_t at[kLanes], words[kLanes];
    hn::Store(bytes, di, at);
    hn::Store(bits, di, words);
    std::uint8_t* p = plane_ + row * pitch_;
    for (int r = 0; r < kLanes; ++r) {  // no branch for empty ones
      std::uint32_t word;
      __builtin_memcpy(&word, p + at[r], 4);
      word |= static_cast<std::uint32_t>(words[r]);
      __builtin_memcpy(p + at[r], &word, 4);
    }
    return true;
  }

  HWY_INLINE void Mask8x8(int x, int y, std::uint64_t bits) {
    std::uint8_t* p = plane_ + y * pitch_ + (x >> 3);
    const int shift = x & 7;
    for (int r = 0; r < 4; ++r) Or16(p + r * pitch_, ((bits >> (8 * r)) & 0xff) << shift);
    if (bits >> 32 == 0) return;
    for (int r = 4; r < 8; ++r) Or16(p + r * pitch_, ((bits >> (8 * r)) & 0xff) << shift);
  }

  HWY_INLINE void Row32(int row, int x, std::uint32_t bits) {
    Or(plane_ + row * pitch_ + (x >> 3), std::uint64_t{bits} << (x & 7));
  }

 private:
  // Vectors of 64 bytes, which would lie across lines, take twice as long as these.
  using D = hn::CappedTag<std::uint8_t, 32>;
  static constexpr int kBytes = kLanesOf<D>;

  // All bits of whole words. Vectors leave full ones as they are.
  HWY_INLINE static void Fill(std::uint8_t* p, int bytes) {
    if (bytes < kBytes) {
      for (int at = 0; at < bytes; at += 8) Or(p + at, ~std::uint64_t{0});
      return;
    }
    const auto all = hn::Set(D(), std::uint8_t{255});
    const auto fill = [all](std::uint8_t* at) {
      if (!hn::AllTrue(D(), hn::Eq(hn::LoadU(D(), at), all))) hn::StoreU(all, D(), at);
    };
    for (int at = 0; at < bytes - kBytes; at += kBytes) fill(p + at);
    fill(p + bytes - kBytes);
  }
  HWY_INLINE static void Or(std::uint8_t* p, std::uint64_t bits) {
    std::uint64_t word;
    __builtin_memcpy(&word, p, 8);
    word |= bits;
    __builtin_memcpy(p, &word, 8);
  }
  HWY_INLINE static void Or16(std::uint8_t* p, std::uint64_t bits) {
    std::uint16_t word;
    __builtin_memcpy(&word, p, 2);
    word = static_cast<std::uint16_t>(word | bits);
    __builtin_memcpy(p, &word, 2);
  }

  std::uint8_t* plane_;
  std::ptrdiff_t pitch_;
};

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_SINKS_H_
