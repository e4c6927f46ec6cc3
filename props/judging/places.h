// The triangles, samples and runs of steps of a case that a property looks at: few, and near the
// edges.
#ifndef RASTERPROOF_PROPS_JUDGING_PLACES_H_
#define RASTERPROOF_PROPS_JUDGING_PLACES_H_

#include <array>
#include <cstddef>
#include <vector>

#include "core/vertex.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// A sample of the target and its window position.
struct SamplePlace {
  int x = 0;    ///< pixel column
  int row = 0;  ///< pixel row from the top
  int sample = 0;
  Point2 at;
};

/// A triangle of a window-space case, on the profile's subpixel grid.
struct CornersPlace {
  int triangle = 0;
  std::array<Point2, 3> at;
};

/// At most `limit` triangles of the case, spread evenly over its list.
///
/// Domain:     a window-space case; triangles with a vertex that is not finite are left out.
std::vector<CornersPlace> SomeTriangles(const PlacedCase& c, int limit);

/// Samples of the target on either side of each edge line, at most 4 * per_edge for each edge, and
/// the target's four corner samples. In a fixed order, without repetition.
std::vector<SamplePlace> SamplesNearEdges(const PlacedCase& c, const std::array<Point2, 3>& v,
                                          int per_edge);

/// Start and end of edge i, the one opposite vertex i, in the triangle's direction.
inline Point2 EdgeStart(const std::array<Point2, 3>& v, int i) {
  return v[static_cast<std::size_t>((i + 1) % 3)];
}
inline Point2 EdgeEnd(const std::array<Point2, 3>& v, int i) {
  return v[static_cast<std::size_t>((i + 2) % 3)];
}

/// The sample of pixel column x and row `row` from the top, under the profile's y axis.
SamplePlace PlaceOf(const PlacedCase& c, int x, int row, int sample);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_PLACES_H_
