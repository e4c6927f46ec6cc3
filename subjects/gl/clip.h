// Window coordinates as clip coordinates that the driver takes back to them exactly.
#ifndef RASTERPROOF_SUBJECTS_GL_CLIP_H_
#define RASTERPROOF_SUBJECTS_GL_CLIP_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace rasterproof::subjects {

/// The viewport is centred on the origin and a power of two wide, so that window = clip * 8192 + 0,
/// and clip = window / 8192 is exact for every float32 that does not leave the normal range; w is
/// handed on as it is.
inline constexpr double kHalfViewport = 8192;  // nothing within is clipped

/// Returns x and y of a vertex (x, y, z, w); nothing where the driver would clip or round them.
inline std::optional<std::array<float, 2>> ClipPlace(const double* vertex) {
  std::array<float, 2> clip{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double scaled = vertex[k];
    // A NaN passes: what becomes of it is the driver's to say. What would be clipped does not.
    if (std::fabs(scaled) > kHalfViewport * vertex[3]) return std::nullopt;
    clip[k] = static_cast<float>(scaled / kHalfViewport);
    if (!std::isnan(scaled) && double{clip[k]} * kHalfViewport != scaled) return std::nullopt;
  }
  return clip;
}

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_CLIP_H_
