// The numbers at a scene's vertices that a rasterizer interpolates.
#ifndef RASTERPROOF_CORE_CHANNEL_H_
#define RASTERPROOF_CORE_CHANNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rasterproof {

/// How the numbers at three vertices become one at a point of the triangle.
enum class Interpolation : std::uint8_t {
  kFlat,         ///< the provoking vertex's number
  kLinear,       ///< affine on the screen ("noperspective")
  kPerspective,  ///< affine before the division by w; in window space as kLinear
  kInverseW      ///< 1/w, which needs no numbers at the vertices
};

/// Where in its pixel a value is evaluated.
enum class EvaluatedAt : std::uint8_t {
  kSample,   ///< at each covered sample
  kCentre,   ///< at the pixel's centre, which may lie outside the triangle
  kCentroid  ///< where the profile's key `centroid` says
};

/// Their names in files and on a pipe.
inline constexpr std::array<std::pair<Interpolation, std::string_view>, 4> kInterpolationNames{
    {{Interpolation::kFlat, "flat"},
     {Interpolation::kLinear, "linear"},
     {Interpolation::kPerspective, "perspective"},
     {Interpolation::kInverseW, "inverse-w"}}};
inline constexpr std::array<std::pair<EvaluatedAt, std::string_view>, 3> kEvaluatedAtNames{
    {{EvaluatedAt::kSample, "sample"},
     {EvaluatedAt::kCentre, "centre"},
     {EvaluatedAt::kCentroid, "centroid"}}};

inline constexpr std::size_t kMostChannels = 64;

/// A named number at each vertex.
struct Channel {
  std::string name = {};  ///< one word: neither empty nor with blanks or control characters
  Interpolation interpolation = Interpolation::kPerspective;
  EvaluatedAt at = EvaluatedAt::kSample;
  /// One a vertex; none for kInverseW. A number of the scene's precision.
  std::vector<double> values = {};

  friend bool operator==(const Channel&, const Channel&) = default;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CHANNEL_H_
