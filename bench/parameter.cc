#include "bench/parameter.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/edge_cases.h"
#include "bench/grid_cases.h"

namespace rasterproof::bench {
namespace {

template <int kBits>
std::vector<HardCase> OnGrid(double steps) {
  return GridCases(steps, kBits);
}

constexpr Parameter GridRow(std::string_view name, std::string_view unit, double step,
                            std::vector<HardCase> (*hardest)(double)) {
  return {.name = name,
          .summary =
              "Larger side of a triangle with its corners on a grid, and a sample as near "
              "to an edge as the grid allows",
          .unit = unit,
          .least_exponent = 2,
          .most_exponent = 53,
          .reach = step,
          .is_grid = true,
          .hardest = hardest};
}

constexpr std::array kParameters{
    GridRow("grid-0", "pixels", 1, &OnGrid<0>),
    GridRow("grid-1", "steps of 1/2 pixel", 0x1p-1, &OnGrid<1>),
    GridRow("grid-4", "steps of 1/16 pixel", 0x1p-4, &OnGrid<4>),
    GridRow("grid-8", "steps of 1/256 pixel", 0x1p-8, &OnGrid<8>),
    Parameter{.name = "values",
              .summary = "Larger side of a triangle on the grid of 1/256 pixel whose edge values "
                         "are exact, not their signs alone",
              .unit = "steps of 1/256 pixel",
              .compared = Compared::kValues,
              .least_exponent = 2,
              .most_exponent = 53,
              .reach = 0x1p-8,
              .is_grid = true,
              .hardest = &ValueCases},
    Parameter{.name = "extent",
              .summary = "Larger side of a triangle on whole pixels, and a sample at least a "
                         "quarter of a pixel from every edge: what fails is lost, not rounded",
              .unit = "pixels",
              .least_exponent = 4,
              .most_exponent = 40,
              .reach = 1,
              .hardest = &ExtentCases},
    Parameter{.name = "aspect",
              .summary = "Length of a needle over its width; 4096 pixels long, an edge as near to "
                         "a sample as float32 allows",
              .unit = "1",
              .scale = Scale::kPowers,
              .least_exponent = 0,
              .most_exponent = 26,
              .reach_beside = 4112,
              .hardest = &NeedleCases},
    Parameter{.name = "distance",
              .summary = "Distance from the origin of a triangle of some 20 pixels, an edge as "
                         "near to a sample as float32 allows; beyond 65536 edge values alone",
              .unit = "pixels",
              .scale = Scale::kPowers,
              .least_exponent = 0,
              .most_exponent = 24,
              .reach = 1,
              .reach_beside = 64,
              .hardest = &DistantCases},
    Parameter{.name = "steps",
              .summary = "Columns from the left side of the triangle's box to the sample, an edge "
                         "as near to it as float32 allows",
              .unit = "pixels",
              .scale = Scale::kPowers,
              .least_exponent = 1,
              .most_exponent = 14,
              .reach = 1,
              .reach_beside = 16,
              .hardest = &WalkCases},
    Parameter{.name = "gap",
              .summary = "Distance of one corner from the sample over that of the others, the edge "
                         "as near to it as floats allow (float64 beyond 2^120)",
              .unit = "1",
              .scale = Scale::kPowers,
              .least_exponent = 0,
              .most_exponent = 200,
              .curve_every = 8,
              .reach = 2,
              .reach_beside = 8,
              .hardest = &GapCases},
    Parameter{.name = "cancellation",
              .summary = "Sum of the magnitudes of the two products of E over |E| at the sample: "
                         "a method is backward stable where its share of the bound is flat",
              .unit = "1",
              .scale = Scale::kPowers,
              .least_exponent = 0,
              .most_exponent = 56,
              .reach_beside = 256,
              .hardest = &CancellingCases},
    Parameter{.name = "w",
              .summary = "w of one corner in clip space over that of the others, an edge as near "
                         "to a sample as its neighbouring floats allow",
              .unit = "1",
              .scale = Scale::kPowers,
              .least_exponent = -24,
              .most_exponent = 24,
              .reach_beside = 256,
              .hardest = &ClipCases},
};

}  // namespace

std::span<const Parameter> Parameters() { return kParameters; }

const Parameter* FindParameter(std::string_view name) {
  const auto found = std::ranges::find(kParameters, name, &Parameter::name);
  return found == kParameters.end() ? nullptr : &*found;
}

BenchParameter Described(const Parameter& parameter) {
  return {.name = std::string(parameter.name),
          .summary = std::string(parameter.summary),
          .unit = std::string(parameter.unit),
          .is_cost = false};
}

}  // namespace rasterproof::bench
