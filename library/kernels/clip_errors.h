// How far what the kernel of clip space (clip_rows.h) computes may be from what it stands for, in
// double but where float32 is named. u = 2^-53.
#ifndef RASTERPROOF_LIBRARY_KERNELS_CLIP_ERRORS_H_
#define RASTERPROOF_LIBRARY_KERNELS_CLIP_ERRORS_H_

#include "library/kernels/crossing_errors.h"

namespace rasterproof::library::kernels {

// Coordinates are float32, so products of two of them are exact, N = V_j x V_i is off by u in each
// component and its signs are exact. Nothing over- or underflows: |N| is 0 or between 2^-298 and
// 2^257.

/// Of N . (x, y, w), in units of the sum of its three computed terms' sizes: a term carries the
/// component, its product and two sums, 4.1 u, and the sizes' own rounding takes less than 0.5 u.
/// So signs beyond it are certain. The same holds of D = V0 . (V2 x V1).
/// Proof:      reference/proofs/clip_kernel.g.
/// Measured:   largest error / bound 0.488, ClipKernel.GuessesAndFiltersStayWithinTheirErrors by
///             `./run test-more`.
inline constexpr double kClipDotError = 0x1.4p-51;

/// Of the near plane's sum of n_k (N . (x, y, 1)), N of the edge opposite corner k, n_k = z_k or
/// z_k + w_k, in units of the sum of its nine terms' sizes: the same, and n_k, its product and two
/// sums: 8.1 u, and the sizes' own rounding takes less than 1 u.
/// Proof:      reference/proofs/clip_kernel.g.
/// Measured:   largest error / bound 0.318, by the same test.
inline constexpr double kClipNearError = 0x1.4p-50;

/// Of a guess -(ny y + nw) / nx + 1/2 + error, computed as y s + (f + (1/2 + error)), s = -ny / nx,
/// f = -nw / nx, in units of |s| y + |f| + 1, y the largest one: the quotients are off by 4u (both
/// components, a reciprocal, a product), and a product and two sums round after them: less than
/// 15 u. Of 16 u the unit's own rounding leaves 15.8 u.
/// Proof:      reference/proofs/clip_kernel.g.
/// Measured:   largest error / bound 0.243, by the same test.
inline constexpr double kClipCrossingError = 0x1p-49;

/// Of a guess of where a row crosses the near plane, -(b y + c) / a + 1/2 + error: a, b and c are
/// sums over corners of n_k and a component of N, as above, of three terms whose sizes have the
/// sums A, B and C. Computed as of an edge, in units of unit = |s| y + |f| + 1: kClipCrossingError
/// holds of what the computed a, b and c stand for. These are off by 5.1 u of A, B and C (the
/// component, n_k, a product and two sums), which moves the crossing by 5.1 u (A unit + B y + C) /
/// |a|: of 8 u the sizes' own rounding, and that of a and of the quotient, leave 7.9 u where the
/// error is less than kClipWorstGuess.
/// Proof:      reference/proofs/clip_kernel.g.
/// Measured:   largest error / bound 0.158, by the same test.
inline constexpr double kClipNearCrossingError = 0x1p-50;

// Triangles before the eye and the near plane, wholly on the target, of boxes up to kNearSide a
// side, are guessed in float32 (clip_floats.h), v = 2^-24. A corner relative to the first pixel of
// its box, (x - w x0) / w, is a fused difference, a reciprocal and their product: off by 3.01 v of
// itself; a w of tame size keeps what underflows below 2^-80. Where the row at y lies
// between both ends of an edge, true and computed, the point of one that the same share of the way
// leads to on the other is off by as much in x and in y: so the crossing moves by (1 + s) times a
// corner's error, s the slope |dx / dy| of the computed edge. On top comes what the guess from
// computed corners is off: crossing_errors.h.

/// Domain of w: 1 / kClipTameW to kClipTameW.
inline constexpr float kClipTameW = 0x1p60F;

/// A short edge that a row asks for, or the long edge, that is flatter is not told.
inline constexpr float kClipFloatSlope = 32;

/// A corner nearer to a row's centre, or to the end of the box's columns, is not told: it may lie
/// on its other side. 3.01 v 65, and v 65 for the difference, < 2^-15.
/// Proof:      reference/proofs/clip_floats.g.
/// Measured:   largest error / bound 0.231, ClipKernel.FloatGuessesStayWithinTheirErrors by
///             `./run test-more`.
inline constexpr float kClipCornerRoom = 0x1p-15F;

/// Of a small triangle, M = 9: 3.01 v 9 (1 + 32.01), and 2^-15 of kSmallCrossingError: < 2^-13.
/// Proof:      reference/proofs/clip_floats.g.
/// Measured:   largest error / bound 0.191, by the same test.
inline constexpr float kClipSmallCrossingError = 0x1p-13F;

/// The same of a near one, M = 65: 3.01 v 65 (1 + 32.01), and 2^-14 of kNearCrossingError.
/// Proof:      reference/proofs/clip_floats.g.
/// Measured:   largest error / bound 0.228, by the same test.
inline constexpr float kClipBoxCrossingError = 0x1p-11F;

/// Of larger ones in steps of fixed point, of edges whose guess in double is off by at most
/// kStepError: that, and what steps add, which kStepError holds, with the sum of it and the guess.
/// Proof:      reference/proofs/clip_floats.g.
/// Measured:   largest error / bound 0.272, by the same test.
inline constexpr float kClipStepError = 2 * kStepError;

/// A corner nearer to a row's centre is not told there: y / w is off by 2 u of at most
/// kSteppedSide, and a difference rounds: < 2^-37.
/// Proof:      reference/proofs/clip_floats.g.
/// Measured:   largest error / bound 0.00271, by the same test.
inline constexpr double kClipRowRoom = 0x1p-30;

/// A guess that may be off by more than this decides nothing: its row is searched exactly.
inline constexpr double kClipWorstGuess = 0x1p-10;

/// Depth in double: a D of less than this, in units of the sum of its terms' sizes, is computed
/// exactly: so 1 / |D| is off by a relative 2^-24 at most.
inline constexpr double kClipPlainDeterminant = 0x1p-26;

/// Of the depth z at (x, y), where |z| is no larger than float32's largest number (else that is
/// stored): |computed - exact| <= 2^-24 |z| + 2^-150 + kClipDepthError (M + |z| S) / |D|: M is the
/// sum over corners k of |z_k| (|N.x| x + |N.y| y + |N.w|), N of the opposite edge, S the sum of
/// the sizes of D's three terms. A coefficient carries its N, a product, two sums and the quotient,
/// and then a product and two sums: 8.1 u of M; D is off by 4.1 u of S, or by u. Then z rounds to
/// float32.
/// Proof:      reference/proofs/clip_kernel.g.
/// Measured:   largest error / bound 0.998, of what comes before the last rounding 0.103,
///             ClipKernel.DepthsStayWithinTheirBound by `./run test-more`.
inline constexpr double kClipDepthError = 0x1.2p-50;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_CLIP_ERRORS_H_
