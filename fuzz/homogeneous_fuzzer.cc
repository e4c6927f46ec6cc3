// Clip space without a division: homogeneous edges against the model, and against projected ones.
#include "fuzz/target_macro.h"

RASTERPROOF_FUZZ_LOOK(LookAtProperties, Limits{}, {"hom-exact", "ClipSpaceCoverageEqualsTheModel"},
                      {"hom-exact", "SignedCoverageEqualsTheWindingNumber"},
                      {"hom-exact", "ScalingClipVerticesKeepsCoverage"},
                      {"hom-exact", "LiftedTrianglesCoverLikeProjectedOnes"})
