#include "subjects/mutants/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"
#include "subjects/mutants/real_geometry.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::array<std::size_t, 3> kNextCorner{1, 2, 0};

// V_j x V_k, i's edge as a plane: beta_i is its product with (x, y, 1).
std::array<double, 3> EdgePlane(const HomogeneousCorners& v, std::size_t i) {
  const HomogeneousCorner& a = v[kNextCorner[i]];
  const HomogeneousCorner& b = v[kNextCorner[kNextCorner[i]]];
  return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

// Whether a sum is more than the rounding of its terms in double, by far.
bool IsKnown(double sum, double size) { return std::fabs(sum) > size * 0x1p-40; }

// Slivers whose area is lost in double cover nothing.
bool IsInside(const HomogeneousCorners& v, Point2 p) {
  const Weights beta = BetasAt(v, p);
  const double s = beta[0] + beta[1] + beta[2];
  const double d = beta[0] * v[0].w + beta[1] * v[1].w + beta[2] * v[2].w;
  double s_size = 0, d_size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousCorner& b = v[kNextCorner[i]];
    const HomogeneousCorner& c = v[kNextCorner[kNextCorner[i]]];
    const double size = (std::fabs(b.y * c.w) + std::fabs(b.w * c.y)) * std::fabs(p.x) +
                        (std::fabs(b.w * c.x) + std::fabs(b.x * c.w)) * std::fabs(p.y) +
                        std::fabs(b.x * c.y) + std::fabs(b.y * c.x);
    s_size += size;
    d_size += size * std::fabs(v[i].w);
  }
  return IsKnown(s, s_size) && IsKnown(d, d_size) && s / d > 0 &&
         std::ranges::all_of(beta, [s](double x) { return x / s >= 0; });
}

// The columns and rows that may be covered; all of them where a w is not positive.
PixelRect BoxOf(const ValueQuestion& q, bool is_up) {
  PixelRect box{0, 0, q.width, q.height};
  if (std::ranges::any_of(q.v, [](const HomogeneousCorner& c) { return !(c.w > 0); })) return box;
  double x0 = q.width, y0 = q.height, x1 = 0, y1 = 0;
  for (const HomogeneousCorner& c : q.placed) {
    x0 = std::clamp(c.x / c.w - 1, 0.0, x0);
    x1 = std::clamp(c.x / c.w + 2, x1, static_cast<double>(q.width));
    y0 = std::clamp(c.y / c.w - 1, 0.0, y0);
    y1 = std::clamp(c.y / c.w + 2, y1, static_cast<double>(q.height));
  }
  if (is_up) std::tie(y0, y1) = std::pair(q.height - y1, q.height - y0);
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1), static_cast<int>(y1)};
}

class Values final : public Subject {
 public:
  Values(const std::string& name, const std::string& summary, ChannelStages stages)
      : stages_(std::move(stages)) {
    if (stages_.base) {
      stages_.base->profile.values = stages_.profile.values;
      stages_.profile = stages_.base->profile;
      base_ = Make(name, summary, *stages_.base);
      stages_.takes_clip = false;
    }
    info_ = RealGeometryInfo(name, summary, stages_.profile);
    info_.coverage = CoverageKind::kFragments;
    info_.takes_window = true;
    info_.takes_clip = stages_.takes_clip;
    info_.takes_threads = info_.takes_tiles = false;
    info_.takes_scissor = info_.takes_culling = false;
    info_.fragments.barycentrics_of = stages_.barycentrics_of;
    info_.fragments.depth_error = stages_.depth_error;
    info_.fragments.shows_values = info_.fragments.shows_derivatives = true;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  Drawing Show(const DrawJob& job) override {
    if (job.samples != stages_.profile.pattern.samples()) {
      throw SubjectStop(Stop::kNotDrawable, "it has another number of samples a pixel");
    }
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    const std::size_t size = drawing.counts.size();
    const std::size_t channels = job.wants.values ? scene.channels.size() : 0;
    drawing.primitive_ids.assign(size, kNoPrimitive);
    drawing.barycentrics.resize(size);
    drawing.depths.resize(size);
    drawing.values.resize(size * channels);
    if (job.wants.derivatives) drawing.derivatives.resize(size * channels);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const std::array<Vertex, 3> corners = Corners(scene, scene.triangles[t]);
      if (std::ranges::all_of(corners, IsFinite)) ShowTriangle(job, scene, t, corners, drawing);
    }
    return drawing;
  }

 private:
  bool IsUp() const { return stages_.profile.y_axis == YAxis::kUp; }

  ValueQuestion QuestionOf(const Scene& scene, std::size_t t,
                           const std::array<Vertex, 3>& corners) const {
    ValueQuestion q{.pattern = stages_.profile.pattern.locations, .clip_space = scene.clip_space};
    q.indices = scene.triangles[t];
    q.width = scene.width;
    q.height = scene.height;
    const Snap& snap = stages_.profile.snap;
    for (std::size_t k = 0; k < 3; ++k) {
      q.given[k] = {corners[k].x, corners[k].y, scene.clip_space ? corners[k].w : 1};
      q.placed[k] = q.given[k];
      q.z[k] = corners[k].z;
      if (!snap.IsNone() && !scene.clip_space)
        q.placed[k] = {SnapToGrid(corners[k].x, snap), SnapToGrid(corners[k].y, snap), 1};
    }
    q.v = stages_.barycentrics_of == BarycentricsOf::kSnapped ? q.placed : q.given;
    return q;
  }

