// How large a target may be: one limit for the oracle, for subjects and for what is said to them.
#ifndef RASTERPROOF_CORE_TARGET_SIZE_H_
#define RASTERPROOF_CORE_TARGET_SIZE_H_

#include <string>

namespace rasterproof {

/// Whether the sides are 1 to kMaxTargetSide, there are 1 to kMaxSamplesPerPixel samples in a pixel
/// and kMaxTargetSamples at most in all.
bool IsTargetSize(int width, int height, int samples);

/// Error:      InputError that names `place` unless IsTargetSize().
void RequireTargetSize(const std::string& place, int width, int height, int samples);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TARGET_SIZE_H_
