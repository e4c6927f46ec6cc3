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
    {"edge-products", {0.317, 0.239}},
    {"differences", {0.348, 0.190}},
    {"differences-fma", {0.281, 0.157}},
    {"origin-plane", {0.267, 0.198}},
    {"vertex-plane", {0.294, 0.230}},
    {"stepped", {0.980, kUnknown}},
    {"perspective-planes", {0.267, 0.141}},
    {"perspective-planes-fma", {0.292, 0.240}},
    {"inverse-matrix", {0.309, 0.204}},
    {"perspective-weights", {0.298, 0.163}},
    {"reciprocal-12", {0.880, 0.970}},
    {"reciprocal-12-newton", {0.291, 0.707}},
    {"reciprocal-12-newton-2", {0.291, 0.255}},
    {"reciprocal-14", {0.910, 0.951}},
    {"reciprocal-14-newton", {0.300, 0.583}},
    {"reciprocal-14-newton-2", {0.301, 0.175}},
    {"quad-difference", {0.175, 0.068}},
    {"correctly-rounded", {0.999, 0.998}},
});

}  // namespace

std::array<double, 2> LargestRatiosOf(std::string_view method) {
  for (const Figure& figure : kFigures) {
    if (figure.method == method) return figure.largest;
  }
  return {kUnknown, kUnknown};
}

}  // namespace rasterproof::reference
