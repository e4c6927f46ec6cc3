// Points and vectors of rational numbers, and how random ones are drawn.
#ifndef RASTERPROOF_TESTS_STATEMENTS_RATIONAL_PLANE_H_
#define RASTERPROOF_TESTS_STATEMENTS_RATIONAL_PLANE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/vertex.h"
#include "exact/rational.h"
#include "props/domains/bit_source.h"
#include "tests/statements/statement.h"

namespace rasterproof::props {

using exact::Rational;

struct Vec2 {
  Rational x;
  Rational y;
};
inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(const Rational& s, const Vec2& a) { return {s * a.x, s * a.y}; }
inline bool operator==(const Vec2& a, const Vec2& b) { return a.x == b.x && a.y == b.y; }
inline Rational Dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
/// The z of the cross product: det[a; b].
inline Rational Cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
/// Its coordinates rounded to the nearest doubles.
inline Point2 ToPoint(const Vec2& v) { return {v.x.ToDouble(), v.y.ToDouble()}; }
/// Rotation by x' = -y, y' = x: counter-clockwise with y up.
inline Vec2 Rotated(const Vec2& a) { return {-a.y, a.x}; }

struct Vec3 {
  Rational x;
  Rational y;
  Rational z;
};
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Rational Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec2 Flat(const Vec3& a) { return {a.x, a.y}; }
/// (x / z, y / z).
inline Vec2 Projected(const Vec3& a) { return {a.x / a.z, a.y / a.z}; }

/// E(a, b; p) = det[p - a; b - a].
inline Rational Edge(const Vec2& a, const Vec2& b, const Vec2& p) { return Cross(p - a, b - a); }
/// The textbook orientation: positive for counter-clockwise with y up.
inline Rational Orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  return Cross(b - a, c - a);
}

using Triangle2 = std::array<Vec2, 3>;
using Barycentrics3 = std::array<Rational, 3>;

/// lambda_i = E(edge opposite v_i; p) / E(v0, v1; v2).
Barycentrics3 BarycentricsOf(const Triangle2& t, const Vec2& p);
Vec2 Combined(const Barycentrics3& l, const Triangle2& t);
/// In the closed triangle, by barycentrics: for triangles of non-zero area.
bool IsInside(const Triangle2& t, const Vec2& p);
/// (2 T)^2 by Heron's formula, which knows nothing of signs and axes.
Rational SquaredDoubleArea(const Vec2& a, const Vec2& b, const Vec2& c);
/// Squared distance of p from the line through a and b.
Rational SquaredDistance(const Vec2& a, const Vec2& b, const Vec2& p);

/// Random rationals: small integers (so that coincidences happen) and multiples of 2^-8.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t index) : bits_(seed, index) {}
  bool Coin() { return bits_.Bits(1) != 0; }
  Rational Number();
  /// In [0, 1].
  Rational Part();
  Rational Positive();
  Vec2 Point() { return {Number(), Number()}; }
  Triangle2 AnyTriangle() { return {Point(), Point(), Point()}; }
  /// Of non-zero area.
  Triangle2 ProperTriangle();
  /// A point of the closed triangle; often of its boundary.
  Vec2 PointInside(const Triangle2& t);
  /// (x, y, z) with z not zero, of either sign or positive.
  Vec3 EyePoint(bool in_front);

 private:
  PhiloxSource bits_;
};

/// Draws `count` configurations. The trial returns nothing where the precondition is not met.
StatementTally Over(std::uint64_t seed, int count,
                    const std::function<std::optional<bool>(Draws&)>& trial);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_TESTS_STATEMENTS_RATIONAL_PLANE_H_
