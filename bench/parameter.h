// The numbers that make triangles harder, and the hardest triangles known of each of their values.
#ifndef RASTERPROOF_BENCH_PARAMETER_H_
#define RASTERPROOF_BENCH_PARAMETER_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/bench_result.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::bench {

/// A triangle that is hard at a value of a parameter, and the one sample that is asked about.
struct HardCase {
  Scene scene;  ///< one triangle
  int x = 0;
  int y = 0;
  /// The columns that a method which steps takes from the box's left side to the sample.
  int steps = 0;
  /// The sample where it lies beyond every target: then edge values are asked for alone.
  std::optional<Point2> undrawn = std::nullopt;
};

/// What is looked at in a case.
enum class Compared : std::uint8_t {
  kSample,  ///< whether the sample is covered
  kValues   ///< whether every edge value at the sample is exact
};

/// How values follow each other.
enum class Scale : std::uint8_t {
  kWhole,  ///< whole numbers: about powers of two, half-way, and where it matters all between
  kPowers  ///< powers of two alone
};

/// A row of the table of parameters.
struct Parameter {
  std::string_view name;
  std::string_view summary;  ///< a sentence
  std::string_view unit;
  Compared compared = Compared::kSample;
  Scale scale = Scale::kWhole;
  int least_exponent = 0;
  int most_exponent = 0;  ///< at most 53 of whole numbers
  int curve_every = 1;    ///< the step between exponents of a curve's points
  /// Coordinates are at most `reach` pixels times the value, plus `reach_beside` pixels.
  double reach = 0;
  double reach_beside = 1.5;
  /// Corners and samples lie on a grid: the exactness table says up to where nothing is rounded.
  bool is_grid = false;
  /// The hardest cases of a value. The same value gives the same cases.
  ///
  /// Domain:     2^least_exponent - 1 <= value <= 2^most_exponent + 1; kWhole: whole numbers.
  /// Returns:    scenes of float32 where float32 holds every coordinate, else of float64. None
  ///             where the value is too small for a triangle.
  std::vector<HardCase> (*hardest)(double value) = nullptr;
};

/// "grid-0", "grid-1", "grid-4", "grid-8", "values", "extent", "aspect", "distance", "steps",
/// "gap", "cancellation", "w".
std::span<const Parameter> Parameters();

/// nullptr if there is none of that name.
const Parameter* FindParameter(std::string_view name);

/// As a row of the result.
BenchParameter Described(const Parameter& parameter);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_PARAMETER_H_
