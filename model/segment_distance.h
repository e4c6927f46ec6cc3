// How far a point lies from a segment, and from the boundary of a triangle.
#ifndef RASTERPROOF_MODEL_SEGMENT_DISTANCE_H_
#define RASTERPROOF_MODEL_SEGMENT_DISTANCE_H_

#include <array>

#include "core/vertex.h"

namespace rasterproof {

/// Returns the distance of p from the closed segment from a to b.
///
/// Domain:     finite; magnitudes from 2^-500 to 2^500.
/// Units:      pixels.
/// Error:      a few ulps of the double result where the coordinates' differences are exact; 0
///             where p lies on the segment.
double SegmentDistance(Point2 a, Point2 b, Point2 p);

/// Returns the distance of p from the boundary of the triangle.
double BoundaryDistance(const std::array<Point2, 3>& v, Point2 p);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_SEGMENT_DISTANCE_H_
