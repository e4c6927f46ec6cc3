// The floating-point mode that a caller left behind leaves no trace in the coverage.
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/draw_options.h"
#include "core/float_mode.h"
#include "core/profile.h"
#include "props/compare/can_touch.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

constexpr auto kDomains = std::to_array<std::string_view>(
    {"near-edge", "edges-through-samples", "hardest-vertex", "uniform-subpixel", "shared-edge",
     "snap-ties", "subnormal", "underflowing-products", "largest-and-smallest", "product-overflow",
     "grids", "degenerate", "perspective", "mixed-w"});

std::string Whose(FloatMode mode) {
  return "that in the usual floating-point mode with the caller's mode '" +
         std::string(FloatModeName(mode)) + "'";
}

}  // namespace

extern constinit const Property kEnvironmentKeepsCoverage{
    .name = "EnvironmentKeepsCoverage",
    .group = "extremes",
    .clause =
        "Coverage is a function of the scene: no specification names the caller's rounding mode, "
        "its flushing of subnormal numbers or its traps.",
    .stated_by = [](const Profile&) { return false; },
    .tolerance = "none: exact",
    .domains = kDomains,
    .gate = {.space = Space::kEither,
             .shows = Shows::kFloatModes,
             .any_model = true,
             .judges_clipped = true},
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          constexpr std::array kAll{FloatMode::kUpward,           FloatMode::kDownward,
                                    FloatMode::kTowardZero,       FloatMode::kFlushToZero,
                                    FloatMode::kDenormalsAreZero, FloatMode::kTrapping};
          std::vector<FloatMode> modes;
          std::ranges::copy_if(kAll, std::back_inserter(modes), [&](FloatMode mode) {
            return CanTouch(mode, c.scene, subject.info.input);
          });
          return CompareOption(c, &DrawOptions::float_mode, FloatMode::kUsual, modes, &Whose);
        },
};

}  // namespace rasterproof::props
