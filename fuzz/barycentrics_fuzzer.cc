// Barycentrics: they and their sums stay within their proven bounds.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtOneProperty, Limits{}, {"f32-direct", "BarycentricsSumToOne"},
                      {"f32-direct", "BarycentricsStayWithinTheirBound"},
                      {"f64-direct", "BarycentricsSumToOne"},
                      {"f64-direct", "BarycentricIsOneAtItsVertexAndZeroOpposite"})
