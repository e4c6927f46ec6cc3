// What the subjects that interpolate in a shader have in common: one mesh, drawn in passes of four
// channels, and five outputs of four floats.
#ifndef RASTERPROOF_SUBJECTS_SHADED_SHADED_H_
#define RASTERPROOF_SUBJECTS_SHADED_SHADED_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "kit/rasterproof_plugin.h"

namespace rasterproof::subjects {

/// Floats of a corner: its clip coordinates and four numbers. Corners are not shared, and a
/// shader knows the place of its vertex in its triangle.
inline constexpr std::size_t kCornerFloats = 8;

/// What the shader writes, four floats each. The target is empty, all zeros, before the draw.
enum ShaderOutput : std::uint8_t {
  kTriangle,  ///< the number of the triangle, from 1
  kPlace,     ///< the barycentrics, as three interpolated unit vectors, and the depth
  kValue,
  kByX,
  kByY,
  kShaderOutputs
};

/// How each of the four numbers of a pass is interpolated, and where: enum
/// rasterproof_interpolation + 4 * enum rasterproof_at. With one sample a pixel the three places
/// are one, its centre.
using PassKinds = std::array<std::int32_t, 4>;

/// Appends x and y of a vertex (x, y, z, w) as clip coordinates, which the driver takes back to the
/// window exactly: the viewport is centred on the origin and a power of two wide, so that
/// window = clip * half_viewport + 0. False where the driver would clip or round them.
bool AddClipPlace(const double* vertex, double half_viewport, std::vector<float>& clip);

/// Draws the corners of the scene, which it puts together in `corners`, by `paint`: returns the
/// texels [output][row][column * samples][4].
///
/// Returns:    0, or 1 if the scene is out of range or the target has another number of samples.
std::int32_t DrawInPasses(const rasterproof_scene& scene, const rasterproof_target& target,
                          double half_viewport, int samples, std::vector<float>& corners,
                          const std::function<const float*(const PassKinds&)>& paint);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_SHADED_SHADED_H_
