// Every barycentric at a covered sample is near the exact one of the visible triangle's vertices,
// as stated; where it is open which these are, near those of some legal choice.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace fragment_barycentrics_stay_within_their_error {

constexpr std::string_view kOff = "a barycentric of a fragment is off by more than its error";

// A sum of four products of differences, worked out in double: each is off by less than 4 u of its
// magnitude, the sum by 3 u of all of them, and 16 u is 2^-49.
constexpr double kSumMargin = 0x1p-48;

// The least and the greatest of b (v - p) over v and p in their ranges, for b within its tolerance,
// are added up.
class Offset {
 public:
  void Add(double barycentric, double tolerance, double least, double most) {
    const double far = std::max(std::fabs(least), std::fabs(most));
    const double slack = tolerance * far + kSumMargin * (std::fabs(barycentric) + tolerance) * far;
    low_ += std::min(barycentric * least, barycentric * most) - slack;
    high_ += std::max(barycentric * least, barycentric * most) + slack;
  }
  // Written so that what overflows is no violation.
  bool MayBeZero() const { return !(low_ > 0) && !(high_ < 0); }

 private:
  double low_ = 0;
  double high_ = 0;
};

// The exact barycentrics l of p sum to one and reproduce it, so that sum l_i (v_i - p) = 0 on each
// axis. Shown ones b = l + e of a legal choice, |e_i| within the tolerance, therefore leave a zero
// in what sum (b_i - e_i) (v_i - p) may be. Needs no area: a legal choice may turn the triangle.
bool SomeLegalChoiceExplains(const Fragment& f) {
  const auto [corners, sample] = *f.free_places;
  Offset x;
  Offset y;
  for (std::size_t i = 0; i < 3; ++i) {
    const double b = (*f.barycentrics)[i];
    const double t = f.barycentric_tolerances[i];
    const auto [low, high] = corners[i];
    x.Add(b, t, low.x - sample.high.x, high.x - sample.low.x);
    y.Add(b, t, low.y - sample.high.y, high.y - sample.low.y);
  }
  return x.MayBeZero() && y.MayBeZero();
}

Verdict JudgeAnyChoice(const Fragment& f) {
  if (!std::ranges::all_of(f.barycentric_tolerances, IsStated)) return Verdict::Held(0);
  if (AreFinite(*f.barycentrics) && SomeLegalChoiceExplains(f)) return Verdict::Held(1);
  return FragmentViolation(f, -1, 1, std::string(kOff).append(" for every legal choice"),
                           Listed(*f.barycentrics),
                           {"barycentrics within ", f.barycentric_tolerances[0],
                            " of those of legal places of its vertices"});
}

// By the places that the query has.
Verdict JudgeKnown(const Fragment& f) {
  std::uint64_t exercised = 0;
  double worst = 0;
  const std::array<double, 3>& barycentrics = *f.barycentrics;
  const std::array<exact::Rational, 3> exact_barycentrics = ExactBarycentrics(f.query);
  for (std::size_t i = 0; i < 3; ++i) {
    const double bound = f.barycentric_tolerances[i];
    if (!IsStated(bound)) continue;
    ++exercised;
    const Distance distance = CompareWithExact(barycentrics[i], exact_barycentrics[i], bound);
    if (!distance.within) {
      return FragmentViolation(
          f, static_cast<int>(i), exercised, std::string(kOff), Listed(barycentrics),
          {Exactly(exact_barycentrics[i]), " within ", bound, " for vertex " + std::to_string(i)});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Verdict Judge(const std::vector<Fragment>& fragments) {
  return OneByOne(fragments.size(), [&](std::size_t k) {
    return fragments[k].free_places ? JudgeAnyChoice(fragments[k]) : JudgeKnown(fragments[k]);
  });
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragments(c, subject, kBarycentricsAlone, Judge);
}

}  // namespace fragment_barycentrics_stay_within_their_error

extern constinit const Property kFragmentBarycentricsStayWithinTheirError{
    .name = "FragmentBarycentricsStayWithinTheirError",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1), by the vertices that the subject names.",
    .required_with_error = kBarycentricErrorClauses,
    .tolerance =
        "the stated barycentric error; none stated: the forward bound of the "
        "five-operation quotient, which grows with the triangle's conditioning",
    .domains = kFragments,
    .gate = Where(kAsksFragments, kAreaNotZero),
    .ask = fragment_barycentrics_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
