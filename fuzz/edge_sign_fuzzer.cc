// Edge signs: the float32 methods against the oracle, beside the edges.
#include "fuzz/screens.h"
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(ScreenEdgeSigns, Limits{}, {"f32-direct", "EdgeSignIsRightOutsideItsBand"},
                      {"f32-kahan", "EdgeSignIsRightOutsideItsBand"},
                      {"f32-affine", "EdgeSignIsRightOutsideItsBand"})
