// Hardest cases in clip space: the smallest value of a homogeneous edge that is not zero.
#ifndef RASTERPROOF_PROPS_DOMAINS_HARDEST_RAY_H_
#define RASTERPROOF_PROPS_DOMAINS_HARDEST_RAY_H_

#include <cstdint>
#include <optional>

#include "core/vertex.h"
#include "props/domains/bit_source.h"
#include "props/domains/hardest.h"

namespace rasterproof::props {

/// A clip-space vertex (x, y, w) of integers, or a normal.
struct Ray {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t w = 0;

  friend bool operator==(const Ray&, const Ray&) = default;
};

/// Returns a vertex b, |x|, |y|, |w| < 2^bits, with normal . b = value.
///
/// The vertices of value 0 are a lattice of two dimensions, which Gauss's algorithm reduces; one of
/// the value, from the extended algorithm of Euclid twice, is moved along it to near `guess`.
/// Domain:     normal not zero, its components below 2^60 in magnitude; |value| below 2^32;
///             bits <= 44; guess within the range.
/// Returns:    nothing if value is no multiple of the components' greatest common divisor, or the
///             vertex found is out of range.
std::optional<Ray> RayOfValue(const Ray& normal, std::int64_t value, const Ray& guess, int bits);

/// The ends of an edge that nearly meets the ray of a sample.
struct HardRays {
  Ray a;
  Ray b;
};

/// Draws two vertices of integers below 2^bits with det(p, a, b) = +-g, p = k (x, y, 1) the sample
/// as integers and g the greatest common divisor of what p x a holds: no other b comes nearer and
/// is not on the edge's plane.
///
/// Domain:     16 <= range_bits; more than 44 are taken for 44. A sample of coordinates below 2^6
///             that are multiples of 2^-8.
HardRays DrawHardestRays(BitSource& bits, Point2 sample, int range_bits);

/// det(p, a, b) = p . (a x b) of the rays, p = 256 (x, y, 1), in units of 1/256.
Int128 ValueOfRays(Point2 sample, const HardRays& rays);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_HARDEST_RAY_H_