  // Where the base covers samples.
  CoverageCounts CoveredByBase(const DrawJob& job, const Scene& scene, std::size_t t) const {
    CoverageCounts alone(scene.width, scene.height, job.samples);
    if (!base_) return alone;
    Scene one = scene;
    one.triangles = {scene.triangles[t]};
    DrawOnto(*base_, one, job.options, alone);
    return alone;
  }

  void ShowTriangle(const DrawJob& job, const Scene& scene, std::size_t t,
                    const std::array<Vertex, 3>& corners, Drawing& drawing) const {
    ValueQuestion q = QuestionOf(scene, t, corners);
    const CoverageCounts by_base = CoveredByBase(job, scene, t);
    const PixelRect box = base_ ? PixelRect{0, 0, q.width, q.height} : BoxOf(q, IsUp());
    std::vector<bool> covered(q.pattern.size());
    for (q.row = box.y0; q.row < box.y1; ++q.row) {
      for (q.column = box.x0; q.column < box.x1; ++q.column) {
        const int y = IsUp() ? q.height - 1 - q.row : q.row;
        q.low = {static_cast<double>(q.column), static_cast<double>(y)};
        for (std::size_t s = 0; s < covered.size(); ++s) {
          covered[s] = base_
                           ? by_base.Count(by_base.Index(q.column, q.row, static_cast<int>(s))) != 0
                           : IsInside(q.placed, PlaceOf(q, s));
        }
        for (q.sample = 0; q.sample < covered.size(); ++q.sample) {
          if (covered[q.sample]) Win(job, scene, t, covered, q, drawing);
        }
      }
    }
  }

  static Point2 PlaceOf(const ValueQuestion& q, std::size_t sample) {
    return {q.low.x + q.pattern[sample].x, q.low.y + q.pattern[sample].y};
  }

  // Direct3D's centroid.
  static Point2 PlaceAskedFor(const ValueQuestion& q, EvaluatedAt at,
                              const std::vector<bool>& covered) {
    const auto first = std::ranges::find(covered, true);
    const bool is_whole = std::ranges::find(covered, false) == covered.end();
    if (at == EvaluatedAt::kSample) return PlaceOf(q, q.sample);
    if (at == EvaluatedAt::kCentre || is_whole) return q.Centre();
    return PlaceOf(q, static_cast<std::size_t>(first - covered.begin()));
  }

  void Win(const DrawJob& job, const Scene& scene, std::size_t t, const std::vector<bool>& covered,
           ValueQuestion q, Drawing& drawing) const {
    const std::size_t k = drawing.counts.Index(q.column, q.row, static_cast<int>(q.sample));
    q.at = PlaceOf(q, q.sample);
    drawing.counts.front[k] = 1;
    drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
    drawing.barycentrics[k] = WeightsShown(q);
    drawing.depths[k] = Depth(q);
    if (!job.wants.values) return;
    for (std::size_t c = 0; c < scene.channels.size(); ++c) {
      const Channel& channel = scene.channels[c];
      q.channel = c;
      q.interpolation = channel.interpolation;
      q.asked_at = channel.at;
      q.at = PlaceAskedFor(q, channel.at, covered);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto index = static_cast<std::size_t>(q.indices[i]);
        q.a[i] = q.interpolation == Interpolation::kInverseW ? 1 : channel.values[index];
      }
      q.provoking = stages_.profile.values.provoking == ProvokingVertex::kLast ? 2 : 0;
      const std::size_t entry = k * scene.channels.size() + c;
      drawing.values[entry] = EvaluateChannel(stages_, q);
      if (job.wants.derivatives) drawing.derivatives[entry] = Derivative(q);
    }
  }

  Weights WeightsShown(ValueQuestion q) const {
    const bool on_screen = stages_.profile.values.weights == WeightsIn::kScreen;
    q.interpolation = on_screen ? Interpolation::kLinear : Interpolation::kPerspective;
    if (stages_.asked) stages_.asked(q);
    return stages_.weights ? stages_.weights(q) : WeightsOf(q);
  }

  double Depth(ValueQuestion q) const {
    q.a = q.z;
    q.interpolation = q.clip_space ? Interpolation::kInverseW : Interpolation::kLinear;
    const double depth = WeightedSum(WeightsOf(q), q.z);
    if (stages_.depth) return stages_.depth(q, depth);
    return InDepthFormat(depth, stages_.profile.values.depth);
  }

  std::array<double, 2> Derivative(const ValueQuestion& q) const {
    const DerivativesBy by = stages_.profile.values.derivatives;
    const bool by_quads = by == DerivativesBy::kFine || by == DerivativesBy::kCoarse;
    ValueQuestion changed = q;
    if (!by_quads && stages_.asked) stages_.asked(changed);
    const auto sound = by_quads ? QuadDifference(q) : AnalyticDerivative(changed);
    return stages_.derivative ? stages_.derivative(q, sound) : sound;
  }

  std::array<double, 2> QuadDifference(const ValueQuestion& q) const {
    const bool coarse = stages_.profile.values.derivatives == DerivativesBy::kCoarse;
    const int dx = -((q.column + stages_.quad_origin) % 2);
    const int dy = -((q.row + stages_.quad_origin) % 2);
    const auto at = [&](int columns, int rows) {
      ValueQuestion there = q;
      const int y = IsUp() ? -rows : rows;
      there.column += columns;
      there.row += rows;
      there.low = {q.low.x + columns, q.low.y + y};
      there.at = {q.at.x + columns, q.at.y + y};
      return EvaluateChannel(stages_, there);
    };
    const int row = coarse ? dy : 0;
    const int column = coarse ? dx : 0;
    const double along_y = at(column, dy + 1) - at(column, dy);
    return {at(dx + 1, row) - at(dx, row), IsUp() ? -along_y : along_y};
  }

  ChannelStages stages_;
  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
};

}  // namespace

