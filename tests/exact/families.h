// Families of hard coordinates for the oracle's own tests. They draw from std::mt19937_64 and
// nothing of the property rooms, so that the oracle is tested by other inputs than those it judges.
#ifndef RASTERPROOF_TESTS_EXACT_FAMILIES_H_
#define RASTERPROOF_TESTS_EXACT_FAMILIES_H_

#include <array>
#include <cstdint>
#include <random>
#include <string_view>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "exact/edge.h"

namespace rasterproof::exact {

inline constexpr std::array<Decider, 3> kDeciders{Decider::kFast, Decider::kIntegers,
                                                  Decider::kCgal};

enum class Family : std::uint8_t {
  kUniform,         ///< float32 on screen
  kLattice,         ///< multiples of 1/256, many ties
  kHalfPixels,      ///< small multiples of 1/2: vertices on centres, duplicates, collinear
  kCollinear,       ///< a third point on the line, or one ulp off it
  kMixedExponents,  ///< float32, log-uniform magnitudes
  kFloat32Bits,     ///< any finite float32 pattern
  kFloat64Bits,     ///< any finite double pattern
  kSubnormal,       ///< of float32 and of float64
  kUnderflow,       ///< products of two lie among the subnormals
  kLargest,         ///< near the largest float32 and double
  kNeedle,          ///< 1e30 long, an ulp wide
  kHardestLattice,  ///< extended Euclid: |E| is one unit of the lattice, 24 to 53 bits
  kMovedHardest,    ///< the same with its anchor moved by far smaller numbers
  kSignedZeros,     ///< +-0 and units
  kCount
};
inline constexpr int kFamilies = static_cast<int>(Family::kCount);
std::string_view FamilyName(Family family);

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}

  std::uint64_t Bits() { return bits_(); }
  /// In [0, n).
  int Below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
  double Sign() { return Below(2) == 0 ? -1 : 1; }
  /// In [0, 1).
  double Unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

  /// One coordinate of the family.
  double Coordinate(Family family);
  /// An edge a -> b and a point.
  std::array<Point2, 3> EdgeAndPoint(Family family);
  /// A few triangles on a small target, of any rule, lattice and axis; the vertices of the family.
  Scene SmallScene(Family family, bool clip_space);
  Profile AnyProfile();
  DrawOptions AnyOptions();

 private:
  /// +-2^exponent m, m of [1, 2).
  double Magnitude(int exponent);
  double Subnormal();
  std::array<Point2, 3> Hardest(bool moved);

  std::mt19937_64 bits_;
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_FAMILIES_H_
