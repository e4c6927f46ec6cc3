// The fragments that the properties about barycentrics and depths look at, and how far off each may
// be.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_FRAGMENT_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_FRAGMENT_QUERIES_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// Where the legal choices put a fragment's corners and its sample: each in its rectangle.
struct FreePlaces {
  std::array<LegalPlaces, 3> corners;
  LegalPlaces sample;
};

/// The subject's output at one covered sample, and its tolerances.
struct Fragment {
  BarycentricQuery
      query;  ///< the visible triangle, by the vertices that the barycentrics belong to
  /// Whether these are known. If not, the query's are the given ones, and the tolerances hold of
  /// any that are legal.
  bool owners_are_known = true;
  /// Nothing if owners and sample are known: then the query has their places.
  std::optional<FreePlaces> free_places;
  /// True if the draw was asked for barycentrics or for depths, and not for the other.
  bool asked_alone = false;
  std::array<double, 3> z{};
  /// For a depth that was requested alone, the barycentrics of the full draw; nothing if that shows
  /// another triangle, or another choice of owners would explain it.
  std::optional<std::array<double, 3>> barycentrics;
  double depth = 0;  ///< anything if barycentrics were asked for alone
  /// NaN where nothing is stated. See BarycentricTolerances().
  std::array<double, 3> barycentric_tolerances{};
  double depth_tolerance = 0;
};

/// Judges the fragments of one case; each property has its own.
using FragmentJudge = Verdict (*)(const std::vector<Fragment>&);

inline constexpr Outputs kBarycentricsAlone{
    .primitive_ids = true, .barycentrics = true, .depths = false};
inline constexpr Outputs kDepthsAlone{.primitive_ids = true, .barycentrics = false, .depths = true};

/// Asks for all outputs of the case, with its vertices at depths that we choose, then for
/// barycentrics or depths alone, and judges some of the covered samples of both draws, evenly
/// spread. Triangles without area by the stated vertices are left out.
///
/// If the subject does not say which vertices its barycentrics belong to, a fragment holds if it
/// does by the given vertices or by those on the grid.
Checks AskFragments(const PlacedCase& c, const Description& subject, const Outputs& alone,
                    FragmentJudge judge);

/// How far the barycentrics of p may be off: the stated error for each. If none is stated, the most
/// that the usual forms give in the subject's format: five-operation edge functions over the area,
/// computed by itself or as their sum,
///     q_i = (d_i + |l_i| d) / (|area| - d) + u |l_i|,   d_i = 4 u S_i,
///     d = max(4 u S, d_0 + d_1 + d_2 + 2 u (|E_0| + |E_1| + |E_2|))
/// with S the sum of the absolute products, because computed values e = E_i + d_i and a = area + d
/// give |e / a - E_i / area| = |d_i area - E_i d| / |area a|; and one minus the other two,
///     q_j + q_k + u (1 + max(|l_j|, |l_k|) + |l_i|).
/// It grows with the triangle's conditioning, and promises nothing (NaN) where the area itself may
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
                          const std::string& property, WitnessValue observed,
                          WitnessValue expected);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_FRAGMENT_QUERIES_H_
