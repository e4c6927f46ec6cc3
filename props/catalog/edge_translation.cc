#include "props/catalog/edge_translation.h"

#include <array>

#include "props/catalog/edge_queries.h"

namespace rasterproof::props {
namespace {

// Near, across the sign change, and far enough to cost float32 some of its fraction bits.
constexpr std::array<EdgeMap, 4> kTranslations{{
    {.tx = 1, .ty = -1},
    {.tx = -64, .ty = 3},
    {.tx = 256, .ty = 1024},
    {.tx = -4096, .ty = -4096},
}};

}  // namespace

Verdict IntegerTranslationKeepsEdgeValues(Subject& subject, const Case& c) {
  return EdgeValuesFollow(subject, c, kTranslations, "edge value changes under translation");
}

}  // namespace rasterproof::props
