// Incremental evaluation in integers: a stepping equals direct evaluation. It is a separate target
// because the bounds of exact values cost more than all else.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtProperties, Limits{}, {"i64-snap8", "SteppingEqualsDirectWhereExact"})
