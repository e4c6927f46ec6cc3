// What scripts of proofs/ prove of the table's arithmetic, as data of the methods that use it.
#ifndef RASTERPROOF_REFERENCE_PROVED_H_
#define RASTERPROOF_REFERENCE_PROVED_H_

#include <vector>

#include "core/subject_info.h"
#include "reference/bounds.h"

namespace rasterproof::reference {

/// What is proved of edge values in the arithmetic. u is the precision's unit roundoff, S the sum
/// of the magnitudes of the two exact products.
std::vector<Proof> EdgeProofs(EdgeArithmetic arithmetic);

/// Of integer edge values inside the method's coordinate limit.
std::vector<Proof> IntegerProofs();

/// Of the filter that leaves to exact arithmetic the signs that it is not sure of.
std::vector<Proof> FilterProofs();

/// Of the crossings of edges and rows that spans-exact guesses: samples farther from them than the
/// errors are on the side that the guess says; the others are decided exactly.
std::vector<Proof> CrossingProofs();

/// Of edges of (x, y, w) vertices, by V_j x V_i.
std::vector<Proof> HomogeneousProofs();

/// Of the kernel of clip space: what it guesses, and the filters of its exact decisions.
std::vector<Proof> ClipKernelProofs();

/// Of ReferenceBarycentrics, in either precision.
std::vector<Proof> BarycentricProofs();

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_PROVED_H_
