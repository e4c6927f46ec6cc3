#include "props/judging/values/interpolation_queries.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "exact/attributes.h"
#include "props/judging/values/estimate.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

constexpr std::array<std::array<double, 3>, 3> kDepths{{{1, 1, 1}, {1, 4, 0.5}, {0.25, 1, 16}}};

}  // namespace

std::vector<InterpolationQuery> SomeInterpolations(const PlacedCase& c) {
  std::vector<InterpolationQuery> queries;
  for (const BarycentricQuery& q : SomeBarycentricQueries(c)) {
    std::size_t turn = 0;  // the two sets of unequal w take turns
    for (const std::array<double, 3>& attribute : SomeAttributes(c, q)) {
      for (const std::size_t set : {std::size_t{0}, 1 + turn++ % 2}) {
        const std::array<double, 3>& w = kDepths[set];
        queries.push_back(
            {q, {Corner{q.v[0], w[0]}, Corner{q.v[1], w[1]}, Corner{q.v[2], w[2]}}, attribute});
      }
    }
  }
  return queries;
}

std::string_view InterpolationName(InterpolationForm form) {
  switch (form) {
    case InterpolationForm::kBarycentrics:
      return "by barycentrics";
    case InterpolationForm::kDeltas:
      return "by deltas";
    case InterpolationForm::kPerspective:
      return "perspective-correct";
  }
  return "";
}

std::optional<exact::Rational> ExactInterpolation(InterpolationForm form,
                                                  const InterpolationQuery& q) {
  if (form != InterpolationForm::kPerspective) {
    return exact::Interpolate(q.at.v, q.attribute, q.at.place.at);
  }
  return exact::InterpolatePerspective(q.at.v, {q.corners[0].w, q.corners[1].w, q.corners[2].w},
                                       q.attribute, q.at.place.at);
}

Estimate EstimatedInterpolation(InterpolationForm form, const InterpolationQuery& q) {
  const std::array<Estimate, 3> lambda = EstimatedBarycentrics(q.at.v, q.at.place.at);
  Estimate numerator;
  Estimate denominator;
  for (std::size_t k = 0; k < 3; ++k) {
    const Estimate share =
        form == InterpolationForm::kPerspective ? lambda[k] / Estimate(q.corners[k].w) : lambda[k];
    numerator = numerator + share * Estimate(q.attribute[k]);
    denominator = denominator + share;
  }
  return form == InterpolationForm::kPerspective ? numerator / denominator : numerator;
}

Checks AskInterpolations(const std::vector<InterpolationQuery>& queries,
                         const std::vector<InterpolationForm>& forms,
                         const BarycentricBounds& bounds,
                         Verdict (*judge)(const std::vector<InterpolationAnswer>&)) {
  std::vector<InterpolationAnswer> unanswered;
  Questions questions;
  for (const InterpolationQuery& q : queries) {
    const Point2 p = q.at.place.at;
    for (const InterpolationForm form : forms) {
      const double bound = bounds.InterpolationErrorBound(form, q.corners, q.attribute, p);
      if (!IsStated(bound)) continue;
      unanswered.push_back({q, form, bound});
      questions.interpolations.push_back({form, q.corners, q.attribute, p});
    }
  }
  return OneCheck(std::move(questions),
                  [judge, unanswered = std::move(unanswered)](const Answers& answers) {
                    std::vector<InterpolationAnswer> answered = unanswered;
                    for (std::size_t k = 0; k < answered.size(); ++k) {
                      answered[k].value = answers.interpolations[k];
                    }
                    return judge(answered);
                  });
}

Verdict InterpolationsStayWithinTheirBound(const std::vector<InterpolationAnswer>& answers) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const auto& [q, form, bound, value] : answers) {
    if (const auto near = CompareWithEstimate(value, EstimatedInterpolation(form, q), bound)) {
      ++exercised;
      worst = std::max(worst, near->ratio);
      continue;
    }
    const std::optional<exact::Rational> exact = ExactInterpolation(form, q);
    if (!exact) continue;
    ++exercised;
    const Distance distance = CompareWithExact(value, *exact, bound);
    if (!distance.within) {
      return BarycentricViolation(q.at, -1, exercised,
                                  "value interpolated " + std::string(InterpolationName(form)) +
                                      " outside its proven bound",
                                  {value}, {Exactly(*exact), " within ", bound});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
