// The symbolic tier: the sign of an affine function that is zero at a sample, at the shifted
// sample.
#ifndef RASTERPROOF_EXACT_TIE_H_
#define RASTERPROOF_EXACT_TIE_H_

#include "core/tie_rule.h"

namespace rasterproof::exact {

/// Returns the sign at the infinitesimally shifted sample of a function with f = 0 at the sample.
///
/// dx_sign and dy_sign are the signs of df/dx and df/dy. The first axis of the shift decides unless
/// f does not change along it.
/// Returns:    0 if f is constant, or if the rule does not shift (inclusive, exclusive).
inline int TieSign(int dx_sign, int dy_sign, const TieRule& rule) {
  if (!rule.IsConsistent()) return 0;
  const int along_x = rule.sign_x * dx_sign;
  const int along_y = rule.sign_y * dy_sign;
  const int first = rule.y_first ? along_y : along_x;
  return first != 0 ? first : (rule.y_first ? along_x : along_y);
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_TIE_H_
