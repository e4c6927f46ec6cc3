// Worlds that a user states: every triangle on a lattice of few bits.
#ifndef RASTERPROOF_PROPS_VECTORS_STATED_WORLD_H_
#define RASTERPROOF_PROPS_VECTORS_STATED_WORLD_H_

#include <cstdint>
#include <string>

#include "core/case.h"
#include "core/profile.h"

namespace rasterproof::props {

/// Every triangle whose coordinates are numbers of `integer_bits` before and `fraction_bits` after
/// the point: from 0 on, or, with a sign, from -2^integer_bits on, and below 2^integer_bits. No
/// symmetry is assumed: a triangle is there from each of its vertices and in both windings, flat
/// ones included. The target is a square of 2^integer_bits pixels.
struct StatedWorld {
  bool has_sign = false;
  int integer_bits = 0;
  int fraction_bits = 0;

  /// Its name: "u3.2", "s3.2".
  std::string Name() const;
  /// Numbers that a coordinate can have.
  std::uint64_t Numbers() const;
  /// Its triangles: Numbers() to the power of 6.
  std::uint64_t Cases() const;
};

/// Reads "3.2", "u3.2" or "s3.2": 1 to 6 bits before the point, 0 to 8 after it, and at most 10
/// with the sign, so that cases are counted in 64 bits.
///
/// Error:      InputError that names --world.
StatedWorld ParseStatedWorld(const std::string& text);

/// Case `index` of the world. Its vertices are the digits of the index to the base of the number of
/// points, the first vertex the lowest one; a digit is y times Numbers() plus x.
///
/// Domain:     index < Cases().
Case CaseOfStatedWorld(const StatedWorld& world, std::uint64_t index, const Profile& profile);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_VECTORS_STATED_WORLD_H_
