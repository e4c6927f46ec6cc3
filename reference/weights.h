// Barycentrics, interpolation and wireframe of the reference, in float32 and float64.
#ifndef RASTERPROOF_REFERENCE_WEIGHTS_H_
#define RASTERPROOF_REFERENCE_WEIGHTS_H_

#include "core/scene.h"
#include "core/subject.h"

namespace rasterproof::reference {

/// The reference's weight evaluator in the arithmetic of `precision`, with its proven bounds.
const WeightEvaluator& ReferenceWeights(Precision precision);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_WEIGHTS_H_
