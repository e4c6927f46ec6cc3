// The chosen cases, by the rule of scripts/first_cases.
#include <array>
#include <span>

#include "props/run/case_order.h"

namespace rasterproof::props {
namespace {

constexpr auto kFirstCases = std::to_array<FirstCase>({
    {"far-sides", 2},
    {"deciding-snap-ties", 7},
    {"range-ends", 3},
    {"scaled-viewports", 7},
    {"covering-fans", 3},
    {"far-tile-corners", 5},
    {"rounded-differences", 4},
    {"deciding-snap-ties", 3},
    {"sparse-indices", 1},
    {"rows-and-columns", 3},
    {"scaled-viewports", 2},
    {"far-sides", 7},
    {"equal-after-snap", 2},
    {"every-size", 5},
    {"many-triangles", 7},
    {"diagonal-needles", 6},
    {"near-repeats", 5},
    {"offset-cancellation", 0},
    {"rounded-differences", 2},
    {"sub-pixel-triangles", 2},
    {"every-lane", 2},
    {"near-rectangles", 2},
    {"near-rectangles", 0},
    {"folds", 2},
    {"covering-fans", 0},
    {"rows-and-columns", 4},
    {"deciding-snap-ties", 1},
    {"deciding-snap-ties", 2},
    {"long-rows", 7},
    {"far-tile-corners", 2},
    {"equal-after-snap", 4},
    {"fans", 1},
    {"deciding-snap-ties", 4},
    {"largest-and-smallest", 4},
    {"underflowing-products", 5},
    {"sub-pixel-triangles", 4},
    {"near-rectangles", 7},
    {"fans", 3},
    {"deciding-snap-ties", 0},
    {"far-slivers", 3},
    {"underflowing-products", 4},
});

}  // namespace

std::span<const FirstCase> FirstCases() { return kFirstCases; }

}  // namespace rasterproof::props
