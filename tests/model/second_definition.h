// A second definition of placing, in GMP's rationals, written from docs/subjects.md. Exact steps
// are exact here, rounded ones are rounded by their definition; no code of model/ is used.
#ifndef RASTERPROOF_TESTS_MODEL_SECOND_DEFINITION_H_
#define RASTERPROOF_TESTS_MODEL_SECOND_DEFINITION_H_

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "core/profile.h"
#include "core/snap.h"
#include "core/transform.h"
#include "core/vertex.h"

/// Prints a value in GoogleTest's messages; GMP's operator is in a separate library.
inline void PrintTo(const mpq_class& v, std::ostream* out) { *out << v.get_str(); }

namespace rasterproof::second {

/// A value of IEEE 754, or an exact one on its way to it.
struct Value {
  enum class Kind : std::uint8_t { kFinite, kInfinite, kNaN };
  Kind kind = Kind::kFinite;
  bool negative = false;  ///< of zeros and infinities too
  mpq_class number = 0;   ///< of a finite one

  bool IsZero() const { return kind == Kind::kFinite && number == 0; }
};

/// A format whose finite values are multiples of 2^least below 2^beyond with `digits` digits.
struct Format {
  int digits;
  int least;
  int beyond;
};
inline constexpr Format kFloat32{24, -149, 128};
inline constexpr Format kFloat64{53, -1074, 1024};

mpq_class TwoTo(int exponent);
Value FromDouble(double x);
/// Whether they are one, the sign of a zero included. NaN is NaN.
bool IsSame(const Value& value, double x);

/// Exact operations; what has no value is NaN, and signs of zeros are IEEE's.
Value Negated(Value a);
Value Product(const Value& a, const Value& b);
Value Quotient(const Value& a, const Value& b);
Value Sum(const Value& a, const Value& b);
/// To nearest, ties to even; beyond the largest value to infinity.
Value Rounded(const Value& exact, const Format& format);

/// The integer that `rule` rounds v to.
mpz_class WholeByRule(const mpq_class& v, SnapRule rule);
/// The grid point that the snap takes x to.
///
/// Domain:     of float32 differences: none that overflows float32.
mpq_class Snapped(const mpq_class& x, const Snap& snap);
/// All grid points within the tolerance of x, and the one that it is snapped to; ascending.
std::vector<mpq_class> GridPoints(const mpq_class& x, const Snap& snap, double tolerance);
/// x modulo the span of the input, in its range; x itself if it does not wrap.
mpq_class Wrapped(const mpq_class& x, const FixedInput& fixed);
/// Whether the corners are further apart than the extent, along x or along y.
bool IsLarger(const std::array<std::array<mpq_class, 2>, 3>& corners,
              const MaxPrimitiveExtent& extent);
/// x (or y, turned over if the transform says so) of a clip-space vertex in window space; NaN where
/// the vertex has no place.
///
/// Behind a map: of its x along the given axis. w is not read.
Value InWindow(double x, const Vertex& clip, const Transform& transform, int size, bool flips);

}  // namespace rasterproof::second

#endif  // RASTERPROOF_TESTS_MODEL_SECOND_DEFINITION_H_
