// Whole targets as images, a pixel to a pixel.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "report/palette.h"
#include "report/picture.h"
#include "report/pixel_state.h"

namespace rasterproof::report {
namespace {

constexpr Colour kNothing{247, 247, 248};
constexpr Colour kNotANumber{160, 160, 160};

// Calls colour(k) for every pixel k that a triangle owns.
template <class ColourOf>
io::Image PaintOwned(const FragmentBuffers& fragments, const ColourOf& colour) {
  io::Image image(fragments.width, fragments.height, kNothing);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    if (fragments.triangle[k] >= 0) image.pixels[k] = colour(k);
  }
  return image;
}

// Neighbouring numbers get hues far apart: steps of the golden ratio never come close to a turn.
Colour ColourOfTriangle(std::int32_t triangle) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kThird = 2.0943951023931953;  // of a turn
  const double turn = 3 * kThird * std::fmod(triangle * kGoldenRatio, 1.0);
  Colour colour;
  for (std::size_t k = 0; k < 3; ++k) {
    const double wave = std::cos(turn - static_cast<double>(k) * kThird);
    colour[k] = static_cast<std::uint8_t>(172 + 50 * wave);
  }
  return colour;
}

// Light sand to deep blue: lightness falls steadily, so it reads without colour as well.
Colour DepthColour(double t) {
  constexpr std::array<Colour, 5> kStops{
      {{253, 231, 155}, {190, 180, 120}, {128, 130, 122}, {70, 84, 112}, {14, 34, 77}}};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  return Mix(kStops[below], kStops[below + 1], at - static_cast<double>(below));
}

}  // namespace

io::Image PaintFlat(const FragmentBuffers& fragments) {
  return PaintOwned(fragments,
                    [&](std::size_t k) { return ColourOfTriangle(fragments.triangle[k]); });
}

io::Image PaintBarycentrics(const FragmentBuffers& fragments) {
  constexpr std::array<Colour, 3> kVertices{kVermilion, kGreen, kBlue};
  return PaintOwned(fragments, [&](std::size_t k) {
    std::array<double, 3> sum{};
    for (std::size_t v = 0; v < 3; ++v) {
      const float barycentric = fragments.barycentrics[k][v];
      if (!std::isfinite(barycentric)) return kNotANumber;
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += std::clamp(barycentric, 0.0F, 1.0F) * static_cast<double>(kVertices[v][c]);
      }
    }
    Colour colour;
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = static_cast<std::uint8_t>(std::clamp(sum[c] + 0.5, 0.0, 255.0));
    }
    return colour;
  });
}

io::Image PaintDepth(const FragmentBuffers& fragments) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (const float depth : fragments.depth) {
    if (!std::isfinite(depth)) continue;
    nearest = std::min<double>(nearest, depth);
    farthest = std::max<double>(farthest, depth);
  }
  const double range = farthest > nearest ? farthest - nearest : 1;
  return PaintOwned(fragments, [&](std::size_t k) {
    const double depth = fragments.depth[k];
    return std::isfinite(depth) ? DepthColour((depth - nearest) / range) : kNotANumber;
  });
}

io::Image PaintWireframe(const FragmentBuffers& fragments, double width_pixels) {
  constexpr Colour kFace{233, 237, 242};
  return PaintOwned(fragments, [&](std::size_t k) {
    const double distance = fragments.edge_distance[k];
    if (std::isnan(distance)) return kNotANumber;
    // Half the line lies on each side of its edge; the last half pixel fades out.
    return Mix(kFace, kInk, std::clamp(width_pixels / 2 + 0.5 - distance, 0.0, 1.0));
  });
}

io::Image PaintCounts(const CoverageCounts& counts) {
  constexpr std::array<Colour, 5> kCounts{
      {{255, 255, 255}, {200, 204, 210}, {244, 164, 130}, {214, 96, 77}, {150, 20, 40}}};
  io::Image image(counts.width, counts.height);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const std::size_t sample = k * static_cast<std::size_t>(counts.samples);
    const std::uint64_t count = std::uint64_t{counts.front[sample]} + counts.back[sample];
    image.pixels[k] = kCounts[std::min<std::uint64_t>(count, kCounts.size() - 1)];
  }
  return image;
}

io::Image PaintDifference(const CoverageCounts& observed, const CoverageCounts& expected) {
  io::Image image(expected.width, expected.height);
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      const Pixel pixel = PixelAt(observed, expected, x, y);
      image.At(x, y) = StateColour(pixel.state, pixel.expected);
    }
  }
  return image;
}

}  // namespace rasterproof::report
