// Edge values: every float method within its proven bound of E.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtProperties, Limits{}, {"f32-direct", "EdgeErrorStaysWithinItsBound"},
                      {"f32-kahan", "EdgeErrorStaysWithinItsBound"},
                      {"f32-affine", "EdgeErrorStaysWithinItsBound"},
                      {"f64-direct", "EdgeErrorStaysWithinItsBound"})
