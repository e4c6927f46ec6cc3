// Clipping: far triangles whose edges a legal clipper moves, and neighbours that it clips alike.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtProperties, Limits{},
                      {"legal:clip-moves-edges", "NeighboursAreClippedAlike"},
                      {"legal:clip-moves-edges", "SignedCoverageEqualsTheWindingNumber"},
                      {"legal:clip-exact", "ClipSpaceCoverageEqualsTheModel"})
