// Extremes: no draw writes outside its target, and what is not finite poisons nothing else.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtProperties, Limits{},
                      {"f32-direct:canonical", "DrawStaysInsideItsTarget"},
                      {"i64-snap8", "DrawStaysInsideItsTarget"},
                      {"i64-snap8", "BadTrianglesPoisonNoOthers"},
                      {"spans-exact", "NonFiniteTrianglesCoverNothing"})
