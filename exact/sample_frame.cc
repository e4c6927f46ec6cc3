#include "exact/sample_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "model/target_profile.h"

namespace rasterproof::exact {
namespace {

// Pixel indices and H - 1 are below 2^17: with 20 fractional bits every position has at most 38.
constexpr double kLocationsPerPixel = 0x1p20;

bool IsLocation(double c) {
  const double scaled = c * kLocationsPerPixel;
  return c >= 0 && c < 1 && scaled == std::floor(scaled);
}

}  // namespace

std::optional<InputError> LocationError(const Profile& profile) {
  const auto is_location = [](const Point2& l) { return IsLocation(l.x) && IsLocation(l.y); };
  if (std::ranges::all_of(profile.pattern.locations, is_location)) return std::nullopt;
  return InputError("profile \"" + profile.name + "\"",
                    "a sample location is not a multiple of 2^-20 in [0, 1)",
                    "state the locations as fractions of a pixel on a power-of-two grid");
}

SampleFrame::SampleFrame(const Scene& scene, const TargetProfile& profile,
                         const DrawOptions& options)
    : clip{0, 0, scene.width, scene.height},
      rule(profile.tie_rule),
      scanline_rounding(profile.scanline_rounding),
      y_up(profile.y_axis == YAxis::kUp) {
  if (const auto error = LocationError(profile)) throw InputError(*error);
  for (const Point2& l : profile.pattern.locations) {
    offsets.push_back(y_up ? Point2{l.x, -(scene.height - 1) - l.y} : l);
  }
  if (options.scissor) {
    const PixelRect& s = *options.scissor;
    clip = {std::max(clip.x0, s.x0), std::max(clip.y0, s.y0), std::min(clip.x1, s.x1),
            std::min(clip.y1, s.y1)};
  }
}

std::optional<std::array<Vertex, 3>> ScreenTriangle(const Scene& scene, const Triangle& t,
                                                    const SampleFrame& frame) {
  std::array<Vertex, 3> v = Corners(scene, t);
  for (Vertex& corner : v) {
    if (!IsFinite(corner)) return std::nullopt;
    corner = frame.ToScreen(corner);
  }
  return v;
}

int FirstRowAtOrBelow(double y, bool strict, double offset, int begin, int end) {
  // The difference is rounded, by less than one row near the target, and a huge y stays huge. The
  // guess is thus at most one row late, and starting two rows early misses none.
  const double guess = std::floor(y - offset) - 2;
  if (guess >= end) return end;
  int row = guess <= begin ? begin : static_cast<int>(guess);
  while (row < end && (strict ? row + offset <= y : row + offset < y)) ++row;
  return row;
}

}  // namespace rasterproof::exact
