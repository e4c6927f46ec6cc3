// Bounds on edge values that a subject states in one number.
#ifndef RASTERPROOF_CORE_STATED_EDGES_H_
#define RASTERPROOF_CORE_STATED_EDGES_H_

#include <vector>

#include "core/evaluators.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/vertex.h"

namespace rasterproof {

/// Bounds from the numbers that a subject states of its edge functions (EdgeInfo). How it evaluates
/// them is left to a class derived from this.
class StatedEdges : public EdgeEvaluator {
 public:
  /// `precision` is that of the subject's input: u is 2^-24 or 2^-53.
  StatedEdges(const EdgeInfo& properties, Precision precision)
      : stated_(properties), precision_(precision) {}

  double ErrorBound(Point2 a, Point2 b, Point2 p) const final;
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const final;

  /// The largest difference of coordinates that E(a, b; p) is worked out from, and the sum of its
  /// products.
  struct Sizes {
    double factors = 0;
    double products = 0;
  };

 private:
  double Bound(double roundings, const Sizes& sizes) const;

  EdgeInfo stated_;
  Precision precision_;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_STATED_EDGES_H_
