#include "subjects/mutants/squares.h"

#include <algorithm>
#include <cstddef>

#include "core/scene.h"
#include "library/exact_sign.h"
#include "subjects/mutants/placing.h"
#include "subjects/mutants/real_geometry.h"

namespace rasterproof::subjects::mutants {
namespace {

using Corners4 = std::array<Point2, 4>;

bool TouchCounts(Contact contact, const std::array<int, 4>& signs) {
  switch (contact) {
    case Contact::kAny:
      return true;
    case Contact::kFloor:
      return signs[0] == 0;
    case Contact::kCeiling:
      return signs[3] == 0;
    case Contact::kNone:
      break;
  }
  return false;
}

// Whether the square reaches the inner side of the edge, or keeps to it.
bool Passes(bool holds, Point2 a, Point2 b, int inner, Contact contact, const Corners4& corners) {
  std::array<int, 4> signs{};
  for (std::size_t k = 0; k < 4; ++k) signs[k] = inner * library::EdgeSign(a, b, corners[k]);
  const auto [least, most] = std::ranges::minmax(signs);
  const int deciding = holds ? least : most;
  return deciding > 0 || (deciding == 0 && TouchCounts(contact, signs));
}

bool MeetsAlong(Contact contact, double a, double b, double low, double high) {
  const bool at_low = contact == Contact::kAny || contact == Contact::kFloor;
  const bool at_high = contact == Contact::kAny || contact == Contact::kCeiling;
  return (b > low || (b == low && at_low)) && (a < high || (a == high && at_high));
}

bool Covers(const SquareStages& stages, const SquareQuestion& q) {
  const int facing = library::EdgeSign(q.v[0], q.v[1], q.v[2]);
  const auto [left, right] = std::minmax({q.v[0].x, q.v[1].x, q.v[2].x});
  const auto [top, bottom] = std::minmax({q.v[0].y, q.v[1].y, q.v[2].y});
  const Contact contact = facing == 0 ? stages.flat_contact : stages.contact;
  if (!stages.holds && !(MeetsAlong(contact, left, right, q.low.x, q.high.x) &&
                         MeetsAlong(contact, top, bottom, q.low.y, q.high.y))) {
    return false;
  }
  if (stages.holds && facing == 0) return false;
  const Corners4 corners = CornersOf(q);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2& a = q.v[k];
    const Point2& b = q.v[(k + 1) % 3];
    if (a == b) continue;
    for (const int inner : {+1, -1}) {
      const bool is_asked = facing == 0 || inner == facing;
      if (is_asked && !Passes(stages.holds, a, b, inner, contact, corners)) return false;
    }
  }
  return true;
}

}  // namespace

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const SquareStages& stages) {
  RealStages base;
  base.profile = stages.profile;
  base.draws_flat = stages.draws_flat;
  base.snap = [grid = stages.placing](double x, bool) { return SnapToGrid(x, grid); };
  const bool up = stages.profile.y_axis == YAxis::kUp;
  const auto in_own_axes = [up](const PointStages::Placed& t) {
    Points v = t.AsListed(t.v);
    for (Point2& p : v) p.y = up ? -p.y : p.y;
    return v;
  };
  if (stages.drops) {
    base.leaves_out = [drops = stages.drops, in_own_axes](const PointStages::Placed& t,
                                                          const Scene&) {
      return drops(in_own_axes(t));
    };
  }
  base.box = [](PixelRect& box, const PointStages::Placed&, const Scene& scene) {
    box = {0, 0, scene.width, scene.height};
  };
  base.value = [](const PointStages::Edge&, const PointStages::Sample&) { return 1; };
  base.times = [stages, in_own_axes, up](const PointStages::Sample& s,
                                         const PointStages::Placed& t) {
    const double u = stages.half_width;
    const int j = up ? s.height - 1 - s.row : s.row;
    const SquareQuestion q{in_own_axes(t), {s.x - u, j - u}, {s.x + 1 + u, j + 1 + u}};
    const bool sound = Covers(stages, q);
    return (stages.instead ? stages.instead(q, sound) : sound) ? 1U : 0U;
  };
  SubjectInfo info = RealGeometryInfo(name, summary, stages.profile);
  info.takes_tiles = false;
  info.takes_scissor = false;
  info.takes_culling = false;
  info.coverage = stages.coverage;
  return Make(info, base);
}

}  // namespace rasterproof::subjects::mutants
