// Triangles of zero area.
#ifndef RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_
#define RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_

#include <cstddef>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// The finite triangles of the case whose area is zero after snapping, by their places in its list.
///
/// Domain:     window space, or clip space under a profile without a snap.
std::vector<std::size_t> FlatTriangles(const Case& c);

/// A triangle whose area is zero after snapping covers nothing.
Verdict DegenerateTrianglesCoverNothing(Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CATALOG_DEGENERATE_H_
