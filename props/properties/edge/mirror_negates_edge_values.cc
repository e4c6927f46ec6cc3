// Mirroring in either axis, or exchanging the axes, negates E.
#include <array>

#include "props/judging/edge_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace mirror_negates_edge_values {

constexpr std::array<EdgeMap, 3> kMirrors{{
    {.sx = -1, .factor = -1},
    {.sy = -1, .factor = -1},
    {.transpose = true, .factor = -1},
}};

Checks Ask(const PlacedCase& c, const Description& subject) {
  return EdgeValuesFollow(c, subject, kMirrors, "edge value is not negated by a mirror");
}

}  // namespace mirror_negates_edge_values

extern const Property kMirrorNegatesEdgeValues;
constinit const Property kMirrorNegatesEdgeValues{
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
    .ask = mirror_negates_edge_values::Ask,
};

}  // namespace rasterproof::props
