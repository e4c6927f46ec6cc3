#include "subjects/mutants/free_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/scene.h"
#include "core/snap.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/placing.h"
#include "subjects/mutants/real_geometry.h"

namespace rasterproof::subjects::mutants {
namespace {

// A point so near to the end of the tolerance is left alone: the division that led to it rounds.
constexpr double kMargin = 0x1p-20;

std::vector<double> LegalCoordinates(const FreeStages& stages, double x) {
  const double own = SnapToGrid(x, {stages.bits});
  const double step = std::ldexp(1.0, -stages.bits);
  std::vector<double> legal{own};
  for (const double point : {own - step, own + step}) {
    if (std::fabs(point - x) <= (stages.tolerance - kMargin) * step) legal.push_back(point);
  }
  return legal;
}

Point2 LegalPlace(const FreeStages& stages, Point2 at) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return at;
  Point2 worst;
  double most = -std::numeric_limits<double>::infinity();
  const std::vector<double> ys = LegalCoordinates(stages, at.y);
  for (const double x : LegalCoordinates(stages, at.x)) {
    for (const double y : ys) {
      const double harm = stages.harm ? stages.harm(at, {x, y}) : 0;
      if (harm <= most) continue;
      most = harm;
      worst = {x, y};
    }
  }
  return worst;
}

Points InTheWindow(const FreeStages& stages, const std::array<Vertex, 3>& v) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  Points given{};
  for (std::size_t k = 0; k < 3; ++k) {
    given[k] = WindowPoint(v[k]);
    if (stages.takes_clip) given[k] = {v[k].x / v[k].w, v[k].y / v[k].w};
    if (!IsFinite(v[k]) || (stages.takes_clip && !(v[k].w > 0))) given[k] = {kNowhere, kNowhere};
  }
  return given;
}

Points Chosen(const FreeStages& stages, const Points& given) {
  Points placed{};
  for (std::size_t k = 0; k < 3; ++k) placed[k] = LegalPlace(stages, given[k]);
  if (!stages.instead) return placed;
  const auto area = [](const Points& v) { return variants::RoundedEdgeValue(v[0], v[1], v[2]); };
  const bool turned = !(area(given) * area(placed) > 0);
  for (std::size_t k = 0; k < 3; ++k)
    placed[k] = stages.instead({given[k], given, turned}, placed[k]);
  return placed;
}

// Barycentrics are those of the vertices as given, in double.
void WeighTheGiven(variants::Weights& weights, const GridTriangle& t, const Sample& s) {
  const std::array<Vertex, 3> v = t.AsListed(t.given);
  weights = variants::BarycentricsAt({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])},
                                     {s.x + 0.5, s.row + 0.5});
}

}  // namespace

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const FreeStages& stages) {
  FixedStages base;
  base.has_workers = false;
  base.profile = stages.profile;
  base.bits = std::max(8, stages.bits);
  base.model = [bits = base.bits](Profile& profile, const Scene&) { profile.snap = {bits}; };
  base.vertices = [stages](std::array<Vertex, 3>& v) {
    const Points placed = Chosen(stages, InTheWindow(stages, v));
    for (std::size_t k = 0; k < 3; ++k) v[k] = {placed[k].x, placed[k].y, v[k].z, 1};
  };
  base.weights = WeighTheGiven;
  base.id = stages.id;
  if (stages.rule) {
    base.edges = [stages](GridTriangle& t) {
      const TieRule rule = stages.rule(InTheWindow(stages, t.AsListed(t.given)));
      for (GridEdge& edge : t.edges) edge.owns = Owns(edge, rule);
    };
  }
  SubjectInfo info = FixedPointInfo(name, summary, stages.profile);
  info.coverage = stages.coverage;
  info.fragments.barycentrics_of = BarycentricsOf::kGiven;
  info.takes_threads = false;
  info.takes_culling = stages.coverage == CoverageKind::kFacingCounts;
  info.takes_window = !stages.takes_clip;
  info.takes_clip = stages.takes_clip;
  return Make(info, base);
}

}  // namespace rasterproof::subjects::mutants
