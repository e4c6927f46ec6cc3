// What was proved about each subject's arithmetic. Every entry names the script that the tests run.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tool/certify.h"

namespace rasterproof::tool {
namespace {

struct Proof {
  std::string_view subjects;  ///< what the subjects' names begin with; empty: all
  std::string_view claim;
  std::string_view script;  ///< in reference/proofs/, run by the test proofs
};

constexpr std::array kProofs{
    Proof{"f", "the direct form is off by at most 3u S + u |E|, fused or not", "edge_direct.g"},
    Proof{"f32-kahan", "Kahan's form is off by at most 2u S + 2u |E|", "edge_kahan.g"},
    Proof{"f64-kahan", "Kahan's form is off by at most 2u S + 2u |E|", "edge_kahan.g"},
    Proof{"f32-affine",
          "the affine form is off by at most u (4 |A x| + 4 |B y| + 3 |C's products|)",
          "edge_affine.g"},
    Proof{"f32-incremental", "one step of a walk is off by half an ulp of its binade",
          "increment.g"},
    Proof{"f64-incremental", "one step of a walk is off by half an ulp of its binade",
          "increment.g"},
    Proof{"f32-index", "the fused index form adds one rounding, however many steps", "index.g"},
    Proof{"i", "inside its coordinate limit every integer of the kernel fits", "exactness.g"},
    Proof{"hom-f", "(V_j x V_i) . p is off by at most 5u of its terms' magnitudes",
          "homogeneous.g"},
    Proof{"f", "weights over the sum of the edge values add up to 1 within 3u inside",
          "weights_sum.g"},
    Proof{"f", "(1 - l0) - l1 is right within u inside", "weights_one_minus.g"},
    Proof{"f", "a weight times its height carries three roundings", "weights_distance.g"},
};

}  // namespace

std::vector<report::Evidence> ProvedOf(const std::string& subject) {
  std::vector<report::Evidence> proved;
  for (const Proof& proof : kProofs) {
    if (subject.starts_with(proof.subjects)) {
      proved.push_back(
          {std::string(proof.claim), "gappa reference/proofs/" + std::string(proof.script)});
    }
  }
  return proved;
}

}  // namespace rasterproof::tool
