#include "bench/stages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/draw_options.h"
#include "core/snap.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/segment_distance.h"
#include "model/snap.h"

namespace rasterproof::bench {
namespace {

using exact::Rational;

// What is left of a triangle: a convex polygon in clip space, or in window space.
struct Polygon {
  std::vector<Vertex> corners;
  bool is_window = false;
};

double Dot(const std::array<double, 4>& row, const std::array<double, 3>& v) {
  return row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3];
}

double FloatDot(const std::array<double, 4>& row, const std::array<double, 3>& v) {
  const auto product = [&](std::size_t k) {
    return static_cast<float>(row[k]) * static_cast<float>(v[k]);
  };
  const float sum = (product(0) + product(1)) + product(2);
  return double{sum + static_cast<float>(row[3])};
}

// The place on the near plane between a, in front of it, and b. Window space.
std::array<Rational, 2> ExactCrossing(const Vertex& a, const Vertex& b, double near_w) {
  const Rational n = near_w;
  const Rational of_a = n - b.w;
  const Rational of_b = Rational(a.w) - n;
  const Rational by = (Rational(a.w) - b.w) * n;
  return {(of_a * a.x + of_b * b.x) / by, (of_a * a.y + of_b * b.y) / by};
}

Vertex FloatCrossing(const Vertex& a, const Vertex& b, double near_w) {
  const auto minus = [](double p, double q) { return static_cast<float>(p - q); };
  const float t = minus(a.w, near_w) / minus(a.w, b.w);
  const auto between = [&](double p, double q) {
    const float along = t * minus(q, p);
    return double{static_cast<float>(p + double{along})};
  };
  return {between(a.x, b.x), between(a.y, b.y), 0, between(a.w, b.w)};
}

// Clips and places one triangle of clip space.
class Placing {
 public:
  Placing(const InexactStages& inexact, double near_w) : inexact_(inexact), near_w_(near_w) {}

  Polygon InWindow(const std::array<Vertex, 3>& v) const {
    Polygon polygon{.corners = {}, .is_window = true};
    ForEachCorner(
        v,
        [&](const Vertex& at) {
          polygon.corners.push_back(Placed(Rational(at.x) / at.w, Rational(at.y) / at.w));
        },
        [&](const Vertex& a, const Vertex& b) {
          const auto [x, y] = ExactCrossing(a, b, near_w_);
          polygon.corners.push_back(Placed(x, y));
        });
    return polygon;
  }

  Polygon InClipSpace(const std::array<Vertex, 3>& v) const {
    Polygon polygon;
    ForEachCorner(
        v, [&](const Vertex& at) { polygon.corners.push_back(at); },
        [&](const Vertex& a, const Vertex& b) {
          polygon.corners.push_back(FloatCrossing(a, b, near_w_));
        });
    return polygon;
  }

 private:
  // Calls given(v) for each corner in front, crossing(in front, behind) for each edge that the near
  // plane cuts, around the polygon.
  template <class Given, class Crossing>
  void ForEachCorner(const std::array<Vertex, 3>& v, Given given, Crossing crossing) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& a = v[k];
      const Vertex& b = v[(k + 1) % 3];
      const bool a_in_front = a.w >= near_w_;
      const bool b_in_front = b.w >= near_w_;
      if (a_in_front) given(a);
      if (a_in_front != b_in_front) crossing(a_in_front ? a : b, a_in_front ? b : a);
    }
  }

  double Coordinate(const Rational& x) const {
    if (inexact_.divide) return double{x.ToFloat()};
    return SnapCoordinate(x.ToDouble(), {inexact_.snap_bits, SnapRule::kNearestEven});
  }
  Vertex Placed(const Rational& x, const Rational& y) const {
    return {Coordinate(x), Coordinate(y)};
  }

  InexactStages inexact_;
  double near_w_;
};

