// Interpolation: depth by barycentrics and by deltas, and with perspective, within proven bounds.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtOneProperty, Limits{},
                      {"f32-direct", "InterpolationStaysWithinItsBound"},
                      {"f32-direct", "PerspectiveInterpolationStaysWithinItsBound"},
                      {"f64-direct", "DepthByDeltasEqualsDepthByBarycentrics"},
                      {"f64-direct", "InterpolatedValuesStayInTheHull"})
