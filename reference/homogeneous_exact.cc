// Exact signs of homogeneous edges and determinants: filter, then integers.
#include <array>
#include <cmath>

#include "library/triple_sum.h"
#include "reference/homogeneous.h"
#include "reference/homogeneous_edges.h"

namespace rasterproof::reference {
namespace {

/// Nine products, each off by at most half the smallest subnormal, six of them grown by a sample's
/// coordinate (below 2^18): less than 2^-1050.
constexpr double kSampleUnderflowError = 0x1p-1040;

/// Adds a (b c - d e) to the sum.
void AddMinor(library::TripleSum& sum, double a, double b, double c, double d, double e) {
  sum.Add(a, b, c);
  sum.Subtract(a, d, e);
}

/// N_ij . (x, y, w), N_ij = V_j x V_i.
library::TripleSum ExactDot(const Vertex& vi, const Vertex& vj, double x, double y, double w) {
  library::TripleSum sum;
  AddMinor(sum, x, vj.y, vi.w, vj.w, vi.y);
  AddMinor(sum, y, vj.w, vi.x, vj.x, vi.w);
  AddMinor(sum, w, vj.x, vi.y, vj.y, vi.x);
  return sum;
}

/// The sign of N_ij . (x, y, w): filter, then integers.
int ExactDotSign(const Vertex& vi, const Vertex& vj, double x, double y, double w) {
  const double value = HomogeneousNormal<double>(vi, vj).Dot(x, y, w);
  // A product of two coordinates that underflows is off by eta / 2, and grows with x, y or w; a
  // product with x, y or w adds eta / 2: in all less than 16 eta (1 + max(|x|, |y|, |w|)).
  const double largest = std::fmax(std::fmax(std::fabs(x), std::fabs(y)), std::fabs(w));
  const double bound =
      DotErrorBound(DotMagnitude<double>(vi, vj, x, y, w)) + 0x1p-1070 * largest + 0x1p-1070;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return ExactDot(vi, vj, x, y, w).Sign();
}

}  // namespace

int ExactHomogeneousSign(const Vertex& vi, const Vertex& vj, Point2 p) {
  return ExactDotSign(vi, vj, p.x, p.y, 1);
}

int ExactHomogeneousFacing(const Vertex& v0, const Vertex& v1, const Vertex& v2) {
  return -ExactDotSign(v2, v1, v0.x, v0.y, v0.w);  // det(V0, V1, V2) = (V1 x V2) . V0
}

ExactHomogeneousEdge::ExactHomogeneousEdge(const Vertex& vi, const Vertex& vj, int facing,
                                           const TieRule& rule, Point2 extent)
    : vi_(facing > 0 ? vi : vj),
      vj_(facing > 0 ? vj : vi),
      normal_(vi_, vj_),
      error_(DotErrorBound(DotMagnitude<double>(vi, vj, extent.x, extent.y, 1)) +
             kSampleUnderflowError),
      owns_ties_(false) {
  // The tie rule asks for the signs of the coefficients, and those have to be exact as well.
  owns_ties_ = OwnsTies(ExactDotSign(vi_, vj_, 1, 0, 0), ExactDotSign(vi_, vj_, 0, 1, 0), rule);
}

bool ExactHomogeneousEdge::ContainsExactly(double x, double y) const {
  const int sign = ExactDot(vi_, vj_, x, y, 1).Sign();
  return sign > 0 || (sign == 0 && owns_ties_);
}

}  // namespace rasterproof::reference
