// A scanline rasterizer: edges are walked down the rows, and where one crosses a row is rounded.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_SCANLINE_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_SCANLINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/snap.h"
#include "core/subject.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {

/// What the subject states of crossings, and what it does. Places are in 1/256 pixel; the upper
/// end of an edge is `a`.
struct ScanlineStages {
  SnapRule stated = SnapRule::kFloor;
  /// Where the edge crosses the row; empty: as stated.
  std::function<std::int64_t(GridPoint a, GridPoint b, std::int64_t y)> crossing = {};
};

/// Snaps to 1/256 pixel, and fills each row from one rounded crossing up to the other; top-left.
///
/// Domain:     float32 scenes in window space. A triangle that is not finite or leaves twice the
///             profile's limit is not drawn.
std::unique_ptr<Subject> MakeScanline(const std::string& name, const std::string& summary,
                                      ScanlineStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_SCANLINE_H_
