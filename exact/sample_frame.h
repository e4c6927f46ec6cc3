// Where the samples of a target lie, in screen axes (x right, y down) for either y axis of the
// profile.
#ifndef RASTERPROOF_EXACT_SAMPLE_FRAME_H_
#define RASTERPROOF_EXACT_SAMPLE_FRAME_H_

#include <array>
#include <optional>
#include <vector>

#include "core/draw_options.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "model/target_profile.h"

namespace rasterproof::exact {

/// Sample s of column i and row r (from the top) lies at (i + offsets[s].x, r + offsets[s].y).
///
/// With y up, row r holds the pixels j = H - 1 - r and their samples lie at y = j + l.y. Turning
/// the axis over (y -> -y, the only change made to a vertex) puts them at r - (H - 1) - l.y.
struct SampleFrame {
  std::vector<Point2> offsets;
  PixelRect clip;  ///< target and scissor
  TieRule rule;
  Snap scanline_rounding;  ///< of the profile
  bool y_up = false;

  /// Makes the frame of the scene's target.
  /// Error: LocationError().
  SampleFrame(const Scene& scene, const TargetProfile& profile, const DrawOptions& options);

  Point2 At(int i, int row, std::size_t s) const { return {i + offsets[s].x, row + offsets[s].y}; }
  /// The vertex in screen axes.
  Point2 ToScreen(Point2 p) const { return y_up ? Point2{p.x, -p.y} : p; }
  Vertex ToScreen(const Vertex& v) const { return y_up ? Vertex{v.x, -v.y, v.z, v.w} : v; }
};

/// Returns the error that a location of the profile is not a multiple of 2^-20 in [0, 1), so that
/// pixel + location could round. Nothing if all are.
std::optional<InputError> LocationError(const Profile& profile);

/// The scene's triangle in screen axes, or nothing if an x, y or w is not finite.
std::optional<std::array<Vertex, 3>> ScreenTriangle(const Scene& scene, const Triangle& t,
                                                    const SampleFrame& frame);

/// The first row in [begin, end] whose samples at row + offset lie at or below y (strictly below if
/// `strict`); `end` if there is none. Exact.
int FirstRowAtOrBelow(double y, bool strict, double offset, int begin, int end);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SAMPLE_FRAME_H_
