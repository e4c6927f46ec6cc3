// The numbers at a scene's vertices that a rasterizer interpolates.
#ifndef RASTERPROOF_CORE_CHANNEL_H_
#define RASTERPROOF_CORE_CHANNEL_H_

#include <cstdint>

namespace rasterproof {

/// How a number between the vertices follows from those at the vertices.
enum class Interpolation : std::uint8_t {
  kFlat,         ///< the provoking vertex's, everywhere
  kLinear,       ///< affine on the screen (noperspective)
  kPerspective,  ///< affine in the space before the division by w
  kInverseW      ///< 1/w itself, which needs no numbers at the vertices
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CHANNEL_H_
