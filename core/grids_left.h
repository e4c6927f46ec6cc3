// Subpixel grids of a profile that a subject's drawings have not refuted.
#ifndef RASTERPROOF_CORE_GRIDS_LEFT_H_
#define RASTERPROOF_CORE_GRIDS_LEFT_H_

#include <cstdint>
#include <string>
#include <vector>

namespace rasterproof {

/// A set of grids, by their subpixel bits.
class GridsLeft {
 public:
  /// Grids of more bits than this are not told from no grid.
  static constexpr int kMostBits = 40;

  /// None.
  GridsLeft() = default;
  explicit GridsLeft(std::uint64_t set) : set_(set & kAllGrids) {}

  /// Adds the grid of so many bits; of kMostBits and more: no grid.
  ///
  /// Domain:     bits >= 0.
  void Add(int bits) { set_ |= std::uint64_t{1} << (bits < kMostBits ? bits : kMostBits); }
  void Intersect(GridsLeft others) { set_ &= others.set_; }
  bool IsEmpty() const { return set_ == 0; }
  /// Bit k for the grid of k bits; that of kMostBits for no grid.
  std::uint64_t set() const { return set_; }
  /// "8", "4 to 7", "10 or more", "4 to 6, 8 or more"; "none" if it is empty.
  std::string Text() const;

  friend bool operator==(GridsLeft, GridsLeft) = default;

 private:
  static constexpr std::uint64_t kAllGrids = (std::uint64_t{1} << (kMostBits + 1)) - 1;

  std::uint64_t set_ = 0;
};

/// What the cases on targets of one kind leave of the grids.
struct GridsOnTarget {
  int width = 0;
  int height = 0;
  int samples = 0;
  bool clip_space = false;
  std::uint64_t cases = 0;
  GridsLeft left;

  bool IsOfTheSameTarget(const GridsOnTarget& other) const {
    return width == other.width && height == other.height && samples == other.samples &&
           clip_space == other.clip_space;
  }
};

/// Adds what other cases say: on each kind of target the sets are intersected. Kinds of target are
/// in rising order, so that the sum does not depend on which cases came first.
void AddGrids(const std::vector<GridsOnTarget>& more, std::vector<GridsOnTarget>& to);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_GRIDS_LEFT_H_
