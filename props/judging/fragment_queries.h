// The fragments that the claims about weights and depths look at, and how far off each may be.
#ifndef RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/judging/weight_queries.h"
#include "props/property.h"

namespace rasterproof::props {

/// What the subject shows at one covered sample, and what it may be off.
struct Fragment {
  WeightQuery query;  ///< the winner, by the vertices that the weights belong to
  std::array<double, 3> z{};
  std::array<double, 3> weights{};
  double depth = 0;
  /// NaN where nothing is claimed. See WeightTolerances().
  std::array<double, 3> weight_tolerances{};
  double depth_tolerance = 0;
};

/// Asks for all that a call shows of the case, its vertices at depths of our own choice, and judges
/// some of the covered samples, evenly spread. Winners without area by the declared vertices are
/// left out.
Asked AskFragments(const Case& c, const Description& subject,
                   Verdict (*judge)(const std::vector<Fragment>&));

/// How far the weights of p may be off: the declared error for each. If none is declared, the most
/// that the usual forms give in the subject's format: five-operation edge functions over the area,
/// computed by itself or as their sum,
///     q_i = (d_i + |l_i| d) / (|area| - d) + u |l_i|,   d_i = 4 u S_i,
///     d = max(4 u S, d_0 + d_1 + d_2 + 2 u (|E_0| + |E_1| + |E_2|))
/// with S the sum of the absolute products, because computed values e = E_i + d_i and a = area + d
/// give |e / a - E_i / area| = |d_i area - E_i d| / |area a|; and one minus the other two,
///     q_j + q_k + u (1 + max(|l_j|, |l_k|) + |l_i|).
/// It grows with the triangle's conditioning, and claims nothing (NaN) where the area itself may
/// vanish.
std::array<double, 3> WeightTolerances(const SubjectInfo& info, const WeightQuery& q);

/// A violation at a fragment.
Verdict FragmentViolation(const Fragment& fragment, int entry, std::uint64_t exercised,
                          const std::string& claim, const std::string& observed,
                          const std::string& expected);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FRAGMENT_QUERIES_H_
