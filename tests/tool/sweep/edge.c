/* The edge function of contracted.c, beside one that has nothing to contract. */
int turns(const float* a, const float* b) { return a[1] < b[1]; }

static float cross(float ax, float ay, float bx, float by) { return ax * by - ay * bx; }

float edge(const float* a, const float* b, float x, float y) {
  const float e = turns(a, b) ? cross(x - a[0], y - a[1], b[0] - a[0], b[1] - a[1])
                              : -cross(x - b[0], y - b[1], a[0] - b[0], a[1] - b[1]);
  return e;
}
