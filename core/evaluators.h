// Edge values, and barycentrics with what is interpolated with them, for subjects that show them.
#ifndef RASTERPROOF_CORE_EVALUATORS_H_
#define RASTERPROOF_CORE_EVALUATORS_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vertex.h"

namespace rasterproof {

/// One of the eight ways of stepping: along one axis, either way, by one pixel or by `length`
/// pixels at a time.
struct Step {
  bool along_y = false;
  int sign = +1;
  int length = 1;
};

/// Asks for E(a, b; p), evaluated at p without stepping.
struct EdgeQuestion {
  Point2 a;
  Point2 b;
  Point2 p;
};

/// Asks for the values of E(a, b; .) at p and after each of `steps` steps from there.
struct StepsQuestion {
  Point2 a;
  Point2 b;
  Point2 p;
  Step step;
  int steps = 0;
};

/// The error bounds that a subject states for its edge values.
class EdgeBounds {
 public:
  virtual ~EdgeBounds() = default;

  /// A proven bound on |EdgeEvaluator::Value - E|, or NaN where no bound is stated (overflow,
  /// underflow). 0: exact.
  virtual double ErrorBound(Point2 a, Point2 b, Point2 p) const = 0;
  /// A proven bound on |EdgeEvaluator::Steps(...)[n] - E| for n = 0..steps, or NaN where none is
  /// stated.
  virtual std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                                  int steps) const = 0;
};

/// Edge values, for subjects that show them.
class EdgeEvaluator : public EdgeBounds {
 public:
  /// The subject's value of E(a, b; p), evaluated at p without stepping.
  ///
  /// Units:      pixels squared.
  virtual double Value(Point2 a, Point2 b, Point2 p) const = 0;
  /// The values met when the subject takes `steps` steps from p: steps + 1 entries, the first at p.
  virtual std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const = 0;
  /// The answers to many questions, in their order. A subject on a pipe is asked them together.
  virtual std::vector<double> Values(std::span<const EdgeQuestion> questions) const;
  virtual std::vector<std::vector<double>> Steps(std::span<const StepsQuestion> questions) const;
};

/// The ways to turn edge values into barycentrics.
enum class BarycentricForm : std::uint8_t {
  kVertexArea,   ///< E_i / E(v0, v1; v2)
  kSum,          ///< E_i / fl(E_0 + E_1 + E_2)
  kOneMinus,     ///< l0, l1 over the vertex area, l2 = (1 - l0) - l1
  kUnsignedArea  ///< |area_i| / |area|: only right inside the closed triangle
};

enum class InterpolationForm : std::uint8_t {
  kBarycentrics,  ///< l0 z0 + l1 z1 + l2 z2
  kDeltas,        ///< z0 + l1 (z1 - z0) + l2 (z2 - z0)
  kPerspective    ///< (sum l_i z_i / w_i) / (sum l_i / w_i)
};

/// The ways to measure how near a sample is to the triangle's edges.
enum class WireframeForm : std::uint8_t {
  kBarycentric,  ///< min l_i: a distance in units of the heights
  kDerivative,   ///< min l_i / fwidth(l_i): pixels in the L1 norm of the gradient
  kHeight        ///< min l_i H_i: pixels
};

struct Corner {
  Point2 at;
  double w = 1;
};

/// The error bounds that a subject states for its barycentrics and interpolated values.
class BarycentricBounds {
 public:
  virtual ~BarycentricBounds() = default;

  /// A proven bound on |Barycentrics[i] - lambda_i|, or NaN where none is stated.
  virtual std::array<double, 3> BarycentricErrorBounds(BarycentricForm form,
                                                       const std::array<Point2, 3>& v,
                                                       Point2 p) const = 0;
  /// A proven bound on |l0 + l1 + l2 - 1| (the sum taken exactly), or NaN where none is stated.
  virtual double SumErrorBound(BarycentricForm form, const std::array<Point2, 3>& v,
                               Point2 p) const = 0;
  /// A proven bound on the distance from the exact interpolated value, or NaN.
  virtual double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                         const std::array<double, 3>& attribute,
                                         Point2 p) const = 0;
};

/// Barycentrics and what is interpolated with them, for subjects that show them.
class BarycentricEvaluator : public BarycentricBounds {
 public:
  /// Barycentrics of p: entry i belongs to vertex i.
  virtual std::array<double, 3> Barycentrics(BarycentricForm form, const std::array<Point2, 3>& v,
                                             Point2 p) const = 0;
  virtual double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                             const std::array<double, 3>& attribute, Point2 p) const = 0;
  /// Distance of p to each edge line, entry i for the edge opposite vertex i, in the form's unit.
  virtual std::array<double, 3> EdgeDistances(WireframeForm form, const std::array<Point2, 3>& v,
                                              Point2 p) const = 0;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_EVALUATORS_H_
