/* Integers after the snap: no flag changes what they are. */
#include "tests/tool/sweep/draws.h"

static int64_t snapped(float x) {
  if (!(x > -32768.0F && x < 32768.0F)) return INT64_C(1) << 24; /* far outside, whatever it is */
  const float scaled = x * 256.0F; /* exact, as is the difference; a sum with 1/2 would not be */
  const int64_t whole = (int64_t)scaled;
  const float rest = scaled - (float)whole;
  return whole + (rest >= 0.5F) - (rest <= -0.5F);
}

static int64_t edge(const float* a, const float* b, float x, float y) {
  const int64_t ax = snapped(a[0]), ay = snapped(a[1]);
  return (snapped(x) - ax) * (snapped(b[1]) - ay) - (snapped(y) - ay) * (snapped(b[0]) - ax);
}

static int covers(const float v[3][2], float x, float y) {
  const int64_t e0 = edge(v[0], v[1], x, y), e1 = edge(v[1], v[2], x, y),
                e2 = edge(v[2], v[0], x, y);
  return (e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0);
}
