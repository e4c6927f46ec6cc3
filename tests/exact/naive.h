// A third implementation of the truth, schoolbook and slow: GMP rationals and a sample that is
// really moved. It shares no code, no number type and no idea of a tie rule with what it checks.
#ifndef RASTERPROOF_TESTS_EXACT_NAIVE_H_
#define RASTERPROOF_TESTS_EXACT_NAIVE_H_

#include <gmpxx.h>

#include <array>
#include <cstddef>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::exact {

struct NaivePoint {
  mpq_class x;
  mpq_class y;
};

inline mpq_class NaiveTwoTo(int exponent) {
  mpq_class power(1);
  if (exponent >= 0) {
    mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return power;
}

inline mpq_class NaiveEdge(const NaivePoint& a, const NaivePoint& b, const NaivePoint& p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

inline NaivePoint NaiveAt(Point2 p) { return {mpq_class(p.x), mpq_class(p.y)}; }

inline int NaiveEdgeSign(Point2 a, Point2 b, Point2 p) {
  return sgn(NaiveEdge(NaiveAt(a), NaiveAt(b), NaiveAt(p)));
}

// The sample moved by e and e^2 with e = 2^-6000. Of doubles, a planar edge value or a homogeneous
// one that is not 0 is at least 2^-3222; a move changes it by less than 2^-6000 * 2^2050. And a
// move by e changes what it changes by at least 2^-6000 * 2^-2148, a move by e^2 by less than
// 2^-12000 * 2^2050.
inline NaivePoint NaiveShifted(NaivePoint p, const TieRule& rule) {
  static const mpq_class e = NaiveTwoTo(-6000);
  static const mpq_class e2 = NaiveTwoTo(-12000);
  if (rule.inclusive || rule.exclusive) return p;
  p.x += rule.sign_x * (rule.y_first ? e2 : e);
  p.y += rule.sign_y * (rule.y_first ? e : e2);
  return p;
}

using NaiveRow = std::array<mpq_class, 3>;

inline mpq_class NaiveDeterminant(const NaiveRow& a, const NaiveRow& b, const NaiveRow& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Whether the ray t (p, 1), t > 0, meets the triangle: p as a combination of the vertices, by
// Cramer. In window space every third coordinate is 1, and that is what barycentrics are.
inline bool NaiveCovers(const std::array<NaiveRow, 3>& v, const NaivePoint& p, bool inclusive) {
  const mpq_class det = NaiveDeterminant(v[0], v[1], v[2]);
  if (det == 0) return false;
  const NaiveRow ray{p.x, p.y, 1};
  const std::array<mpq_class, 3> barycentric{NaiveDeterminant(ray, v[1], v[2]) / det,
                                             NaiveDeterminant(v[0], ray, v[2]) / det,
                                             NaiveDeterminant(v[0], v[1], ray) / det};
  for (const mpq_class& w : barycentric) {
    if (w < 0 || (w == 0 && !inclusive)) return false;
  }
  return true;
}

// Coverage of a scene that needs no snapping, sample by sample, in the profile's own axes: with y
// up the rule's vertical sign turns over, and so does what counts as front.
inline CoverageCounts NaiveCoverage(const Scene& scene, const Profile& profile,
                                    const DrawOptions& options = {}) {
  const bool up = profile.y_axis == YAxis::kUp;
  TieRule rule = profile.tie_rule;
  if (up) rule.sign_y = static_cast<std::int8_t>(-rule.sign_y);
  CoverageCounts counts(scene.width, scene.height, profile.pattern.samples());
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> corners = Corners(scene, t);
    if (!IsFinite(corners[0]) || !IsFinite(corners[1]) || !IsFinite(corners[2])) continue;
    std::array<NaiveRow, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = {corners[k].x, corners[k].y, scene.clip_space ? corners[k].w : 1.0};
    }
    // Front: counter-clockwise on screen. With y down that is a negative determinant.
    const bool front = (NaiveDeterminant(v[0], v[1], v[2]) < 0) != up;
    if (front ? options.cull == Cull::kFront : options.cull == Cull::kBack) continue;
    for (int row = 0; row < scene.height; ++row) {
      for (int i = 0; i < scene.width; ++i) {
        const bool inside_scissor =
            !options.scissor || (i >= options.scissor->x0 && i < options.scissor->x1 &&
                                 row >= options.scissor->y0 && row < options.scissor->y1);
        if (!inside_scissor) continue;
        for (int s = 0; s < counts.samples; ++s) {
          const int j = up ? scene.height - 1 - row : row;
          const NaivePoint p = NaiveShifted(NaiveAt(profile.pattern.At(i, j, s)), rule);
          if (!NaiveCovers(v, p, rule.inclusive)) continue;
          ++(front ? counts.front : counts.back)[counts.Index(i, row, s)];
        }
      }
    }
  }
  return counts;
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_NAIVE_H_
