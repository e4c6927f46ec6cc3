#include "reference/proved.h"

#include <utility>
#include <vector>

#include "core/subject_info.h"
#include "reference/bounds.h"

namespace rasterproof::reference {
namespace {

Proof DirectProof() {
  return {
      "where no product over- or underflows the direct form is off by at most "
      "(3 + 8u) u S + u |E|",
      "edge_direct.g"};
}

// Of a walk: where it starts, and what a step adds.
std::vector<Proof> DirectAnd(Proof step) { return {DirectProof(), std::move(step)}; }

Proof OneStep() {
  return {"one step is off by at most half an ulp of its sum's binade", "increment.g"};
}

}  // namespace

std::vector<Proof> EdgeProofs(EdgeArithmetic arithmetic) {
  switch (arithmetic) {
    case EdgeArithmetic::kDirect:
    case EdgeArithmetic::kCompensated:  // of its sums nothing is proved by a script
      return {DirectProof()};
    case EdgeArithmetic::kDirectFma:
      return {
          {"where no product over- or underflows the direct form with one fused product is off "
           "by at most (3 + 8u) u S + u |E|",
           "edge_direct.g"}};
    case EdgeArithmetic::kKahan:
      return {
          {"where no product over- or underflows Kahan's form is off by at most "
           "(2 + 7u) u S + (2 + u) u |E|",
           "edge_kahan.g"}};
    case EdgeArithmetic::kAffine:
      return {
          {"where no product over- or underflows the affine form is off by at most "
           "(4 + 7u) u (|dY x| + |dX y|) + (3 + 4u) u (|b.x a.y| + |a.x b.y|)",
           "edge_affine.g"}};
    case EdgeArithmetic::kAffineFma:
      return {
          {"where no product over- or underflows the fused affine form is off by at most "
           "(3 + 4u) u (|dY x| + |dX y|) + (4 + 7u) u (|b.x a.y| + |a.x b.y|)",
           "edge_affine.g"}};
    case EdgeArithmetic::kIncremental:
    case EdgeArithmetic::kIncrementalRow:
    case EdgeArithmetic::kIncremental16:
      return DirectAnd(OneStep());
    case EdgeArithmetic::kIndex:
      return DirectAnd(
          {"a whole number of steps times the step is off by a relative u, however "
           "many steps",
           "index.g"});
    case EdgeArithmetic::kIndexFma:
      return DirectAnd(
          {"a whole number of steps fused with the start is one rounding, however "
           "many steps",
           "index.g"});
  }
  return {};
}

std::vector<Proof> IntegerProofs() {
  return {{"inside the coordinate limit the products of the direct form fit the integers",
           "exactness.g"}};
}

std::vector<Proof> FilterProofs() {
  return {{"a sign that the filter in double is sure of is the exact one, underflow apart",
           "edge_filter.g"}};
}

std::vector<Proof> CrossingProofs() {
  return {
      {"a crossing guessed in double is off by less than the error beyond which it decides",
       "row_crossing.g"},
      {"a crossing guessed in float32 is off by less than the error beyond which it decides",
       "kernel_crossing.g"},
      {"a crossing stepped in fixed point is off by less than the error beyond which it decides",
       "kernel_steps.g"}};
}

std::vector<Proof> HomogeneousProofs() {
  return {
      {"where no product over- or underflows (V_j x V_i) . p is off by at most (5 + 11u) u "
       "times the sum of its terms' magnitudes",
       "homogeneous.g"}};
}

std::vector<Proof> ClipKernelProofs() {
  return {
      {"crossings of rows and edges of (x, y, w), their values and D = V0 . (V2 x V1) are off by "
       "less than the errors beyond which they decide",
       "clip_kernel.g"},
      {"corners projected in float32, and crossings guessed from them, are off by less than that",
       "clip_floats.g"}};
}

std::vector<Proof> BarycentricProofs() {
  return {{"barycentrics over the sum of edge values of one sign add up to 1 within (3 + 8u) u, "
           "underflow apart",
           "barycentrics_sum.g"},
          {"inside the triangle (1 - l0) - l1 is off by at most u", "barycentrics_one_minus.g"},
          {"a barycentric times its height carries at most three roundings, (3 + 4u) u",
           "barycentrics_distance.g"}};
}

}  // namespace rasterproof::reference
