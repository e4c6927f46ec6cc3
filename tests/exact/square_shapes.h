// Triangles that are hard for square coverage: on a small target, with corners and edges on grid
// lines, beside them, through their crossings.
#ifndef RASTERPROOF_TESTS_EXACT_SQUARE_SHAPES_H_
#define RASTERPROOF_TESTS_EXACT_SQUARE_SHAPES_H_

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "core/square_rule.h"
#include "core/vertex.h"
#include "exact/square.h"

namespace rasterproof::exact {

inline constexpr int kSquareTargetSide = 4;

class SquareDraw {
 public:
  explicit SquareDraw(std::uint64_t seed) : bits_(seed) {}

  int Below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
  /// In the profile's axes, before a y axis that points up is turned over.
  std::array<Point2, 3> Triangle();
  SquareFrame Frame();
  /// Of every decidable relation, closure and growth.
  SquareRegion Region();

 private:
  double Unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Near grid lines: on one, an ulp, a subpixel or a half width beside it.
  double NearLine();
  Point2 Crossing();
  Point2 Anywhere();
  std::array<Point2, 3> ThroughCrossings();
  std::array<Point2, 3> InOnePixel();
  std::array<Point2, 3> Thin();

  std::mt19937_64 bits_;
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_SQUARE_SHAPES_H_
