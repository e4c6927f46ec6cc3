// The three barycentrics, added exactly, sum to one within the bound stated for the form.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentrics_sum_to_one {

// A query in a form that the subject states a bound on the sum of.
struct BoundedSum {
  BarycentricQuery query;
  BarycentricForm form = BarycentricForm::kVertexArea;
  double bound = 0;
};

Verdict Judge(const std::vector<BoundedSum>& sums, const Answers& answers) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const auto& [q, form, bound] = sums[k];
    const std::array<double, 3>& l = answers.barycentrics[k];
    ++exercised;
    const auto violated = [&](WitnessValue expected) {
      return BarycentricViolation(
          q, -1, exercised, "barycentrics (" + std::string(FormName(form)) + ") do not sum to one",
          Listed(l), std::move(expected));
    };
    if (!AreFinite(l)) return violated({"finite barycentrics"});
    const Distance distance = DistanceFromSumOne(l, bound);
    if (!distance.within) return violated({"a sum of 1 within ", bound});
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<BoundedSum> sums;
  Questions questions;
  for (const BarycentricQuery& q : SomeBarycentricQueries(c)) {
    for (const BarycentricForm form : FormsFor(q)) {
      const double bound = subject.barycentrics->SumErrorBound(form, q.v, q.place.at);
      if (!IsStated(bound)) continue;
      sums.push_back({q, form, bound});
      questions.barycentrics.push_back({form, q.v, q.place.at});
    }
  }
  return OneCheck(std::move(questions), [sums = std::move(sums)](const Answers& answers) {
    return Judge(sums, answers);
  });
}

}  // namespace barycentrics_sum_to_one

extern constinit const Property kBarycentricsSumToOne{
    .name = "BarycentricsSumToOne",
    .group = "barycentric",
    .clause =
        "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .tolerance = "the subject's proven SumErrorBound",
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask = barycentrics_sum_to_one::Ask,
};

}  // namespace rasterproof::props
