// Coverage walked in tiles of different sizes.
#ifndef RASTERPROOF_PROPS_CATALOG_TILE_SIZE_H_
#define RASTERPROOF_PROPS_CATALOG_TILE_SIZE_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The tiles that the target is walked in leave no trace in the coverage.
Verdict TileSizeKeepsCoverage(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_TILE_SIZE_H_
