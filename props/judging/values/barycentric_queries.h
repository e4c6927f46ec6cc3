// The triangles and samples that the barycentric and wireframe properties ask about.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_BARYCENTRIC_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_BARYCENTRIC_QUERIES_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluators.h"
#include "core/verdict.h"
#include "exact/rational.h"
#include "props/judging/places.h"
#include "props/judging/values/exact_comparison.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// One triangle of non-zero area and one sample.
struct BarycentricQuery {
  int triangle = 0;
  std::array<Point2, 3> v;
  SamplePlace place;
  bool inside = false;  ///< in the closed triangle, decided exactly
};

/// Whether p lies in the triangle or on its outline, decided exactly.
///
/// Domain:     an area that is not zero.
bool InClosedTriangle(const std::array<Point2, 3>& v, Point2 p);

/// A few triangles of non-zero area, at samples inside, near the edges and outside.
std::vector<BarycentricQuery> SomeBarycentricQueries(const PlacedCase& c);

/// The corners themselves: at most a few triangles of non-zero area.
std::vector<CornersPlace> SomeProperTriangles(const PlacedCase& c);

/// The forms whose barycentrics mean lambda at this query (the unsigned one only inside).
std::vector<BarycentricForm> FormsFor(const BarycentricQuery& q);
std::string_view FormName(BarycentricForm form);

/// The three barycentrics in one form, and the bounds that the subject states on their errors.
struct FormAnswer {
  BarycentricForm form = BarycentricForm::kVertexArea;
  std::array<double, 3> barycentrics{};
  std::array<double, 3> bounds{};
};

/// The subject's answers at a query, in every form that suits it.
struct BarycentricAnswer {
  BarycentricQuery query;
  std::vector<FormAnswer> forms;
};

/// Asks for the barycentrics at the queries and judges them all at once.
Checks AskBarycentrics(const std::vector<BarycentricQuery>& queries,
                       const BarycentricBounds& bounds,
                       Verdict (*judge)(const std::vector<BarycentricAnswer>&));

/// The three barycentrics, for a witness.
WitnessValue Listed(const std::array<double, 3>& barycentrics);

bool AreFinite(const std::array<double, 3>& barycentrics);
/// How far finite barycentrics, added exactly, are from a sum of one.
Distance DistanceFromSumOne(const std::array<double, 3>& barycentrics, double bound);

/// The exact lambda of the query.
std::array<exact::Rational, 3> ExactBarycentrics(const BarycentricQuery& q);

/// Attribute values to interpolate: the scene's z where finite and of moderate size, and two fixed
/// sets, one constant. All are float32 values.
std::vector<std::array<double, 3>> SomeAttributes(const PlacedCase& c, const BarycentricQuery& q);

/// A violation at a query; `entry` is the vertex (and so the edge opposite it) in question, or -1.
Verdict BarycentricViolation(const BarycentricQuery& q, int entry, std::uint64_t exercised,
                             const std::string& property, WitnessValue observed,
                             WitnessValue expected);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_BARYCENTRIC_QUERIES_H_
