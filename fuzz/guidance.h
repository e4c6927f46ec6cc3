// How wrong an input is and how near an edge value is to zero, told to libFuzzer as if they were
// branches taken: an input that is more wrong than all before is kept, and changed further.
#ifndef RASTERPROOF_FUZZ_GUIDANCE_H_
#define RASTERPROOF_FUZZ_GUIDANCE_H_

#include <cstddef>

namespace rasterproof::fuzz {

/// Subjects under a property, or subjects, that are told apart. What is beyond shares the last.
inline constexpr std::size_t kGuidedSlots = 8;

/// An error over its bound, in finer steps the nearer it comes to 1. Larger ones are violations,
/// and reported.
///
/// Domain:     any; nothing is noted of 0 or NaN.
void NoteErrorOverBound(std::size_t slot, double ratio);

/// An edge value that is not zero beside the sum of its products' magnitudes: noted by the binary
/// orders of magnitude that it lost.
///
/// Domain:     any; nothing is noted of a value of 0, or of values that are not finite.
void NoteNearZero(std::size_t slot, double value, double sum_of_products);

/// The largest error over its bound that was noted of the slot in this process; 0 if none was.
double LargestErrorOverBound(std::size_t slot);

}  // namespace rasterproof::fuzz

#endif  // RASTERPROOF_FUZZ_GUIDANCE_H_
