#include "props/judging/freedom/grid_ruler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/vertex.h"

namespace rasterproof::props {
namespace {

// A seam goes one column to the right in so many rows.
constexpr int kRowsOfAColumn = 3;
constexpr int kColumnsBetweenSeams = 3;
constexpr int kMostSeams = 5;
// Shorter seams pass too few samples, and longer ones show no more.
constexpr int kFewestRows = 5;
constexpr int kEnoughRows = 12;
constexpr int kMostRowsOfASeam = 48;
// The finest seam: float32 holds its ends on targets of up to kLargestSide.
constexpr int kFinestSeam = 13;
constexpr int kLargestSide = 1 << 10;
// Seams of which a triangle is drawn alone.
constexpr std::size_t kMostAlone = 3;

// In the order of their use.
std::vector<int> BitsOfSeams(const TargetProfile& profile) {
  const int own = profile.snap.bits;
  const int least = std::max(1, *profile.freedom.least_bits);
  std::vector<int> bits{own, own + 1, least + 1, own + 3};
  for (int k = least + 2; k <= kFinestSeam; ++k) bits.push_back(k);
  std::vector<int> once;
  for (const int k : bits) {
    if (k >= 1 && k <= kFinestSeam && std::ranges::find(once, k) == once.end()) once.push_back(k);
  }
  return once;
}

// The line x = column + (y - row) / 3 through samples, and a grid of so many bits.
struct SampleLine {
  double column;
  double row;
  int bits;

  // The odd multiple of 2^-bits next to the line from the left at y, if it is a third of 2^-bits
  // off.
  std::optional<double> NextTo(int y) const {
    const double thirds = std::ldexp(kRowsOfAColumn * column + (y - row), bits);
    if (thirds != std::floor(thirds)) return std::nullopt;
    const double odd = 2 * std::floor((thirds / kRowsOfAColumn - 1) / 2) + 1;
    if (thirds - kRowsOfAColumn * odd != 1) return std::nullopt;
    return std::ldexp(odd, -bits);
  }
};

// The first of the rows from `y` on, by steps of `step`, at which the line has such a point.
std::optional<Point2> EndOf(const SampleLine& line, int y, int step) {
  for (int tried = 0; tried < 2 * kRowsOfAColumn; ++tried, y += step) {
    if (const std::optional<double> x = line.NextTo(y)) return Point2{*x, static_cast<double>(y)};
  }
  return std::nullopt;
}

struct Seam {
  Point2 top;
  Point2 bottom;
};

std::optional<Seam> SeamAlong(const SampleLine& line, int rows) {
  const std::optional<Point2> top = EndOf(line, 0, 1);
  std::optional<Point2> bottom = EndOf(line, rows, -1);
  if (!top || !bottom || bottom->y - top->y < kFewestRows) return std::nullopt;
  bottom->x += std::ldexp(2.0, -line.bits);
  return Seam{*top, *bottom};
}

// As many seams as have room beside each other, at a length that shows enough, and their rows.
struct Room {
  int seams = 0;
  int rows = 0;
};

Room RoomOn(int width, int height) {
  for (int seams = kMostSeams; seams > 0; --seams) {
    const int columns = width - 2 - kColumnsBetweenSeams * seams;
    const int rows = std::min({height, kMostRowsOfASeam, kRowsOfAColumn * columns});
    if (rows >= std::min(height, kEnoughRows)) return {seams, rows};
  }
  return {1, std::min(height, kRowsOfAColumn * (width - 2 - kColumnsBetweenSeams))};
}

void Add(const std::array<Point2, 3>& corners, Scene& scene) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2 p : corners) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

GridRuler GridRulerOn(const TargetProfile& profile, int width, int height, Precision precision) {
  Scene empty;
  empty.width = width;
  empty.height = height;
  empty.precision = precision;
  GridRuler ruler{empty, {}};
  if (profile.fixed || profile.snap.IsNone() || std::max(width, height) > kLargestSide) {
    return ruler;
  }
  const std::vector<int> bits = BitsOfSeams(profile);
  const Room room = RoomOn(width, height);
  const Point2 sample = profile.pattern.At(0, 0);
  for (int k = 0; k < std::min(room.seams, static_cast<int>(bits.size())); ++k) {
    const double column = 1 + kColumnsBetweenSeams * k + sample.x;
    const auto seam = SeamAlong({column, sample.y, bits[static_cast<std::size_t>(k)]}, room.rows);
    if (!seam) continue;
    const auto [top, bottom] = *seam;
    const Point2 right{std::ceil(top.x) + 2, top.y};
    Add({top, right, bottom}, ruler.seams);
    if (ruler.alone.size() < kMostAlone) {
      Add({top, right, bottom}, ruler.alone.emplace_back(empty));
    }
  }
  return ruler;
}

}  // namespace rasterproof::props
