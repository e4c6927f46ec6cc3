// Where coverage is decided.
#ifndef RASTERPROOF_CORE_SAMPLE_PATTERN_H_
#define RASTERPROOF_CORE_SAMPLE_PATTERN_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/vertex.h"

namespace rasterproof {

/// The sample locations of one pixel, repeated over the target.
///
/// Domain:     at least one location; each coordinate in [0, 1) and a multiple of 2^-8, so that
///             pixel + location is exact in double (and in float32 up to 2^15).
/// Units:      pixels from the pixel's corner of least x and y. The default is the pixel centre.
struct SamplePattern {
  // Not from a list: inlined often, g++ 12 takes the list's constant for uninitialized.
  std::vector<Point2> locations = std::vector<Point2>(1, Point2{0.5, 0.5});

  int samples() const { return static_cast<int>(locations.size()); }
  /// The window position of sample s of pixel (i, j). Exact.
  Point2 At(int i, int j, int s = 0) const {
    const Point2& l = locations[static_cast<std::size_t>(s)];
    return {i + l.x, j + l.y};
  }
  friend bool operator==(const SamplePattern&, const SamplePattern&) = default;
};

inline constexpr int kMaxSamplesPerPixel = 64;

/// The standard pattern of 1, 2, 4, 8 or 16 samples: Direct3D 11.3 section 19.2.4, and Vulkan's
/// Standard Sample Locations, which are the same. Nothing for other numbers.
std::optional<SamplePattern> StandardPattern(int samples);

/// The statement about where samples lie.
enum class SamplePositions : std::uint8_t {
  kStated,  ///< where the pattern says, in every pixel
  kFixed,   ///< anywhere in the pixel, in every pixel alike; the pattern says how many there are
  kVary     ///< anywhere in the pixel, and not alike in every pixel
};

/// The statement about the point where a fragment's attributes are evaluated if requested at its
/// centroid. With one sample in a pixel it is the pixel's centre, by either rule.
enum class Centroid : std::uint8_t {
  kUnstated,
  kDirect3D,  ///< the centre if every sample is covered, else the covered sample of least index
  kInside     ///< any point of the closed pixel and the closed triangle
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SAMPLE_PATTERN_H_
