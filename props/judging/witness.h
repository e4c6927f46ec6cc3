// Writing down where a property failed.
#ifndef RASTERPROOF_PROPS_JUDGING_WITNESS_H_
#define RASTERPROOF_PROPS_JUDGING_WITNESS_H_

#include <array>
#include <cstddef>
#include <string>

#include "core/coverage.h"
#include "core/verdict.h"
#include "core/witness.h"
#include "exact/rational.h"
#include "props/judging/places.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

using rasterproof::HexText;
std::string HexText(Point2 p);

RationalText Exactly(const exact::Rational& number);
/// The exact value of E(a, b; p).
RationalText ExactEdge(Point2 a, Point2 b, Point2 p);

/// Where an edge or barycentric property failed.
Witness WitnessAt(int triangle, int edge, const SamplePlace& place, WitnessValue observed,
                  WitnessValue expected);

/// The sample with that index in counts of the shape.
Witness WitnessAtIndex(const CoverageCounts& shape, std::size_t index);

/// Where two counts differ at one sample: by facing, observed and expected.
Witness WitnessOfCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                        std::size_t index);

/// Finds the triangle that the subject, drawing it alone under `options`, gets wrong at the
/// witness's sample: a second round (Property::blame). Adds to the witness that triangle, its edge
/// nearest to the sample and, in window space, the exact edge values there.
///
/// If the profile leaves open where a vertex lies, no triangle alone can be wrong: nothing is
/// drawn, and the triangle whose edge is nearest to the sample is named.
///
/// Domain:     a verdict with a witness of one of the case's samples; a case that outlives the
///             returned check.
Checks BlameTriangles(const PlacedCase& c, const Verdict& verdict, const DrawOptions& options);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_WITNESS_H_