Weights BetasAt(const HomogeneousCorners& v, Point2 p) {
  Weights beta{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 3> e = EdgePlane(v, i);
    beta[i] = e[0] * p.x + e[1] * p.y + e[2];
  }
  return beta;
}

Weights WeightsOf(const ValueQuestion& q) {
  const Weights beta = BetasAt(q.v, q.at);
  const double s = beta[0] + beta[1] + beta[2];
  const double d = beta[0] * q.v[0].w + beta[1] * q.v[1].w + beta[2] * q.v[2].w;
  Weights weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    switch (q.interpolation) {
      case Interpolation::kPerspective:
        weights[i] = beta[i] / s;
        break;
      case Interpolation::kInverseW:
        weights[i] = beta[i] / d;
        break;
      case Interpolation::kLinear:
      case Interpolation::kFlat:
        weights[i] = beta[i] * q.v[i].w / d;
        break;
    }
  }
  return weights;
}

double WeightedSum(const Weights& weights, const Weights& numbers) {
  return weights[0] * numbers[0] + weights[1] * numbers[1] + weights[2] * numbers[2];
}

double WAt(ValueQuestion q) {
  q.interpolation = Interpolation::kInverseW;
  return 1 / WeightedSum(WeightsOf(q), {1, 1, 1});
}

std::array<double, 2> AnalyticDerivative(const ValueQuestion& q) {
  if (q.interpolation == Interpolation::kFlat) return {0, 0};
  const Weights beta = BetasAt(q.v, q.at);
  // The value is n / d: of each its value and its derivatives by x and y.
  std::array<double, 3> n{}, d{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 3> e = EdgePlane(q.v, i);
    const bool linear = q.interpolation == Interpolation::kLinear;
    const double c = linear ? q.a[i] * q.v[i].w : q.a[i];
    n[0] += beta[i] * c;
    n[1] += e[0] * c;
    n[2] += e[1] * c;
    d[0] += q.IsPerspective() ? beta[i] : beta[i] * q.v[i].w;
    if (!q.IsPerspective()) continue;
    d[1] += e[0];
    d[2] += e[1];
  }
  const double value = n[0] / d[0];
  return {(n[1] - value * d[1]) / d[0], (n[2] - value * d[2]) / d[0]};
}

int UnormBits(DepthFormat format) {
  return format == DepthFormat::kUnorm16 ? 16 : format == DepthFormat::kUnorm24 ? 24 : 32;
}

double InDepthFormat(double x, DepthFormat format) {
  switch (format) {
    case DepthFormat::kUnstated:
    case DepthFormat::kFloat64:
      return x;
    case DepthFormat::kFloat32:
      return static_cast<float>(x);
    case DepthFormat::kUnorm16:
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm32:
      break;
  }
  const double most = std::ldexp(1.0, UnormBits(format)) - 1;
  return std::nearbyint(std::clamp(x, 0.0, 1.0) * most) / most;
}

ChannelStages::ChannelStages() : profile(Float32Profile()) {
  profile.name = "values";
  profile.contract = Contract::kNone;
  profile.values.weights = WeightsIn::kPerspective;
  profile.values.provoking = ProvokingVertex::kFirst;
  profile.values.derivatives = DerivativesBy::kAnalytic;
  profile.values.flat = profile.values.linear = true;
  profile.values.inverse_w = profile.values.centres = true;
}

double EvaluateChannel(const ChannelStages& stages, ValueQuestion q) {
  if (stages.asked) stages.asked(q);
  double value = q.a[q.provoking];
  if (q.interpolation != Interpolation::kFlat) {
    value = stages.plane     ? stages.plane(q)
            : stages.weights ? WeightedSum(stages.weights(q), q.a)
                             : WeightedSum(WeightsOf(q), q.a);
  }
  return stages.value ? stages.value(q, value) : value;
}

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ChannelStages stages) {
  return std::make_unique<Values>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
