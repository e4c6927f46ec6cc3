#include "exact/square.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "exact/crossing.h"
#include "exact/edge.h"
#include "exact/row_edge.h"
#include "exact/sample_frame.h"
#include "exact/signs.h"

namespace rasterproof::exact {
namespace {

// The four sides of the square, grown, as offsets from the pixel's column and row.
struct Sides {
  double low;
  double high;
  double top;
  double bottom;

  Sides(const SquareRegion& region, const SquareFrame& frame)
      : low(-region.half_width),
        high(1 + region.half_width),
        top(low - frame.lift),
        bottom(high - frame.lift) {}
};

// Whether a square that touches a line from its inner side, or from its outer one, counts as inside
// it: as met under kIntersects, as held under kContains.
//
// The line bounds the triangle, or its box; along (gx, gy), signs in screen axes, one goes into it.
// A half-open square includes its floor corner and the sides next to it: it meets a closed set that
// touches it there, and only there. It misses the line of an open set that holds its inside unless
// that line passes its floor corner. A closed square with a corner on the line of a half-open set
// lies in the set if the shift (e, e^2) leads inside.
class Touch {
 public:
  Touch(const SquareRegion& region, bool flat, bool y_up)
      : relation_(region.relation),
        square_(region.square),
        shape_(flat ? Closure::kClosed : region.shape),
        up_(y_up ? -1 : +1) {}

  bool Counts(int gx, int screen_gy) const {
    const int gy = up_ * screen_gy;
    const bool half_open = square_ == Closure::kHalfOpen;
    if (relation_ == SquareRelation::kIntersects) {
      if (shape_ != Closure::kClosed || square_ == Closure::kOpen) return false;
      return !half_open || (gx <= 0 && gy <= 0);
    }
    if (shape_ == Closure::kClosed || square_ == Closure::kOpen) return true;
    if (shape_ == Closure::kOpen) return half_open && (gx < 0 || gy < 0);
    return half_open || gx > 0 || (gx == 0 && gy > 0);
  }

 private:
  SquareRelation relation_;
  Closure square_;
  Closure shape_;
  int up_;
};

// An edge that is not horizontal, as the rows of squares see it: the corner that decides.
class SideEdge {
 public:
  // inner: +1 if the shape lies right of the edge, -1 if left of it.
  SideEdge(Point2 upper, Point2 lower, int inner, const Sides& sides, const SquareRegion& region,
           const Touch& touch)
      : edge_(upper, lower), upper_(upper), lower_(lower), left_(inner > 0) {
    // E rises along x by dy > 0 and along y by -dx.
    const int gy = inner * ((lower.x < upper.x) - (lower.x > upper.x));
    const bool farthest = region.relation == SquareRelation::kIntersects;
    x_ = left_ == farthest ? sides.high : sides.low;
    y_ = (gy > 0) == farthest ? sides.bottom : sides.top;
    least_sign_ = touch.Counts(inner, gy) == left_ ? 0 : 1;
    everywhere_ = farthest && region.growth == SquareGrowth::kEdges;
  }

  // Removes the columns that the edge excludes. If the deciding corner's row passes above or below
  // the edge, another edge or the box excludes more.
  void Cut(int row, std::uint64_t& certain, Columns& columns) const {
    if (columns.first >= columns.last) return;
    const double y = row + y_;
    const bool passes = y >= upper_.y && y <= lower_.y;
    if (!passes && !everywhere_) return;
    const Guess nothing{0, std::numeric_limits<double>::infinity()};
    const int column =
        FirstColumn(passes ? edge_.At(y, x_) : nothing, columns.first, columns.last, certain,
                    [&](int i) { return EdgeSign(upper_, lower_, {i + x_, y}) >= least_sign_; });
    (left_ ? columns.first : columns.last) = column;
  }

 private:
  RowEdge edge_;
  Point2 upper_;
  Point2 lower_;
  bool left_;
  bool everywhere_ = false;
  double x_ = 0;
  double y_ = 0;
  int least_sign_ = 0;  // the first column with at least this sign starts or ends the span
};

// A triangle's edges that are not horizontal, at most three; a segment counts once from each side.
class SideEdges {
 public:
  SideEdges(const std::array<Point2, 3>& v, int facing, const Sides& sides,
            const SquareRegion& region, const Touch& touch) {
    const auto add = [&](Point2 a, Point2 b, int inner) {
      if (a.y == b.y) return;
      if (b.y < a.y) {
        std::swap(a, b);
        inner = -inner;
      }
      edges_[count_++].emplace(a, b, inner, sides, region, touch);
    };
    if (facing == 0) {
      const auto [upper, lower] = std::ranges::minmax(v, {}, &Point2::y);
      add(upper, lower, +1);
      add(upper, lower, -1);
    } else {
      for (unsigned k = 0; k < 3; ++k) add(v[k], v[(k + 1) % 3], facing);
    }
  }

