// Meshes, fans among them: front minus back is the winding number of the boundary, with no model of
// single triangles.
#include "fuzz/screens.h"
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(ScreenWinding, (Limits{48 * 48, 64}),
                      {"spans-exact", "SignedCoverageEqualsTheWindingNumber"},
                      {"i32-snap4", "SignedCoverageEqualsTheWindingNumber"})
