#include "bench/parameter.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/grid_cases.h"

namespace rasterproof::bench {
namespace {

template <int kBits>
std::vector<HardCase> OnGrid(double steps) {
  return GridCases(steps, kBits);
}

constexpr std::array kParameters{
    Parameter{.name = "grid-8",
              .summary = "Larger side of a triangle with its corners on a grid, and a sample as "
                         "near to an edge as the grid allows",
              .unit = "steps of 1/256 pixel",
              .least_exponent = 2,
              .most_exponent = 53,
              .reach = 0x1p-8,
              .is_grid = true,
              .hardest = &OnGrid<8>},
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
