// Incremental evaluation: every stepping keeps its drift bound.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtOneProperty, Limits{},
                      {"f32-incremental", "SteppingStaysWithinItsBound"},
                      {"f32-incremental-row", "SteppingStaysWithinItsBound"},
                      {"f32-incremental-compensated", "SteppingStaysWithinItsBound"},
                      {"f32-index-fma", "SteppingStaysWithinItsBound"},
                      {"f64-incremental", "SteppingStaysWithinItsBound"})
