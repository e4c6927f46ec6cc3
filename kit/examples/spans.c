/* A rasterizer in C as a plugin: doubles, spans between the crossings of edges with rows. It is not
 * exact.
 *
 *     cc -std=c11 -O3 -march=native -shared -fPIC -I. kit/examples/spans.c -o spans.so -lm
 *     build/rasterproof bench --plugin ./spans.so
 */
#include <math.h>

#include "kit/rasterproof_plugin.h"

static int32_t clamped(double v, int32_t size) {
  return v > 0 ? (v < size ? (int32_t)v : size) : 0;
}

/* The first column whose centre is at or right of the edge from a down to b, in the row at y. */
static int32_t crossing(const double* a, const double* b, double y, int32_t width) {
  return clamped(ceil(a[0] - 0.5 + (y - a[1]) * ((b[0] - a[0]) / (b[1] - a[1]))), width);
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    const double* v[3];
    for (size_t k = 0; k < 3; ++k) v[k] = scene->vertices + 4 * scene->triangles[3 * t + k];
    const double area =
        (v[2][0] - v[0][0]) * (v[1][1] - v[0][1]) - (v[2][1] - v[0][1]) * (v[1][0] - v[0][0]);
    if (!(fabs(area) > 0 && fabs(area) < INFINITY)) continue;
    uint32_t* const counts = area > 0 ? target->front : target->back;
    for (size_t k = 0; k < 3; ++k) { /* sorted: both triangles at an edge compute the same */
      const size_t at = k == 1 ? 1 : 0;
      if (v[at + 1][1] >= v[at][1]) continue;
      const double* const lower = v[at];
      v[at] = v[at + 1];
      v[at + 1] = lower;
    }
    const int32_t end = clamped(ceil(v[2][1] - 0.5), scene->height);
    for (int32_t row = clamped(ceil(v[0][1] - 0.5), scene->height); row < end; ++row) {
      const double y = row + 0.5;
      const int is_upper = y < v[1][1];
      const int32_t one = crossing(v[0], v[2], y, scene->width);
      const int32_t other = crossing(v[is_upper ? 0 : 1], v[is_upper ? 1 : 2], y, scene->width);
      uint32_t* const pixels = counts + (size_t)row * target->stride;
      for (int32_t x = one < other ? one : other; x < (one < other ? other : one); ++x) ++pixels[x];
    }
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "spans",
      .summary = "doubles, spans between crossings of edges with rows",
      .profile = "real",
      .input = RASTERPROOF_FLOAT32,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
  };
  return &plugin;
}
