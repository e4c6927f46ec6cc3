// Decided by an edge's ends alone: who owns a sample on it, and which end comes first.
#ifndef RASTERPROOF_REFERENCE_EDGE_OWNERSHIP_H_
#define RASTERPROOF_REFERENCE_EDGE_OWNERSHIP_H_

#include <cstdint>
#include <limits>
#include <type_traits>

namespace rasterproof::reference {

enum class EdgeOwnership {
  kTopLeft,
  kInclusive  ///< `>=` on all edges, as textbooks print it: shared edges are covered twice
};

/// Returns whether the edge a -> b of a triangle of positive area is a left or a top edge.
///
/// The sample moves by (+e, +e^2), e -> 0+, and E with it by e dY - e^2 dX: it goes inside if
/// dY > 0 (left edge), or dY = 0 and dX < 0 (top edge). Comparing the ends needs no subtraction, so
/// the answer is right even where dX or dY would round or overflow.
template <class P>
bool IsTopLeft(const P& a, const P& b) {
  return a.y < b.y || (a.y == b.y && b.x < a.x);
}

/// The smallest E that counts as inside: 0 where ties are owned, else the smallest positive value.
///
/// E >= smallest positive subnormal is E > 0, so one comparison serves both kinds of edge.
template <class T>
constexpr T InsideFrom(bool owns_ties) {
  if constexpr (std::is_floating_point_v<T>) {
    return owns_ties ? T{0} : std::numeric_limits<T>::denorm_min();
  } else {
    return owns_ties ? T{0} : T{1};
  }
}

/// Returns 1 if the edge value is inside, else 0. NaN and infinity never are.
///
/// A number, so that kernels combine three of them without a branch.
template <class T>
constexpr std::uint32_t IsInside(T e, T from) {
  return std::uint32_t{e >= from} & std::uint32_t{e <= std::numeric_limits<T>::max()};
}

/// Returns whether canonical order, the lexicographically smaller end first, turns a -> b round.
template <class P>
bool RunsBackwards(const P& a, const P& b) {
  return b.x < a.x || (b.x == a.x && b.y < a.y);
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_EDGE_OWNERSHIP_H_
