// An exact sign at every sample: the filter decides, and exact arithmetic where it can't.
#ifndef RASTERPROOF_REFERENCE_FILTERED_FORM_H_
#define RASTERPROOF_REFERENCE_FILTERED_FORM_H_

#include <utility>

#include "core/vertex.h"
#include "library/exact_sign.h"
#include "reference/edge_forms.h"

namespace rasterproof::reference {

/// A form whose values have the sign of E, exactly; their size means nothing where it is 0 or 1.
class FilteredForm {
 public:
  using Scalar = double;
  using Point = PointOf<double>;

  FilteredForm(Point a, Point b, bool reversed) : a_{a.x, a.y}, b_{b.x, b.y} {
    if (reversed) std::swap(a_, b_);
  }
  static Point Convert(Point2 p) { return {p.x, p.y}; }
  static double Centre(int n) { return n + 0.5; }
  double At(double x, double y) const {
    const library::FilteredEdge e = library::FilterEdge(a_, b_, {x, y});
    return e.certain ? e.value : library::UnfilteredEdgeSign(a_, b_, {x, y});
  }

 private:
  Point2 a_;
  Point2 b_;
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_FILTERED_FORM_H_