// f32-direct on a triangle of window space, ties to top and left edges.
bool FloatCovers(std::array<Point2, 3> v, Point2 p, exact::Decider decider) {
  const int facing = exact::Facing(v, decider);
  if (facing == 0) return false;
  if (facing < 0) std::swap(v[1], v[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    const auto dx = static_cast<float>(b.x - a.x);
    const auto dy = static_cast<float>(b.y - a.y);
    const float left = static_cast<float>(p.x - a.x) * dy;
    const float right = static_cast<float>(p.y - a.y) * dx;
    const bool owns_ties = dy > 0 || (dy == 0 && dx < 0);
    if (left < right || (left == right && !owns_ties)) return false;
  }
  return true;
}

// Whether what lies on the triangle behind the sample lies in front of the near plane.
//
// Domain:     the ray through the sample meets the triangle.
bool IsInFront(const std::array<Vertex, 3>& v, Point2 p, double near_w) {
  using Vector = std::array<Rational, 3>;
  const auto from_first = [&](const Vertex& b) {
    return Vector{Rational(b.x) - v[0].x, Rational(b.y) - v[0].y, Rational(b.w) - v[0].w};
  };
  const Vector s = from_first(v[1]);
  const Vector t = from_first(v[2]);
  const Vector normal{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2],
                      s[0] * t[1] - s[1] * t[0]};
  const Rational plane = normal[0] * v[0].x + normal[1] * v[0].y + normal[2] * v[0].w;
  const Rational along = normal[0] * p.x + normal[1] * p.y + normal[2];
  return plane / along >= Rational(near_w);
}

// The frame as it comes out, triangle by triangle.
class Frame {
 public:
  Frame(const FrameInput& input, const InexactStages& inexact, exact::Decider decider)
      : input_(input), inexact_(inexact), decider_(decider), placing_(inexact_, input.near_w) {
    for (const auto& place : input.places) {
      const auto times = [&](std::size_t row) {
        return inexact.transform ? FloatDot(input.matrix[row], place)
                                 : Dot(input.matrix[row], place);
      };
      clip_.push_back({times(0), times(1), 0, times(2)});
    }
  }

  // The triangle that Covers() is asked about.
  void Take(const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) v_[k] = clip_[static_cast<std::size_t>(t[k])];
    if (InWindow()) {
      polygon_ = placing_.InWindow(v_);
    } else if (inexact_.clip) {
      polygon_ = placing_.InClipSpace(v_);
    }
  }
  bool Covers(Point2 p) const {
    if (InWindow() || inexact_.clip) return PolygonCovers(p);
    if (!exact::HomogeneousCovers(v_, p, {}, decider_)) return false;
    const bool is_cut =
        std::ranges::any_of(v_, [&](const Vertex& at) { return at.w < input_.near_w; });
    return !is_cut || IsInFront(v_, p, input_.near_w);
  }
  // In window space, to a rounding to double.
  std::vector<Point2> Outline() const {
    std::vector<Point2> outline;
    for (const Vertex& at : placing_.InWindow(v_).corners) outline.push_back(WindowPoint(at));
    return outline;
  }

 private:
  static Point2 WindowPoint(const Vertex& at) { return {at.x, at.y}; }
  bool InWindow() const { return inexact_.divide || inexact_.snap_bits >= 0 || inexact_.coverage; }
  bool PolygonCovers(Point2 p) const {
    const std::vector<Vertex>& c = polygon_.corners;
    for (std::size_t k = 2; k < c.size(); ++k) {
      const std::array<Vertex, 3> v{c[0], c[k - 1], c[k]};
      const std::array<Point2, 3> w{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
      const bool covers = !polygon_.is_window ? exact::HomogeneousCovers(v, p, {}, decider_)
                          : inexact_.coverage ? FloatCovers(w, p, decider_)
                                              : exact::Covers(w, p, {}, decider_);
      if (covers) return true;
    }
    return false;
  }

  const FrameInput& input_;
  InexactStages inexact_;
  exact::Decider decider_;
  Placing placing_;
  std::vector<Vertex> clip_;
  std::array<Vertex, 3> v_{};
  Polygon polygon_;
};

double OutlineDistance(const std::vector<Point2>& outline, Point2 p) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    distance =
        std::min(distance, SegmentDistance(outline[k], outline[(k + 1) % outline.size()], p));
  }
  return distance;
}

void Count(bool is_wrong, double distance, BenchStage& stage) {
  ++stage.asked;
  if (!is_wrong) return;
  ++stage.wrong;
  stage.displacement = std::max(stage.displacement, distance);
}

// The pixels of the target whose centres can lie at most a pixel from the outline.
PixelRect AreaOf(const std::vector<Point2>& outline, const FrameInput& frame) {
  PixelRect area{frame.width, frame.height, 0, 0};
  const auto within = [](double x, int size) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(size)));
  };
  for (const Point2& at : outline) {
    area.x0 = std::min(area.x0, within(std::floor(at.x) - 2, frame.width));
    area.y0 = std::min(area.y0, within(std::floor(at.y) - 2, frame.height));
    area.x1 = std::max(area.x1, within(std::ceil(at.x) + 2, frame.width));
    area.y1 = std::max(area.y1, within(std::ceil(at.y) + 2, frame.height));
  }
  return area;
}

