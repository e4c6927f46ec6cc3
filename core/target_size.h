// How large a target may be: one limit for the oracle, for subjects and for their protocols.
#ifndef RASTERPROOF_CORE_TARGET_SIZE_H_
#define RASTERPROOF_CORE_TARGET_SIZE_H_

#include <optional>
#include <string>

#include "core/error.h"

namespace rasterproof {

/// Whether the sides are 1 to kMaxTargetSide, there are 1 to kMaxSamplesPerPixel samples in a pixel
/// and kMaxTargetSamples at most in all.
bool IsTargetSize(int width, int height, int samples);

/// Returns nothing if IsTargetSize(), else the error that names `place`.
std::optional<InputError> TargetSizeError(const std::string& place, int width, int height,
                                          int samples);

/// Error:      TargetSizeError().
void RequireTargetSize(const std::string& place, int width, int height, int samples);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TARGET_SIZE_H_
