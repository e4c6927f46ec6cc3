// The inputs at which bounds are nearest to being broken, and what the code makes of each.
#ifndef RASTERPROOF_TESTS_REFERENCE_BOUND_WITNESSES_H_
#define RASTERPROOF_TESTS_REFERENCE_BOUND_WITNESSES_H_

#include <string_view>
#include <vector>

#include "exact/rational.h"

namespace rasterproof::reference::witness {

/// How far a result is off, and the bound that the header's constants give.
struct ErrorAndBound {
  exact::Rational error;
  exact::Rational bound;
};

struct BoundWitness {
  std::string_view bound;     ///< as the table names it
  std::string_view constant;  ///< that the headers give it
  bool is_float32;
  std::string_view names;  ///< of the numbers, in order
  std::vector<double> numbers;
  ErrorAndBound (*evaluate)(const std::vector<double>& numbers);

  /// error / bound, rounded to nearest.
  double Ratio() const;
  /// Lowering the bound by 1 % is refuted by the witness.
  bool IsTight() const;
};

/// Of the guesses of where a row crosses an edge: a part of BoundWitnesses.
const std::vector<BoundWitness>& CrossingWitnesses();

const std::vector<BoundWitness>& BoundWitnesses();

}  // namespace rasterproof::reference::witness

#endif  // RASTERPROOF_TESTS_REFERENCE_BOUND_WITNESSES_H_
