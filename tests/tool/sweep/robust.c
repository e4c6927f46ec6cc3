/* Integers after the snap: no flag changes what they are, and they are the model's. */
#define PROFILE "{\"name\": \"swept\", \"subpixel_bits\": 8, \"coordinate_limit\": 32768}"
#include "tests/tool/sweep/draws.h"

static int64_t snapped(float x) {
  if (!(x >= -32768.0F && x <= 32768.0F)) return INT64_C(1) << 24; /* beyond the limit */
  const float scaled = x * 256.0F; /* exact, as is the difference; a sum with 1/2 would not be */
  const int64_t whole = (int64_t)scaled;
  const float rest = scaled - (float)whole;
  const int is_odd = whole % 2 != 0;
  return whole + (rest > 0.5F || (rest == 0.5F && is_odd)) -
         (rest < -0.5F || (rest == -0.5F && is_odd));
}

static int64_t edge(const float* a, const float* b, float x, float y) {
  const int64_t ax = snapped(a[0]), ay = snapped(a[1]);
  return (snapped(x) - ax) * (snapped(b[1]) - ay) - (snapped(y) - ay) * (snapped(b[0]) - ax);
}

/* Inside the edge a -> b of a triangle of this area, or on it as a top or left edge. */
static int is_inside(const float* a, const float* b, float x, float y, int64_t area) {
  const int64_t e = area > 0 ? edge(a, b, x, y) : edge(b, a, x, y);
  const int64_t dx = area > 0 ? snapped(b[0]) - snapped(a[0]) : snapped(a[0]) - snapped(b[0]);
  const int64_t dy = area > 0 ? snapped(b[1]) - snapped(a[1]) : snapped(a[1]) - snapped(b[1]);
  return e > 0 || (e == 0 && (dy > 0 || (dy == 0 && dx < 0)));
}

static int covers(const float v[3][2], float x, float y) {
  const int64_t area = edge(v[0], v[1], v[2][0], v[2][1]);
  return area != 0 && is_inside(v[0], v[1], x, y, area) && is_inside(v[1], v[2], x, y, area) &&
         is_inside(v[2], v[0], x, y, area);
}
