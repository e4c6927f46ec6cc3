// Threads: the draw area cut into bands of rows that share nothing.
#ifndef RASTERPROOF_REFERENCE_BANDS_H_
#define RASTERPROOF_REFERENCE_BANDS_H_

#include <algorithm>
#include <functional>

#include "core/draw_options.h"
#include "core/scene.h"

namespace rasterproof::reference {

/// Calls draw(band) for disjoint bands of whole tile rows that together make up `area`, each from
/// another thread; from the calling thread alone if one will do.
///
/// Domain:     options.threads 0: as many as the machine has. More than there are tile rows, or
///             than kMaxThreads, are not started.
/// Properties: no two calls get the same row, so the order in which they run cannot be seen.
void ForEachBand(const PixelRect& area, const DrawOptions& options,
                 const std::function<void(const PixelRect&)>& draw);

inline constexpr int kMaxThreads = 256;

/// Side of the tiles of the grid that starts at pixel (0, 0); 0: rows across the whole target.
inline int TileSide(const DrawOptions& options) {
  return std::clamp(options.tile, 0, kMaxTargetSide);
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_BANDS_H_
