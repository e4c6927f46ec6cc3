#include "legal/flat_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "exact/edge.h"

namespace rasterproof::legal {
namespace {

// The corners that all others lie between.
std::pair<Point2, Point2> EndsOf(const std::array<Point2, 3>& corners) {
  const auto before = [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto [first, last] = std::minmax_element(corners.begin(), corners.end(), before);
  return {*first, *last};
}

// Whole numbers from the least to the most of `low` and `high`, cut to [begin, end).
std::pair<int, int> Cut(double low, double high, int begin, int end) {
  if (!(low <= high)) return {begin, end};  // not a number: the sum or product overflowed
  const double first =
      std::clamp(std::floor(low), static_cast<double>(begin), static_cast<double>(end));
  const double last =
      std::clamp(std::ceil(high) + 1, static_cast<double>(begin), static_cast<double>(end));
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

bool LiesOnFlat(const std::array<Point2, 3>& corners, Point2 p) {
  const auto [a, b] = EndsOf(corners);
  const auto [low, high] = std::minmax(a.y, b.y);
  return a.x <= p.x && p.x <= b.x && low <= p.y && p.y <= high && exact::EdgeSign(a, b, p) == 0;
}

void ForEachSampleOnFlat(const std::array<Point2, 3>& corners, const exact::SampleFrame& frame,
                         const std::function<void(int x, int row, std::size_t s)>& visit) {
  const auto [a, b] = EndsOf(corners);
  const auto [low, high] = std::minmax(a.y, b.y);
  const PixelRect& clip = frame.clip;
  for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
    const Point2 offset = frame.offsets[s];
    const auto [row0, row1] = Cut(low - offset.y - 1, high - offset.y + 1, clip.y0, clip.y1);
    for (int row = row0; row < row1; ++row) {
      const double y = row + offset.y;
      if (y < low || y > high) continue;
      // Of a part of the segment no longer than itself: each of five roundings is at most u of
      // |a.x| + |b.x|, twice that for the product; 2^-48 is 32 u.
      const double along = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
      const double crossing = a.x + along * (b.x - a.x);
      const double slack = 1 + 0x1p-48 * (std::fabs(a.x) + std::fabs(b.x));
      const double first = a.y == b.y ? a.x : crossing - slack;
      const double last = a.y == b.y ? b.x : crossing + slack;
      const auto [x0, x1] = Cut(first - offset.x, last - offset.x, clip.x0, clip.x1);
      for (int x = x0; x < x1; ++x) {
        if (LiesOnFlat(corners, frame.At(x, row, s))) visit(x, row, s);
      }
    }
  }
}

}  // namespace rasterproof::legal
