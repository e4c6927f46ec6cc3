// Edge signs: the methods in double, in integers and in exact arithmetic against the oracle.
#include "fuzz/screens.h"
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(ScreenEdgeSigns, Limits{}, {"f64-direct", "EdgeSignIsRightOutsideItsBand"},
                      {"filtered-exact", "EdgeSignIsRightOutsideItsBand"},
                      {"i64-snap8", "EdgeSignIsRightOutsideItsBand"})