  void Cut(int row, std::uint64_t& certain, Columns& columns) const {
    for (unsigned k = 0; k < count_; ++k) edges_[k]->Cut(row, certain, columns);
  }

 private:
  std::array<std::optional<SideEdge>, 3> edges_;
  unsigned count_ = 0;
};

struct Box {
  Point2 least;
  Point2 most;

  explicit Box(const std::array<Point2, 3>& v)
      : least{std::min({v[0].x, v[1].x, v[2].x}), std::min({v[0].y, v[1].y, v[2].y})},
        most{std::max({v[0].x, v[1].x, v[2].x}), std::max({v[0].y, v[1].y, v[2].y})} {}
};

// The rows that the box meets, or that lie within it. A triangle that reaches above or below a row
// only in a corner holds no square of the row, which its edges decide.
PixelRect WithinBox(const Box& box, const SquareRegion& region, const SquareFrame& frame,
                    const Sides& sides, const Touch& touch) {
  PixelRect rect = frame.clip;
  const bool meets = region.relation == SquareRelation::kIntersects;
  rect.y0 = FirstRowAtOrBelow(box.least.y, !touch.Counts(0, +1), meets ? sides.bottom : sides.top,
                              frame.clip.y0, frame.clip.y1);
  rect.y1 = FirstRowAtOrBelow(box.most.y, touch.Counts(0, -1), meets ? sides.top : sides.bottom,
                              frame.clip.y0, frame.clip.y1);
  if (!meets) return rect;
  rect.x0 = FirstRowAtOrBelow(box.least.x, !touch.Counts(+1, 0), sides.high, frame.clip.x0,
                              frame.clip.x1);
  rect.x1 =
      FirstRowAtOrBelow(box.most.x, touch.Counts(-1, 0), sides.low, frame.clip.x0, frame.clip.x1);
  return rect;
}

// Growth by edges has no box, but horizontal edges still bound the rows.
PixelRect WithinFlatEdges(const std::array<Point2, 3>& v, const SquareFrame& frame,
                          const Sides& sides, const Touch& touch) {
  PixelRect rect = frame.clip;
  for (unsigned k = 0; k < 3; ++k) {
    const double y = v[k].y;
    if (y != v[(k + 1) % 3].y) continue;
    if (v[(k + 2) % 3].y > y) {
      rect.y0 = FirstRowAtOrBelow(y, !touch.Counts(0, +1), sides.bottom, rect.y0, rect.y1);
    } else {
      rect.y1 = FirstRowAtOrBelow(y, touch.Counts(0, -1), sides.top, rect.y0, rect.y1);
    }
  }
  return rect;
}

}  // namespace

void ForEachSquareSpan(const std::array<Point2, 3>& v, const SquareRegion& region,
                       const SquareFrame& frame, const SquareRow& row) {
  const int facing = EdgeSign(v[0], v[1], v[2]);
  const bool meets = region.relation == SquareRelation::kIntersects;
  if (facing == 0 && !meets) return;
  const Sides sides(region, frame);
  const Touch touch(region, facing == 0, frame.y_up);
  SquareRegion grown = region;
  if (facing == 0) grown.growth = SquareGrowth::kSwept;
  const SideEdges edges(v, facing, sides, grown, touch);
  const bool by_edges = meets && grown.growth == SquareGrowth::kEdges;
  const PixelRect rect = by_edges ? WithinFlatEdges(v, frame, sides, touch)
                                  : WithinBox(Box(v), region, frame, sides, touch);
  std::uint64_t certain = 0;
  for (int r = rect.y0; r < rect.y1; ++r) {
    Columns columns{rect.x0, rect.x1};
    edges.Cut(r, certain, columns);
    if (columns.first < columns.last) row(r, columns);
  }
  ThreadTiers().filter += certain;
}

}  // namespace rasterproof::exact
