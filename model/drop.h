// Dropping: the stage that leaves out triangles larger than a rasterizer draws.
#ifndef RASTERPROOF_MODEL_DROP_H_
#define RASTERPROOF_MODEL_DROP_H_

#include <array>

#include "core/profile.h"
#include "core/vertex.h"

namespace rasterproof {

/// Returns whether a window-space triangle of these corners is larger than the extent. Exact.
bool Exceeds(const std::array<Point2, 3>& corners, const MaxPrimitiveExtent& extent);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_DROP_H_
