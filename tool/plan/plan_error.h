// The cheapest method that meets a stated error on a scene.
#ifndef RASTERPROOF_TOOL_PLAN_PLAN_ERROR_H_
#define RASTERPROOF_TOOL_PLAN_PLAN_ERROR_H_

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"
#include "core/scene.h"

namespace rasterproof::tool {

/// A method, how far it may move the scene's edges, and what it costs.
struct ErrorChoice {
  std::string method;
  std::string target;
  /// Proved: each edge is decided as if it were at most this many pixels away. NaN: no bound holds.
  double proved = std::numeric_limits<double>::quiet_NaN();
  std::string why;         ///< what the number rests on, or why there is none
  double nanoseconds = 0;  ///< a triangle, on the family
  bool meets = false;      ///< the bound is at most the stated error

  friend bool operator==(const ErrorChoice&, const ErrorChoice&) = default;
};

/// How far a method moves the edges of the scene, at most, by the bounds of reference/bounds.h: the
/// error of E over the edge's length, largest over the rows and steps that it draws.
///
/// Domain:     a scene in window space.
/// Returns:    0 where the method is proved exact for the scene, NaN where no bound is stated.
struct ProvedError {
  double pixels = std::numeric_limits<double>::quiet_NaN();
  std::string why;
};
ProvedError ProvedErrorOf(std::string_view method, const Scene& scene);

/// The family of the bench whose triangles are the nearest in size to the scene's, or the one of
/// the scene's own name.
///
/// Error:      InputError if the bench has no family of the scene's kind of coordinates.
std::size_t NearestFamily(const BenchResult& bench, const Scene& scene, const std::string& place);

/// All methods of the bench that keep counts by facing, cheapest first.
std::vector<ErrorChoice> ErrorChoices(const BenchResult& bench, std::size_t family,
                                      const Scene& scene, double most_pixels);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PLAN_PLAN_ERROR_H_
