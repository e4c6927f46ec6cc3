// Wireframe: the three distances to the edges, each against what it states.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtOneProperty, Limits{},
                      {"f32-direct", "BarycentricDistanceIsTheSmallestCoordinate"},
                      {"f64-direct", "DerivativeDistanceMeasuresInTheL1Norm"},
                      {"f64-direct", "HeightDistanceIsTheDistanceInPixels"})
