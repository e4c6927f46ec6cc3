// The forms of barycentrics of few inputs, for any number type: a float's, a running error's, or a
// float's of so few bits that all of its values can be tried.
#ifndef RASTERPROOF_REFERENCE_BARYCENTRIC_FORMS_H_
#define RASTERPROOF_REFERENCE_BARYCENTRIC_FORMS_H_

#include <array>

namespace rasterproof::reference {

/// Edge values over their sum: no area is needed.
template <class N>
std::array<N, 3> OverTheirSum(const std::array<N, 3>& e) {
  const N sum = (e[0] + e[1]) + e[2];
  return {e[0] / sum, e[1] / sum, e[2] / sum};
}

/// What the first two leave of one.
template <class N>
N LastOfOne(const N& one, const N& l0, const N& l1) {
  return (one - l0) - l1;
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_BARYCENTRIC_FORMS_H_
