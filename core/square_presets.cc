#include "core/square_presets.h"

#include <optional>
#include <string_view>

namespace rasterproof {
namespace {

using enum Closure;
using enum SquareGeometry;

SquareRegion Meets(Closure square, Closure shape, SquareGeometry geometry, double half_width = 0) {
  return {SquareRelation::kIntersects, square, shape, geometry, SquareGrowth::kSwept, half_width};
}

SquareRegion Holds(Closure square, Closure shape, SquareGeometry geometry, double half_width = 0) {
  return {SquareRelation::kContains, square, shape, geometry, SquareGrowth::kSwept, half_width};
}

// "If any part of a primitive overlaps a pixel", of "the floating-point vertex coordinates"; others
// "only if they are within an uncertainty region", swept "in the fixed point domain".
SquareRule Conservative(double half_width, FlatSquares flat) {
  return {Meets(kOpen, kOpen, kGiven), Meets(kClosed, kClosed, kPlaced, half_width), flat};
}

// "Any part of a primitive" is said of it as it is given: a clip that moves its edges is no excuse.
Profile Unclipped(std::string_view preset) {
  Profile profile = *PresetProfile(preset);
  profile.guard_band.reset();
  return profile;
}

// 0.01 pixel, rounded up to a step.
constexpr double kGdalEpsilon = 10486 * kSquareStep;

std::optional<Profile> WithRule(std::string_view name) {
  Profile real;
  // Vertices are placed as the API's own preset has it.
  const auto with = [](Profile profile, const SquareRule& rule) {
    profile.squares = rule;
    return profile;
  };
  if (name == "d3d12-conservative-1")
    return with(Unclipped("d3d11"), Conservative(0.5, FlatSquares::kFree));
  if (name == "d3d12-conservative-2" || name == "d3d12-conservative-3") {
    return with(Unclipped("d3d11"), Conservative(0x1p-8, FlatSquares::kDrawn));
  }
  // Figure consras7: a pixel that a side touches from within is not inside.
  if (name == "d3d12-inner") {
    return with(Unclipped("d3d11"), {Holds(kClosed, kOpen, kPlaced, 0x1p-8),
                                     Holds(kClosed, kOpen, kGiven), FlatSquares::kNothing});
  }
  // "Any part of the primitive, including its edges, covers any part of the rectangular pixel area,
  // including its sides"; what it is grown by has no bound.
  if (name == "vulkan-overestimate") {
    return with(Unclipped("vulkan"),
                {Meets(kClosed, kClosed, kPlaced), std::nullopt, FlatSquares::kFree});
  }
  // "Only generated if the rectangular pixel area is fully covered".
  if (name == "vulkan-underestimate") {
    return with(Unclipped("vulkan"),
                {std::nullopt, Holds(kClosed, kClosed, kPlaced), FlatSquares::kNothing});
  }
  if (name == "gdal-all-touched") {
    return with(real, {Meets(kOpen, kOpen, kGiven, -kGdalEpsilon),
                       Meets(kClosed, kClosed, kGiven, kGdalEpsilon), FlatSquares::kFree});
  }
  if (name == "pdf-fill") {
    real.y_axis = YAxis::kUp;
    return with(real, {Meets(kHalfOpen, kHalfOpen, kGiven), Meets(kHalfOpen, kClosed, kGiven),
                       FlatSquares::kDrawn});
  }
  if (name == "voxel") {
    const SquareRegion touched = Meets(kClosed, kClosed, kGiven);
    return with(real, {touched, touched, FlatSquares::kDrawn});
  }
  return std::nullopt;
}

}  // namespace

std::optional<Profile> SquarePreset(std::string_view name) {
  std::optional<Profile> profile = WithRule(name);
  if (!profile) return std::nullopt;
  profile->name = name;
  profile->contract = Contract::kSquares;
  return profile;
}

}  // namespace rasterproof
