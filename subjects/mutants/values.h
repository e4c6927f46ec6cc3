// The sound base of rasterizers that show the values of channels, in the window and in clip space.
// Homogeneous: nothing is divided by w, so that corners may have any.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_VALUES_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_VALUES_H_

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/channel.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/value_rule.h"
#include "core/vertex.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {

using Weights = std::array<double, 3>;

/// A corner before the division by w, in the profile's axes. In the window w = 1.
struct HomogeneousCorner {
  double x = 0;
  double y = 0;
  double w = 1;
};
using HomogeneousCorners = std::array<HomogeneousCorner, 3>;

/// Which number is asked for, and where.
struct ValueQuestion {
  const std::vector<Point2>& pattern;  ///< the samples of a pixel
  bool clip_space = false;
  Triangle indices{};
  HomogeneousCorners given{};
  HomogeneousCorners placed{};  ///< on the profile's grid
  HomogeneousCorners v{};       ///< those of the two that values belong to
  std::array<double, 3> z{};
  int width = 0;  ///< of the target
  int height = 0;
  int column = 0;
  int row = 0;   ///< from the top
  Point2 low{};  ///< the pixel's corner of least x and y
  std::size_t sample = 0;
  Interpolation interpolation = Interpolation::kPerspective;
  EvaluatedAt asked_at = EvaluatedAt::kSample;
  std::optional<std::size_t> channel{};  ///< none: a barycentric or a depth
  Weights a{1, 1, 1};                    ///< the numbers at the corners
  std::size_t provoking = 0;
  Point2 at{};  ///< where it is evaluated

  Point2 Centre() const { return {low.x + 0.5, low.y + 0.5}; }
  bool IsPerspective() const { return interpolation == Interpolation::kPerspective; }
};

/// (V_j x V_k) . (p, 1), (i, j, k) cyclic.
Weights BetasAt(const HomogeneousCorners& v, Point2 p);
/// The factors of the numbers: of the triangle before the division by w, of the screen, or of the
/// numbers over w.
Weights WeightsOf(const ValueQuestion& q);
double WeightedSum(const Weights& weights, const Weights& numbers);
/// The triangle's w at the point.
double WAt(ValueQuestion q);
/// Along the profile's axes, of the plane itself.
std::array<double, 2> AnalyticDerivative(const ValueQuestion& q);
/// The number of an unsigned normalized format nearest to x; x itself as float32; or x.
double InDepthFormat(double x, DepthFormat format);
/// Of kUnorm16, kUnorm24 and kUnorm32.
int UnormBits(DepthFormat format);

/// What the subject states and what it shows. An empty stage is sound, in double.
struct ChannelStages {
  /// States the usual: perspective weights, flat from the first vertex, analytic derivatives.
  ChannelStages();

  Profile profile;
  /// The rasterizer that covers samples, in the window alone; its profile but for `values` is what
  /// the subject states. None: coverage is not judged.
  std::optional<FixedStages> base = {};
  BarycentricsOf barycentrics_of = BarycentricsOf::kGiven;
  double depth_error = 0;  ///< as FragmentInfo::depth_error
  bool takes_clip = true;
  /// The columns and rows that quads begin at: 0, the even ones, or 1.
  int quad_origin = 0;

  /// Changes what is asked for.
  std::function<void(ValueQuestion&)> asked = {};
  std::function<Weights(const ValueQuestion&)> weights = {};
  /// In place of the sum of weighted numbers. Barycentrics remain those of `weights`.
  std::function<double(const ValueQuestion&)> plane = {};
  /// Changes a value, which differences see.
  std::function<double(const ValueQuestion&, double)> value = {};
  /// Changes a derivative.
  std::function<std::array<double, 2>(const ValueQuestion&, std::array<double, 2>)> derivative = {};
  /// Makes a depth, not rounded yet, one of the stated format.
  std::function<double(const ValueQuestion&, double)> depth = {};
};

/// Returns a channel's value as the stages make it.
double EvaluateChannel(const ChannelStages& stages, ValueQuestion q);

/// The rasterizer with the given stages. The last triangle drawn wins.
///
/// Domain:     float32 scenes in the window and, unless it says so, clip space. Triangles that are
///             not finite are not drawn.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ChannelStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_VALUES_H_
