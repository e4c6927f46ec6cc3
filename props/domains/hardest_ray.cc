#include "props/domains/hardest_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace rasterproof::props {
namespace {

using Int = Int128;
using Vec = std::array<Int, 3>;

constexpr Int kUnitsPerPixel = 256;

Int Dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// a - k b.
Vec Less(const Vec& a, Int k, const Vec& b) {
  return {a[0] - k * b[0], a[1] - k * b[1], a[2] - k * b[2]};
}

Vec Cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Bezout {
  Int gcd = 0;
  Int s = 0;
  Int t = 0;
};

// s a + t b = gcd >= 0.
Bezout ExtendedEuclid(Int a, Int b) {
  Bezout now{a, 1, 0};
  Bezout next{b, 0, 1};
  while (next.gcd != 0) {
    const Int q = now.gcd / next.gcd;
    now = {now.gcd - q * next.gcd, now.s - q * next.s, now.t - q * next.t};
    std::swap(now, next);
  }
  return now.gcd < 0 ? Bezout{-now.gcd, -now.s, -now.t} : now;
}

// The quotient rounded to an integer next to it.
Int Rounded(Int a, Int b) {
  const Int twice = 2 * a + (((a < 0) != (b < 0)) ? -b : b);
  return twice / (2 * b);
}

// Gauss: afterwards no sum or difference of the two is shorter than the longer one.
void Reduce(Vec& u, Vec& v) {
  if (Dot(u, u) > Dot(v, v)) std::swap(u, v);
  while (true) {
    v = Less(v, Rounded(Dot(u, v), Dot(u, u)), u);
    if (Dot(v, v) >= Dot(u, u)) return;
    std::swap(u, v);
  }
}

// The solutions of n . v = value, v of integers. Numbers stay below 2^120 where n is below 2^60:
// what is multiplied is reduced before.
class Solutions {
 public:
  explicit Solutions(const Vec& n) : n_(n), xy_(ExtendedEuclid(n[0], n[1])) {
    if (xy_.gcd == 0) return;
    u_ = {n[1] / xy_.gcd, -n[0] / xy_.gcd, 0};
    v_ = WithW(-(xy_.gcd / Gcd()), 0);
    Reduce(u_, v_);
  }

  Int Gcd() const { return ExtendedEuclid(xy_.gcd, n_[2]).gcd; }

  // One of n . v = Gcd() times `times`, near the guess: within a step of the lattice of value 0.
  Vec Near(const Vec& guess, Int times) const {
    Vec b = WithW(ExtendedEuclid(xy_.gcd, n_[2]).t, Gcd());
    b = MovedTo(b, {0, 0, 0});
    for (Int& x : b) x *= times;
    return MovedTo(b, guess);
  }

 private:
  // The solution with this w, which there must be, and the least x that is not negative.
  Vec WithW(Int w, Int value) const {
    const Int rest = value - n_[2] * w;
    if (xy_.gcd == 0) return {0, 0, w};
    if (n_[1] == 0) return {rest / n_[0], 0, w};
    const Int m = n_[1] < 0 ? -n_[1] / xy_.gcd : n_[1] / xy_.gcd;
    const Int x = Modulo(Modulo(rest / xy_.gcd, m) * Modulo(xy_.s, m), m);
    return {x, (rest - n_[0] * x) / n_[1], w};
  }

  Vec MovedTo(Vec b, const Vec& place) const {
    for (int k = 0; k < 4; ++k) {
      b = Less(b, Rounded(Dot(u_, Less(b, 1, place)), Dot(u_, u_)), u_);
      b = Less(b, Rounded(Dot(v_, Less(b, 1, place)), Dot(v_, v_)), v_);
    }
    return b;
  }

  Vec n_;
  Bezout xy_;
  // Short vectors that span the solutions of value 0.
  Vec u_{1, 0, 0};
  Vec v_{0, 1, 0};
};

Vec InUnits(Point2 sample) {
  return {static_cast<Int>(static_cast<std::int64_t>(std::ldexp(sample.x, 8))),
          static_cast<Int>(static_cast<std::int64_t>(std::ldexp(sample.y, 8))), kUnitsPerPixel};
}

Vec VecOf(const Ray& ray) { return {ray.x, ray.y, ray.w}; }

Ray DrawRay(BitSource& bits, Point2 near, int range_bits) {
  // A place around the sample, at a distance that leaves x = (its column) w within the range.
  const int w_bits = static_cast<int>(bits.Int(range_bits / 3, range_bits - 8));
  const std::int64_t w = (std::int64_t{1} << w_bits) + static_cast<std::int64_t>(bits.Bits(w_bits));
  const auto along = [&](double centre) {
    const auto off = static_cast<double>(bits.Int(-64 * 256, 64 * 256)) / 256;
    return static_cast<std::int64_t>(std::clamp(centre + off, -96.0, 96.0) *
                                     static_cast<double>(w));
  };
  const std::int64_t x = along(near.x);
  const std::int64_t y = along(near.y);
  const std::int64_t most = (std::int64_t{1} << range_bits) - 1;
  return {std::clamp(x, -most, most), std::clamp(y, -most, most), w};
}

}  // namespace

std::optional<Ray> RayOfValue(const Ray& normal, std::int64_t value, const Ray& guess, int bits) {
  const Solutions solutions(VecOf(normal));
  if (value % solutions.Gcd() != 0) return std::nullopt;
  const Vec b = solutions.Near(VecOf(guess), value / solutions.Gcd());
  const Int most = Int{1} << bits;
  if (std::ranges::any_of(b, [&](Int x) { return x >= most || x <= -most; })) return std::nullopt;
  return Ray{static_cast<std::int64_t>(b[0]), static_cast<std::int64_t>(b[1]),
             static_cast<std::int64_t>(b[2])};
}

HardRays DrawHardestRays(BitSource& bits, Point2 sample, int range_bits) {
  const int range = std::min(range_bits, 44);
  HardRays rays;
  rays.a = DrawRay(bits, sample, range);
  const Ray guess = DrawRay(bits, sample, range);
  const bool is_negative = bits.Chance(128);
  Vec n = Cross(InUnits(sample), VecOf(rays.a));
  // Samples are mostly multiples of a half: what they all share makes no value smaller.
  Int shared = 0;
  for (const Int x : n) shared = ExtendedEuclid(shared, x).gcd;
  if (shared == 0) return {rays.a, guess};  // the sample's own ray
  for (Int& x : n) x /= shared;
  const Ray normal{static_cast<std::int64_t>(n[0]), static_cast<std::int64_t>(n[1]),
                   static_cast<std::int64_t>(n[2])};
  rays.b = RayOfValue(normal, is_negative ? -1 : 1, guess, range).value_or(guess);
  return rays;
}

Int128 ValueOfRays(Point2 sample, const HardRays& rays) {
  return Dot(Cross(InUnits(sample), VecOf(rays.a)), VecOf(rays.b));
}

}  // namespace rasterproof::props
