// The floating-point environment that the oracle needs, and a test for it.
#ifndef RASTERPROOF_EXACT_ENVIRONMENT_H_
#define RASTERPROOF_EXACT_ENVIRONMENT_H_

#include <string>

namespace rasterproof::exact {

struct Environment {
  bool round_to_nearest = false;
  bool subnormals_kept = false;      ///< neither FTZ nor DAZ
  bool contraction_off = false;      ///< a * b + c is not fused by the compiler
  bool float_rounding_kept = false;  ///< double -> float -> double is not optimised away
  bool under_valgrind = false;
  std::string compiler;  ///< name and version
  std::string flags;     ///< optimisation and floating-point flags of this build

  bool Honest() const {
    return round_to_nearest && subnormals_kept && contraction_off && float_rounding_kept &&
           !under_valgrind;
  }
  /// The fault and its remedy; empty if Honest().
  std::string Complaint() const;
};

/// Tests the environment of the calling thread.
Environment InspectEnvironment();

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_ENVIRONMENT_H_
