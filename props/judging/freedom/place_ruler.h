// Strips of a target that tell, whatever else is drawn, where in its pixel each sample lies.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_PLACE_RULER_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_PLACE_RULER_H_

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The ruler divides each axis of a pixel into this many parts. Every grid of 4 bits and more has
/// points on its lines.
inline constexpr int kPlaceParts = 16;

/// Scenes of rectangles that run across the whole target along one axis. Each holds the same parts
/// of every pixel; together they part every two of the sixteen. They are the same for all cases on
/// targets of one size: so two cases that put samples elsewhere cannot both agree with them.
struct PlaceRuler {
  struct Strips {
    Scene scene;
    bool along_rows = false;   ///< the strips lie side by side along y, not along x
    std::uint64_t within = 0;  ///< PlacesLeft::Set of the places in the closed strips
    std::uint64_t inside = 0;  ///< of those in their interior
  };
  std::vector<Strips> strips;
};

/// Returns the ruler for targets of the case's size.
///
/// Domain:     a window-space case.
/// Returns:    no strips where the target is larger than 64 x 64, the input is in fixed point, or
///             legal models may move the strips or clip them.
PlaceRuler PlaceRulerFor(const PlacedCase& c);

/// The places of one sample that the ruler's drawings leave, along both axes: the 16 parts of the
/// pixel and the 17 lines about them. A sample on a border of a strip may be covered or not.
class PlacesLeft {
 public:
  /// Bit 2 k is line k, bit 2 k + 1 the part between lines k and k + 1.
  using Set = std::uint64_t;

  /// The strips cover the sample, or they do not.
  void See(const PlaceRuler::Strips& strips, bool covered);
  bool IsEmpty() const { return left_[0] == 0 || left_[1] == 0; }
  /// Returns the corners of the smallest box that holds all that is left, in the pixel.
  ///
  /// Domain:     not empty.
  std::pair<Point2, Point2> Box() const;

 private:
  static constexpr Set kAll = (Set{1} << (2 * kPlaceParts + 1)) - 1;
  std::array<Set, 2> left_{kAll, kAll};  ///< along x, along y
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_PLACE_RULER_H_
