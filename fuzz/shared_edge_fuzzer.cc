// Shared edges: the exact methods count every sample as the model does, once on a shared edge.
#include "fuzz/screens.h"
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(ScreenCoverage, Limits{}, {"spans-exact", "CoverageEqualsTheModel"},
                      {"spans-exact", "SharedEdgeSamplesAreCoveredOnce"},
                      {"filtered-exact", "CoverageEqualsTheModel"},
                      {"i64-snap8", "CoverageEqualsTheModel"})
