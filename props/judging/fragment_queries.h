// The fragments that the properties about barycentrics and depths look at, and how far off each may
// be.
#ifndef RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/judging/barycentric_queries.h"
#include "props/property.h"

namespace rasterproof::props {

/// What the subject shows at one covered sample, and what it may be off.
struct Fragment {
  BarycentricQuery
      query;  ///< the visible triangle, by the vertices that the barycentrics belong to
  std::array<double, 3> z{};
  std::array<double, 3> barycentrics{};
  double depth = 0;
  /// NaN where nothing is stated. See BarycentricTolerances().
  std::array<double, 3> barycentric_tolerances{};
  double depth_tolerance = 0;
};

/// Asks for all that a call shows of the case, its vertices at depths of our own choice, and judges
/// some of the covered samples, evenly spread. PrimitiveIds without area by the stated vertices are
/// left out.
Asked AskFragments(const Case& c, const Description& subject,
                   Verdict (*judge)(const std::vector<Fragment>&));

/// How far the barycentrics of p may be off: the stated error for each. If none is stated, the most
/// that the usual forms give in the subject's format: five-operation edge functions over the area,
/// computed by itself or as their sum,
///     q_i = (d_i + |l_i| d) / (|area| - d) + u |l_i|,   d_i = 4 u S_i,
///     d = max(4 u S, d_0 + d_1 + d_2 + 2 u (|E_0| + |E_1| + |E_2|))
/// with S the sum of the absolute products, because computed values e = E_i + d_i and a = area + d
/// give |e / a - E_i / area| = |d_i area - E_i d| / |area a|; and one minus the other two,
///     q_j + q_k + u (1 + max(|l_j|, |l_k|) + |l_i|).
/// It grows with the triangle's conditioning, and states nothing (NaN) where the area itself may
/// vanish.
std::array<double, 3> BarycentricTolerances(const SubjectInfo& info, const BarycentricQuery& q);

/// The same for any point of the pixel whose corner of least x and y is `corner`: S_i, |E_i| and d
/// are convex in p, so that each is greatest at one of the pixel's corners; the bound grows with
/// each.
///
/// Domain:     an area that is not zero.
std::array<double, 3> BarycentricTolerancesInPixel(const SubjectInfo& info,
                                                   const std::array<Point2, 3>& v, Point2 corner);

/// A violation at a fragment.
Verdict FragmentViolation(const Fragment& fragment, int entry, std::uint64_t exercised,
                          const std::string& property, const std::string& observed,
                          const std::string& expected);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_
