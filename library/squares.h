// Outputs of the library that are of pixels' squares, not of their centres.
#ifndef RASTERPROOF_LIBRARY_SQUARES_H_
#define RASTERPROOF_LIBRARY_SQUARES_H_

#include "library/rasterize.h"

namespace rasterproof {

inline bool IsOfSquares(RasterOutput output) { return output >= RasterOutput::kInnerMask; }

/// Draws onto the contents of the target's memory.
///
/// Domain:     IsOfSquares(target.output); arguments that Rasterize takes; the usual floating-point
///             environment.
/// Source:     what an inner pixel's square shows: theorem/Path.v, winding_constant.
void DrawSquares(const RasterMesh& mesh, const RasterTarget& target, InstructionSet set);

}  // namespace rasterproof

#endif  // RASTERPROOF_LIBRARY_SQUARES_H_
