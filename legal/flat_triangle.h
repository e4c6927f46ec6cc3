// The samples that a triangle without area may cover where its coverage is not specified.
#ifndef RASTERPROOF_LEGAL_FLAT_TRIANGLE_H_
#define RASTERPROOF_LEGAL_FLAT_TRIANGLE_H_

#include <array>
#include <functional>

#include "core/vertex.h"
#include "exact/sample_frame.h"

namespace rasterproof::legal {

/// Returns whether the point lies on one of the closed edges of a triangle without area. Its edges
/// may hold samples, so it may cover those, or nothing; a sample off all of them is outside for
/// every reading of a specification that leaves zero area open.
///
/// Domain:     finite corners on one line, or in one place.
bool LiesOnFlat(const std::array<Point2, 3>& corners, Point2 p);

/// Visits every sample of the frame that lies on a closed edge of such a triangle: its column, its
/// row and its number in the pixel.
///
/// Domain:     as LiesOnFlat; corners in screen axes.
/// Cost:       a few samples of each row that the triangle meets.
void ForEachSampleOnFlat(const std::array<Point2, 3>& corners, const exact::SampleFrame& frame,
                         const std::function<void(int x, int row, std::size_t s)>& visit);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_FLAT_TRIANGLE_H_
