// Moving edge and sample by whole pixels keeps E, where the sums are exact and of the input format.
#include <array>

#include "props/judging/edge_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace integer_translation_keeps_edge_values {

// Near, across the sign change, and far enough to cost float32 some of its fraction bits.
constexpr std::array<EdgeMap, 4> kTranslations{{
    {.tx = 1, .ty = -1},
    {.tx = -64, .ty = 3},
    {.tx = 256, .ty = 1024},
    {.tx = -4096, .ty = -4096},
}};

Checks Ask(const PlacedCase& c, const Description& subject) {
  return EdgeValuesFollow(c, subject, kTranslations, "edge value changes under translation");
}

}  // namespace integer_translation_keeps_edge_values

extern const Property kIntegerTranslationKeepsEdgeValues;
constinit const Property kIntegerTranslationKeepsEdgeValues{
    .name = "IntegerTranslationKeepsEdgeValues",
    .group = "edge",
    .clause = "E depends on differences of positions only.",
    .tolerance = kBothBounds,
    .domains = kOnTheLattice,
    .gate = Where(kAsksEdgeValues,
                  "the moved coordinates are exact, of the input format, on the subpixel grid and "
                  "within the limit"),
    .ask = integer_translation_keeps_edge_values::Ask,
};

}  // namespace rasterproof::props
