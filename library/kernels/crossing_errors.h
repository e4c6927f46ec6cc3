// How far a guess of the exact kernel (exact_crossings.h) may be from the crossing that it guesses.
#ifndef RASTERPROOF_LIBRARY_KERNELS_CROSSING_ERRORS_H_
#define RASTERPROOF_LIBRARY_KERNELS_CROSSING_ERRORS_H_

namespace rasterproof::library::kernels {

// A guess is X + (y - a.y) ((c.x - a.x) / (c.y - a.y)), X = a.x + 1/2 + error: three differences,
// the quotient and the product round once each (the product not at all where it is fused), on at
// most |c.x - a.x| <= 2M, M = max |x| over the edge's ends; then X and the sum, of at most M + 1.
// Together less than 14 u (M + 1): reference/proofs/kernel_crossing.g in float32,
// reference/proofs/row_crossing.g in double. An edge's lower end may stand for a. Every quotient
// that a row asks for is finite: a row between two floats keeps them apart. Rounded down the guess
// is the crossing unless its fraction is below twice the error, for then a centre may lie on either
// side.

/// In double, where every |x| <= kGuessDomain: 14 2^-53 (2^26 + 1) < 2^-23.
/// Measured:   largest error / bound known 0.125, as below.
inline constexpr double kCrossingError = 0x1p-22;
inline constexpr float kGuessDomain = 0x1p26F;

/// In float32, of a small triangle: M = 9, 14 2^-24 (9 + 1) < 2^-16.8, and less than 2^-16 that is
/// cut off where the guess becomes fixed point of kSmallUnit a pixel. Relative to its first pixel,
/// from which every difference is exact.
/// Measured:   largest error / bound known 0.517, as below.
inline constexpr float kSmallUnit = 0x1p16F;
inline constexpr float kSmallCrossingError = 0x1p-15F;

/// The same of a near one: M = kNearSide + 1, 14 2^-24 (65 + 1) < 2^-14.1.
/// Measured:   largest error / bound known 0.327: docs/mathematics.md, 9, has the witnesses.
inline constexpr int kNearSide = 64;
inline constexpr float kNearCrossingError = 0x1p-14F;

/// Of rows in steps of fixed point, exact_steps.h: as in double where the edge's first row crosses
/// it, cut off to 2^-32; at most 2^14 steps, each cut off to 2^-32; and twice cut off to 2^-16.
/// Together less than 2^-14: reference/proofs/kernel_steps.g.
/// Domain:     every |x| and the target's sides at most kSteppedSide, |slope| < kSteppedSlope.
/// Measured:   largest error / bound known 0.555, as below.
inline constexpr float kStepError = 0x1p-14F;
inline constexpr float kSteppedSide = 0x1p14F;
inline constexpr double kSteppedSlope = 0x1p30;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_CROSSING_ERRORS_H_
