/* Changes where sums are regrouped, or kept in registers wider than float. */
#include "tests/tool/sweep/draws.h"

static float sum(const float* terms) {
  float s = 0;
  for (int k = 0; k < 8; ++k) s += terms[k];
  return s;
}

static float edge(const float* a, const float* b, float x, float y) {
  const float terms[8] = {x * b[1],  -x * a[1], -a[0] * b[1], a[0] * a[1],
                          -y * b[0], y * a[0],  a[1] * b[0],  -a[1] * a[0]};
  return sum(terms);
}

static int covers(const float v[3][2], float x, float y) {
  const float e0 = edge(v[0], v[1], x, y), e1 = edge(v[1], v[2], x, y), e2 = edge(v[2], v[0], x, y);
  return (e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0);
}
