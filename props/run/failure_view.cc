#include "props/run/failure_view.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/profile.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "props/judging/as_shown.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostTriangles = 8;

bool SameShape(const CoverageCounts& a, const CoverageCounts& b) {
  return a.width == b.width && a.height == b.height && a.samples == b.samples;
}

// The first pixel at which the counts differ; (-1, -1) if none does.
std::array<int, 2> FirstWrongPixel(const CoverageCounts& observed, const CoverageCounts& expected) {
  const CoverageDifference difference = Compare(observed, expected);
  if (difference.wrong == 0) return {-1, -1};
  const std::size_t pixel = difference.first_wrong / static_cast<std::size_t>(observed.samples);
  const auto width = static_cast<std::size_t>(observed.width);
  return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
}

PixelRect ViewAround(const Scene& scene, int x, int y, int most) {
  const auto span = [&](int centre, int side) {
    const int first = std::clamp(centre - most / 2, 0, std::max(0, side - most));
    return std::array<int, 2>{first, std::min(side, first + most)};
  };
  const auto [x0, x1] = span(std::max(x, 0), scene.width);
  const auto [y0, y1] = span(std::max(y, 0), scene.height);
  return {x0, y0, x1, y1};
}

// How much a triangle has to do with a sample. Less is more.
struct Concern {
  bool is_beside = false;  // the sample lies neither inside nor on an edge
  double least = 0;        // of |E| over its edges
  int triangle = 0;

  friend auto operator<=>(const Concern&, const Concern&) = default;
};

Concern ConcernOf(const Scene& scene, int triangle, Point2 p) {
  const std::array<Vertex, 3> v =
      rasterproof::Corners(scene, scene.triangles[static_cast<std::size_t>(triangle)]);
  Concern concern{true, std::numeric_limits<double>::infinity(), triangle};
  if (!std::ranges::all_of(v, [](const Vertex& corner) { return IsFinite(corner); })) {
    return concern;
  }
  bool has_positive = false;
  bool has_negative = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const double e = EdgeAt(scene, v[(k + 1) % 3], v[(k + 2) % 3], p).ToDouble();
    has_positive = has_positive || e > 0;
    has_negative = has_negative || e < 0;
    concern.least = std::min(concern.least, std::abs(e));
  }
  concern.is_beside = has_positive && has_negative;
  return concern;
}

// Triangles whose box meets the view: the witness, then those that hold the sample, in them or on
// an edge, then those whose edges pass nearest, until there are enough.
std::vector<int> TrianglesInView(const Scene& scene, const PixelRect& view, int first,
                                 std::optional<Point2> sample) {
  std::vector<Concern> others;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = rasterproof::Corners(scene, scene.triangles[t]);
    const auto x = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto y = std::minmax({v[0].y, v[1].y, v[2].y});
    const bool apart = !scene.clip_space && (x.second < view.x0 || x.first > view.x1 ||
                                             y.second < view.y0 || y.first > view.y1);
    const int triangle = static_cast<int>(t);
    if (apart || triangle == first) continue;
    others.push_back(sample ? ConcernOf(scene, triangle, *sample) : Concern{false, 0, triangle});
  }
  std::ranges::sort(others);
  std::vector<int> found;
  const bool is_there = first >= 0 && static_cast<std::size_t>(first) < scene.triangles.size();
  if (is_there) found.push_back(first);
  for (const Concern& other : others) {
    if (found.size() == kMostTriangles) break;
    found.push_back(other.triangle);
  }
  return found;
}

Point2 SampleAt(const PlacedCase& c, int x, int y, int number) {
  const SamplePattern& pattern = c.profile.pattern;
  const int row = c.profile.y_axis == YAxis::kUp ? c.scene.height - 1 - y : y;
  return pattern.At(x, row, std::clamp(number, 0, pattern.samples() - 1));
}

}  // namespace

exact::Rational EdgeAt(const Scene& scene, const Vertex& a, const Vertex& b, Point2 p) {
  return scene.clip_space ? exact::HomogeneousEdgeValue(a, b, p)
                          : exact::EdgeValue(WindowPoint(a), WindowPoint(b), p);
}

Case AsDrawn(const Case& c, const Verdict& verdict) {
  Case drawn = c;
  if (verdict.drawn == nullptr) return drawn;
  drawn.scene = verdict.drawn->scene;
  drawn.options = verdict.drawn->options;
  return drawn;
}

CoverageCounts BlankTarget(const PlacedCase& c) {
  return {c.scene.width, c.scene.height, c.profile.pattern.samples()};
}

bool HoldsDrawing(const Verdict& verdict, const CoverageCounts& target) {
  return (verdict.compared && SameShape(verdict.compared->expected, target)) ||
         (verdict.seen && SameShape(verdict.seen->counts, target));
}

bool HasPlace(const Verdict& verdict) {
  return verdict.compared != nullptr ||
         (verdict.witness && (verdict.witness->x >= 0 || verdict.witness->triangle >= 0));
}

FailureView ViewOf(const SubjectInfo& subject, const PlacedCase& c, const Verdict& verdict,
                   int side) {
  FailureView view;
  view.scene = IsHomogeneous(c.scene, c.profile) ? c.scene : c.placed;
  // A triangle that is dropped for its extent is shown where it lies.
  view.scene.triangles = c.scene.triangles;
  const CoverageCounts none = BlankTarget(c);
  if (verdict.compared && SameShape(verdict.compared->expected, none)) {
    view.expected = verdict.compared->expected;
    view.observed = verdict.compared->observed;
  } else {
    view.expected = exact::Coverage(c, c.options);
    if (IsJudgedAsShown(subject, c.scene)) view.expected = AsShown(std::move(view.expected));
    view.observed = HoldsDrawing(verdict, none) ? verdict.seen->counts : none;
    // Where nothing is stated of coverage, what was drawn is as good as anything.
    if (c.profile.contract == Contract::kNone) view.expected = view.observed;
  }
  const auto [wrong_x, wrong_y] = FirstWrongPixel(view.observed, view.expected);
  const bool witness = verdict.witness && verdict.witness->x >= 0 && verdict.witness->y >= 0;
  view.focus_x = witness ? verdict.witness->x : wrong_x;
  view.focus_y = witness ? verdict.witness->y : wrong_y;
  view.view = ViewAround(c.scene, view.focus_x, view.focus_y, side);
  if (view.focus_x >= 0) {
    const int number = verdict.witness ? verdict.witness->sample : 0;
    view.sample = SampleAt(c, view.focus_x, view.focus_y, number);
  }
  view.triangles = TrianglesInView(view.scene, view.view,
                                   verdict.witness ? verdict.witness->triangle : -1, view.sample);
  return view;
}

}  // namespace rasterproof::props
