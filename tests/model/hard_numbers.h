// Coordinates that placing goes wrong at.
#ifndef RASTERPROOF_TESTS_MODEL_HARD_NUMBERS_H_
#define RASTERPROOF_TESTS_MODEL_HARD_NUMBERS_H_

#include <cmath>
#include <limits>
#include <vector>

namespace rasterproof::second {

/// x and the doubles and floats on either side of it.
inline std::vector<double> AndNeighbours(double x) {
  std::vector<double> all{x, std::nextafter(x, -HUGE_VAL), std::nextafter(x, HUGE_VAL)};
  if (std::fabs(x) < 0x1p127) {
    const auto f = static_cast<float>(x);
    for (const float g : {f, std::nextafter(f, -HUGE_VALF), std::nextafter(f, HUGE_VALF)}) {
      all.push_back(double{g});
    }
  }
  return all;
}

/// Both zeros, subnormals, powers of two from the least to the largest, and what lies beside them.
inline std::vector<double> EndsOfTheRange() {
  std::vector<double> all{0.0, -0.0, std::numeric_limits<double>::denorm_min(),
                          std::numeric_limits<double>::max()};
  for (const int exponent :
       {-1074, -1022, -1000, -149, -126, -60, -54, -53, -30, -26, -25, -24, -1,  0,   15,
        23,    24,    31,    35,   36,   40,  44,  51,  52,  53,  63,  126, 127, 1023}) {
    const double power = std::ldexp(1.0, exponent);
    for (const double x : {power, 1.5 * power}) {
      const std::vector<double> beside = AndNeighbours(x);
      all.insert(all.end(), beside.begin(), beside.end());
    }
  }
  std::vector<double> both;
  for (const double x : all) {
    if (!std::isfinite(x)) continue;
    both.push_back(x);
    both.push_back(-x);
  }
  return both;
}

}  // namespace rasterproof::second

#endif  // RASTERPROOF_TESTS_MODEL_HARD_NUMBERS_H_
