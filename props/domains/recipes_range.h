// A part of a recipe that two topics share.
#ifndef RASTERPROOF_PROPS_DOMAINS_RECIPES_RANGE_H_
#define RASTERPROOF_PROPS_DOMAINS_RECIPES_RANGE_H_

#include "props/domains/case_builder.h"

namespace rasterproof::props {

/// Triangles in which the snapping of one vertex decides a sample.
void AddDecidingTies(CaseBuilder& builder);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_RECIPES_RANGE_H_
