// Reports to libFuzzer how wrong an input is and how near an edge value is to zero, as if they were
// branches taken: an input with a larger error than all before is kept and mutated further.
#ifndef RASTERPROOF_FUZZ_GUIDANCE_H_
#define RASTERPROOF_FUZZ_GUIDANCE_H_

#include <cstddef>

namespace rasterproof::fuzz {

/// The number of slots, one for a subject under a property, or for a subject. Further ones share
/// the last.
inline constexpr std::size_t kGuidedSlots = 8;

/// Notes an error over its bound, in finer steps the nearer it is to 1. Larger ones are violations,
/// and reported.
///
/// Domain:     any; nothing is noted of 0 or NaN.
void NoteErrorOverBound(std::size_t slot, double ratio);

/// Notes how small a nonzero edge value is against the sum of its products' magnitudes, in binary
/// orders of magnitude.
///
/// Domain:     any; nothing is noted of a value of 0, or of values that are not finite.
void NoteNearZero(std::size_t slot, double value, double sum_of_products);

/// The largest error over its bound that was noted of the slot in this process; 0 if none was.
double LargestErrorOverBound(std::size_t slot);

}  // namespace rasterproof::fuzz

#endif  // RASTERPROOF_FUZZ_GUIDANCE_H_
