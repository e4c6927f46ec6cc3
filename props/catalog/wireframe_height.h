// The wireframe test by heights.
#ifndef RASTERPROOF_PROPS_CATALOG_WIREFRAME_HEIGHT_H_
#define RASTERPROOF_PROPS_CATALOG_WIREFRAME_HEIGHT_H_

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// lambda_i times the height over edge i is the distance to that edge in pixels; pairing a weight
/// with another vertex's height is not.
Verdict HeightDistanceIsTheDistanceInPixels(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_WIREFRAME_HEIGHT_H_
