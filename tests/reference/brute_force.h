// An independent oracle for small scenes: every sample, every edge, its own integers.
#ifndef RASTERPROOF_TESTS_REFERENCE_BRUTE_FORCE_H_
#define RASTERPROOF_TESTS_REFERENCE_BRUTE_FORCE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"

namespace rasterproof::reference {

__extension__ using Uint128 = unsigned __int128;

/// A whole number of any size: sign and words of 32 bits, least first. Slow and plain.
class BigInteger {
 public:
  BigInteger() = default;
  /// x as a multiple of 2^-1074.
  explicit BigInteger(double x) : negative_(std::signbit(x)) {
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(x), &exponent);
    auto significand = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = exponent - 53 + 1074;
    for (; shift < 0; ++shift) significand /= 2;  // subnormals: the low bits are zero
    words_.assign(static_cast<std::size_t>(shift) / 32, 0);
    for (Uint128 rest = Uint128{significand} << (shift % 32); rest != 0; rest >>= 32) {
      words_.push_back(static_cast<std::uint32_t>(rest));
    }
    Trim();
  }

  int Sign() const { return words_.empty() ? 0 : (negative_ ? -1 : 1); }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    if (a.negative_ != b.negative_) {
      result.words_ = Sum(a.words_, b.words_);
      result.negative_ = a.negative_;
    } else if (Less(a.words_, b.words_)) {
      result.words_ = Difference(b.words_, a.words_);
      result.negative_ = !a.negative_;
    } else {
      result.words_ = Difference(a.words_, b.words_);
      result.negative_ = a.negative_;
    }
    result.Trim();
    return result;
  }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    result.negative_ = a.negative_ != b.negative_;
    result.words_.assign(a.words_.size() + b.words_.size() + 1, 0);
    for (std::size_t i = 0; i < a.words_.size(); ++i) {
      if (a.words_[i] == 0) continue;
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.words_.size() || carry != 0; ++j) {
        const std::uint64_t factor = j < b.words_.size() ? b.words_[j] : 0;
        const std::uint64_t sum = result.words_[i + j] + a.words_[i] * factor + carry;
        result.words_[i + j] = static_cast<std::uint32_t>(sum);
        carry = sum >> 32;
      }
    }
    result.Trim();
    return result;
  }

 private:
  using Words = std::vector<std::uint32_t>;
  static bool Less(const Words& a, const Words& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }
  static Words Sum(Words a, const Words& b) {
    a.resize(std::max(a.size(), b.size()) + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      carry += std::uint64_t{a[i]} + (i < b.size() ? b[i] : 0);
      a[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return a;
  }
  static Words Difference(Words a, const Words& b) {
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::int64_t next = std::int64_t{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
      borrow = next < 0 ? 1 : 0;
      a[i] = static_cast<std::uint32_t>(next + (borrow << 32));
    }
    return a;
  }
  void Trim() {
    while (!words_.empty() && words_.back() == 0) words_.pop_back();
    if (words_.empty()) negative_ = false;
  }

  Words words_;
  bool negative_ = false;
};

/// Sign of (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x).
inline int BruteForceEdgeSign(Point2 a, Point2 b, Point2 p) {
  const auto minus = [](double x, double y) { return BigInteger(x) - BigInteger(y); };
  return (minus(p.x, a.x) * minus(b.y, a.y) - minus(p.y, a.y) * minus(b.x, a.x)).Sign();
}

/// Whether the triangle, whose area has the sign `facing`, covers p; top-left.
inline bool BruteForceCovers(std::array<Point2, 3> v, int facing, Point2 p) {
  if (facing < 0) std::swap(v[1], v[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 a = v[i];
    const Point2 b = v[(i + 1) % 3];
    const int sign = BruteForceEdgeSign(a, b, p);
    const bool left = b.y > a.y;
    const bool top = b.y == a.y && b.x < a.x;
    if (sign < 0 || (sign == 0 && !left && !top)) return false;
  }
  return facing != 0;
}

/// Counts of a window-space scene, no culling.
inline CoverageCounts BruteForceCounts(const Scene& scene) {
  CoverageCounts counts(scene.width, scene.height);
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> c = Corners(scene, t);
    if (!std::ranges::all_of(c, IsFinite)) continue;
    const std::array<Point2, 3> v{WindowPoint(c[0]), WindowPoint(c[1]), WindowPoint(c[2])};
    const int facing = BruteForceEdgeSign(v[0], v[1], v[2]);
    for (int j = 0; j < scene.height; ++j) {
      for (int i = 0; i < scene.width; ++i) {
        if (!BruteForceCovers(v, facing, {i + 0.5, j + 0.5})) continue;
        ++(facing > 0 ? counts.front : counts.back)[counts.Index(i, j)];
      }
    }
  }
  return counts;
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_TESTS_REFERENCE_BRUTE_FORCE_H_
