// What the correctly rounded values of nearest_spans.h may be off before they are rounded.
//
// Places are counted from the corner of a pixel of the triangle, (left, top), so that errors are
// of its size: x - left w is rounded once, as left w has 40 bits. In a line a x + b y + c of n, d a
// coefficient has 7 roundings at most (both factors, the product, a difference of two, the product
// with the number, two sums; w times a number is exact), a x, b y and both sums have 3: no product
// carries more than 10. Nor does the reach, the sum of the sizes of all at a place no nearer to
// (left, top): (1 + u)^10 - 1 <= 11u (1 - u)^10.
//
// For |n' - n| <= e |n'| and |d' - d| <= e |d'|, e = kQuickShare, and a quotient q within
// kQuotientError of n' / d', n / d is within 3 2^-41 |q| (1 + 2^-39) of q: 12288 of its last places
// of the kQuickDoubt that are asked.
//
// With AVX-512 it is found by an estimate r of 14 bits: h = 1 - d r, |h| <= 2^-14, and
// n / d = n r (1 + h + h^2) / (1 - h^3): off by 2^-42 and 4 roundings. 1 / d likewise, and n times
// that one rounding more.
// Proof:      reference/proofs/library_nearest.g.
#ifndef RASTERPROOF_LIBRARY_KERNELS_VALUE_ERRORS_H_
#define RASTERPROOF_LIBRARY_KERNELS_VALUE_ERRORS_H_

#include <cstdint>

namespace rasterproof::library::kernels {

/// Of a line, in shares of its reach.
/// Measured:   largest error / bound 0.232, NearestValues.LinesStayWithinTheirReach.
constexpr double kLineError = 11 * 0x1p-53;

/// Of the quotient or of 1 / d, relative, besides what n and d are off.
constexpr double kQuotientError = 0x1p-41;

/// Of n and of d, relative: up to here nothing is asked but whether they keep it.
constexpr double kQuickShare = 0x1p-41;

/// Below this share a general bound is stated.
constexpr double kMostShare = 0x1p-28;

/// In units of a double's last place: 2^53 (2 kQuickShare + kQuotientError), and what is of second
/// order. A power of two, as the kernel wants it.
constexpr std::int64_t kQuickDoubt = std::int64_t{1} << 14;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_VALUE_ERRORS_H_
