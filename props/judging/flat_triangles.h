// Triangles of zero area.
#ifndef RASTERPROOF_PROPS_JUDGING_FLAT_TRIANGLES_H_
#define RASTERPROOF_PROPS_JUDGING_FLAT_TRIANGLES_H_

#include <cstddef>
#include <vector>

#include "core/case.h"

namespace rasterproof::props {

/// The finite triangles of the case whose area is zero after snapping, by their places in its list.
///
/// Clip space without places on the profile's grid: by its homogeneous area.
std::vector<std::size_t> FlatTriangles(const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FLAT_TRIANGLES_H_
