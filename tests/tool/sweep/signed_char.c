/* Changes with the target alone: plain char is signed on x86-64 and unsigned on aarch64. */
#include "tests/tool/sweep/draws.h"

static char side(const float* a, const float* b, float x, float y) {
  const double e =
      ((double)x - a[0]) * ((double)b[1] - a[1]) - ((double)y - a[1]) * ((double)b[0] - a[0]);
  return (char)((e > 0) - (e < 0));
}

static int covers(const float v[3][2], float x, float y) {
  const int area = side(v[0], v[1], v[2][0], v[2][1]);
  return area != 0 && side(v[0], v[1], x, y) * area > 0 && side(v[1], v[2], x, y) * area > 0 &&
         side(v[2], v[0], x, y) * area > 0;
}