// x, y and w rows of a camera that looks at the torus along its tilted axis.
std::array<std::array<double, 4>, 3> MatrixFor(int width, int height) {
  constexpr double kTilt = 1;
  constexpr double kTurn = 0.3;
  constexpr double kAway = 1.25;
  const double c = std::cos(kTilt);
  const double s = std::sin(kTilt);
  const std::array<double, 4> right{std::cos(kTurn), -std::sin(kTurn), 0, 0};
  const std::array<double, 4> down{std::sin(kTurn) * c, std::cos(kTurn) * c, -s, 0};
  const std::array<double, 4> away{std::sin(kTurn) * s, std::cos(kTurn) * s, c, kAway};
  const double scale = 1.34 * height;
  const auto rounded = [](double x, int bits) {
    return std::ldexp(std::round(std::ldexp(x, bits)), -bits);
  };
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t k = 0; k < 4; ++k) {
    rows[0][k] = rounded(0.5 * width * away[k] + scale * right[k], 13);
    rows[1][k] = rounded(0.5 * height * away[k] + scale * down[k], 13);
    rows[2][k] = rounded(away[k], 20);
  }
  return rows;
}

}  // namespace

FrameInput TorusFrame(int part) {
  FrameInput frame;
  frame.width = 1920;
  frame.height = 1080;
  frame.near_w = 0.5;
  frame.matrix = MatrixFor(frame.width, frame.height);
  const int around = 256 / part;
  const int through = 128 / part;
  const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 16)), -16); };
  for (int j = 0; j < through; ++j) {
    for (int i = 0; i < around; ++i) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / through;
      const double ring = 1 + 0.45 * std::cos(v);
      frame.places.push_back(
          {rounded(ring * std::cos(u)), rounded(ring * std::sin(u)), rounded(0.45 * std::sin(v))});
    }
  }
  const auto at = [&](int i, int j) { return j % through * around + i % around; };
  for (int j = 0; j < through; ++j) {
    for (int i = 0; i < around; ++i) {
      frame.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      frame.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return frame;
}

std::vector<BenchStage> JudgeStages(const FrameInput& frame, std::span<const InexactStages> inexact,
                                    exact::Decider decider) {
  std::vector<BenchStage> stages(inexact.size());
  Frame exact(frame, {}, decider);
  std::vector<Frame> drawn;
  for (const InexactStages& one : inexact) drawn.emplace_back(frame, one, decider);
  for (const Triangle& t : frame.triangles) {
    exact.Take(t);
    for (Frame& one : drawn) one.Take(t);
    const std::vector<Point2> outline = exact.Outline();
    const PixelRect area = AreaOf(outline, frame);
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x) {
        const Point2 p = CentreOf(x, y);
        const double distance = OutlineDistance(outline, p);
        if (distance > 1) continue;
        const bool covers = exact.Covers(p);
        for (std::size_t k = 0; k < stages.size(); ++k) {
          Count(drawn[k].Covers(p) != covers, distance, stages[k]);
        }
      }
    }
  }
  return stages;
}

void RunStages(int part, BenchResult& result) {
  struct Row {
    const char* name;
    const char* summary;
    InexactStages inexact;
  };
  const std::array rows{
      Row{"transform",
          "A row times a place: products and sums rounded to float32",
          {.transform = true}},
      Row{"clip", "New vertices on the near plane, interpolated in float32", {.clip = true}},
      Row{"divide", "x / w and y / w rounded to float32", {.divide = true}},
      Row{"snap", "Window coordinates rounded to 1/256 pixel", {.snap_bits = 8}},
      Row{"coverage",
          "Edge functions of f32-direct, every operation rounded to float32",
          {.coverage = true}}};
  std::vector<InexactStages> inexact;
  for (const Row& row : rows) inexact.push_back(row.inexact);
  std::vector<BenchStage> stages = JudgeStages(TorusFrame(part), inexact);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    stages[k].name = rows[k].name;
    stages[k].summary = rows[k].summary;
    result.stages.push_back(std::move(stages[k]));
  }
}

}  // namespace rasterproof::bench
