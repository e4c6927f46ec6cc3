// The values that the interpolation properties ask a barycentric evaluator for.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_INTERPOLATION_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_INTERPOLATION_QUERIES_H_

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/verdict.h"
#include "exact/rational.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/estimate.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// Something to interpolate at a query.
struct InterpolationQuery {
  BarycentricQuery at;
  std::array<Corner, 3> corners;
  std::array<double, 3> attribute;
};

/// The attribute sets of SomeAttributes under w = 1, and each under one of two sets of positive w:
/// powers of two, so that a subject that divides by them does not round the input.
std::vector<InterpolationQuery> SomeInterpolations(const PlacedCase& c);

std::string_view InterpolationName(InterpolationForm form);

/// The exact value under a form; nothing where the perspective denominator vanishes.
std::optional<exact::Rational> ExactInterpolation(InterpolationForm form,
                                                  const InterpolationQuery& q);

/// The same as an estimate, whose error is infinite where the denominator could vanish.
Estimate EstimatedInterpolation(InterpolationForm form, const InterpolationQuery& q);

/// A value that the subject interpolates, and the bound that it states on its error.
struct InterpolationAnswer {
  InterpolationQuery query;
  InterpolationForm form = InterpolationForm::kBarycentrics;
  double bound = 0;
  double value = 0;
};

/// Asks for the values at the queries, in those of the forms where the subject's bound promises
/// anything, and judges them all at once.
Checks AskInterpolations(const std::vector<InterpolationQuery>& queries,
                         const std::vector<InterpolationForm>& forms,
                         const BarycentricBounds& bounds,
                         Verdict (*judge)(const std::vector<InterpolationAnswer>&));

/// Holds if every value is within its bound of the exact one.
Verdict InterpolationsStayWithinTheirBound(const std::vector<InterpolationAnswer>& answers);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_INTERPOLATION_QUERIES_H_
