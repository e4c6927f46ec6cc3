/* Changes where a product and a difference become one instruction, in edge.c alone. */
#include "tests/tool/sweep/draws.h"

float edge(const float* a, const float* b, float x, float y);

static int covers(const float v[3][2], float x, float y) {
  const float e0 = edge(v[0], v[1], x, y), e1 = edge(v[1], v[2], x, y), e2 = edge(v[2], v[0], x, y);
  return (e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0);
}
