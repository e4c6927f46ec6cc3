// The inputs at which methods of values come nearest to their bounds.
#ifndef RASTERPROOF_TESTS_REFERENCE_VALUE_WITNESSES_H_
#define RASTERPROOF_TESTS_REFERENCE_VALUE_WITNESSES_H_

#include <array>
#include <string_view>
#include <vector>

namespace rasterproof::reference::witness {

struct ValueWitness {
  std::string_view method;
  bool is_float32;
  std::array<double, 14> numbers;  ///< x, y and w of three corners, their numbers, the point's x, y
  int steps;

  /// error / bound, of the bound times `scale`.
  double Ratio(double scale = 1) const;
};

const std::vector<ValueWitness>& ValueWitnesses();

}  // namespace rasterproof::reference::witness

#endif  // RASTERPROOF_TESTS_REFERENCE_VALUE_WITNESSES_H_
