// The claims about what comes back beside counts, and about what shares a call.
#ifndef RASTERPROOF_PROPS_CATALOG_OUTPUTS_H_
#define RASTERPROOF_PROPS_CATALOG_OUTPUTS_H_

#include <span>

#include "props/property.h"

namespace rasterproof::props {

/// Their rows of the catalogue.
std::span<const Property> OutputProperties();

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_OUTPUTS_H_
