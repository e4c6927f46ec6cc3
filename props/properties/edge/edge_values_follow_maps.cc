// Edge values follow the maps of the plane that they are defined by, where the images are exact.
#include <array>

#include "props/judging/values/edge_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

// Near, across the sign change, and far enough to cost float32 some of its fraction bits.
constexpr std::array<EdgeMap, 4> kTranslations{{
    {.tx = 1, .ty = -1},
    {.tx = -64, .ty = 3},
    {.tx = 256, .ty = 1024},
    {.tx = -4096, .ty = -4096},
}};

constexpr std::array<EdgeMap, 3> kMirrors{{
    {.sx = -1, .factor = -1},
    {.sy = -1, .factor = -1},
    {.transpose = true, .factor = -1},
}};

// Upwards only: the way down is the same property read backwards, and could meet subnormals.
constexpr std::array<EdgeMap, 3> kScalings{{
    {.sx = 2, .sy = 2, .factor = 4},
    {.sx = 32, .sy = 32, .factor = 0x1p10},
    {.sx = 0x1p20, .sy = 0x1p20, .factor = 0x1p40},
}};

}  // namespace

// Moving edge and sample by whole pixels keeps E, where the sums are exact and of the input format.
extern constinit const Property kIntegerTranslationKeepsEdgeValues{
    .name = "IntegerTranslationKeepsEdgeValues",
    .group = "edge",
    .clause = "E depends on differences of positions only.",
    .tolerance = kBothBounds,
    .domains = kOnTheLattice,
    .gate = Where(kAsksEdgeValues,
                  "the moved coordinates are exact, of the input format, on the subpixel grid and "
                  "within the limit"),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return EdgeValuesFollow(c, subject, kTranslations,
                                  "edge value changes under translation");
        },
};

// Mirroring in either axis, or exchanging the axes, negates E.
extern constinit const Property kMirrorNegatesEdgeValues{
    .name = "MirrorNegatesEdgeValues",
    .group = "edge",
    .clause =
        "A mirror reverses orientation: E changes sign when an axis is turned over or the "
        "axes are exchanged.",
    .tolerance = kBothBounds,
    .domains = kOnTheLattice,
    .gate = Where(kAsksEdgeValues,
                  "the mirrored coordinates are of the input format, on the subpixel grid and "
                  "within the limit"),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return EdgeValuesFollow(c, subject, kMirrors, "edge value is not negated by a mirror");
        },
};

// Enlarging edge and sample by 2^k multiplies E by 4^k, where the results are on the input lattice.
extern constinit const Property kPowerOfTwoScalingScalesEdgeValues{
    .name = "PowerOfTwoScalingScalesEdgeValues",
    .group = "edge",
    .clause = "E is homogeneous of degree two in the positions.",
    .tolerance = "the sum of both proven ErrorBounds, scaled",
    .domains = kOnTheLattice,
    .gate = Where(kAsksEdgeValues,
                  "the scaled coordinates are exact, of the input format, on the subpixel grid and "
                  "within the limit"),
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return EdgeValuesFollow(c, subject, kScalings, "edge value does not scale by 4^k");
        },
};

}  // namespace rasterproof::props
