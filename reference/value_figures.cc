#include "reference/value_figures.h"

#include <limits>

namespace rasterproof::reference {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Figure {
  std::string_view method;
  std::array<double, 2> largest;
};

constexpr auto kFigures = std::to_array<Figure>({
    {"edge-products", {0.316, 0.351}},
    {"differences", {0.347, 0.208}},
    {"differences-fma", {0.280, 0.231}},
    {"origin-plane", {0.273, 0.248}},
    {"vertex-plane", {0.293, 0.230}},
    {"stepped", {0.979, kUnknown}},
    {"perspective-planes", {0.279, 0.204}},
    {"perspective-planes-fma", {0.291, 0.240}},
    {"inverse-matrix", {0.319, 0.236}},
    {"perspective-weights", {0.297, 0.272}},
    {"reciprocal-12", {0.921, 0.970}},
    {"reciprocal-12-newton", {0.291, 0.949}},
    {"reciprocal-12-newton-2", {0.290, 0.640}},
    {"reciprocal-14", {0.909, 0.951}},
    {"reciprocal-14-newton", {0.299, 0.766}},
    {"reciprocal-14-newton-2", {0.300, 0.232}},
    {"quad-difference", {0.175, 0.111}},
    {"correctly-rounded", {0.999, 0.999}},
});

}  // namespace

std::array<double, 2> LargestRatiosOf(std::string_view method) {
  for (const Figure& figure : kFigures) {
    if (figure.method == method) return figure.largest;
  }
  return {kUnknown, kUnknown};
}

}  // namespace rasterproof::reference
