#include "props/catalog/edge_mirror.h"

#include <array>

#include "props/catalog/edge_queries.h"

namespace rasterproof::props {
namespace {

constexpr std::array<EdgeMap, 3> kMirrors{{
    {.sx = -1, .factor = -1},
    {.sy = -1, .factor = -1},
    {.transpose = true, .factor = -1},
}};

}  // namespace

Verdict MirrorNegatesEdgeValues(Subject& subject, const Case& c) {
  return EdgeValuesFollow(subject, c, kMirrors, "edge value is not negated by a mirror");
}

}  // namespace rasterproof::props
