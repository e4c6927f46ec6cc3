/* A rasterizer in C as a plugin: 8 subpixel bits, nearest-even, top-left, 64-bit integers.
 *
 *     cc -std=c11 -O2 -ffp-contract=off -shared -fPIC -I. kit/examples/plugin.c -o lib.so -lm
 *     build/rasterproof check --plugin ./lib.so
 */
#include <math.h>

#include "kit/rasterproof_plugin.h"

static const double kUnits = 256; /* a pixel */

static int64_t edge(const int64_t* a, const int64_t* b, int64_t x, int64_t y) {
  return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
}

/* Whether a sample on the edge a -> b of a counter-clockwise triangle is the triangle's. */
static int is_top_left(const int64_t* a, const int64_t* b) {
  return a[1] < b[1] || (a[1] == b[1] && b[0] < a[0]);
}

/* The pixel of a place in one direction, no further than one past the target's end. */
static int32_t pixel_of(int64_t place, int32_t size) {
  if (place < 0) return 0;
  return place / 256 < size ? (int32_t)(place / 256) : size;
}

/* Pixels [first, end) that the triangle may cover in one direction. */
static void box_of(const int64_t v[3][2], int axis, int32_t size, int32_t* first, int32_t* end) {
  int64_t least = v[0][axis];
  int64_t most = v[0][axis];
  for (int k = 1; k < 3; ++k) {
    if (v[k][axis] < least) least = v[k][axis];
    if (v[k][axis] > most) most = v[k][axis];
  }
  *first = pixel_of(least, size);
  *end = pixel_of(most + 256, size);
}

static void draw_triangle(const int64_t v[3][2], int is_back, const rasterproof_scene* scene,
                          const rasterproof_target* target) {
  uint32_t* const counts = is_back ? target->back : target->front;
  int32_t x0, x1, y0, y1;
  box_of(v, 0, scene->width, &x0, &x1);
  box_of(v, 1, scene->height, &y0, &y1);
  for (int32_t row = y0; row < y1; ++row) {
    for (int32_t i = x0; i < x1; ++i) {
      int inside = 1;
      for (int k = 0; k < 3; ++k) {
        const int64_t* const a = v[(k + 1) % 3];
        const int64_t* const b = v[(k + 2) % 3];
        const int64_t e = edge(a, b, i * INT64_C(256) + 128, row * INT64_C(256) + 128);
        inside &= e > 0 || (e == 0 && is_top_left(a, b));
      }
      counts[(size_t)row * target->stride + (size_t)i] += (uint32_t)inside;
    }
  }
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    int64_t v[3][2];
    int is_finite = 1;
    for (int k = 0; k < 3; ++k) {
      const double* const from = scene->vertices + 4 * scene->triangles[3 * t + (size_t)k];
      for (int axis = 0; axis < 2; ++axis) {
        is_finite &= fabs(from[axis]) <= 32768;
        v[k][axis] = is_finite ? (int64_t)nearbyint(from[axis] * kUnits) : 0;
      }
    }
    const int64_t area = edge(v[0], v[1], v[2][0], v[2][1]);
    if (!is_finite || area == 0) continue;
    if (area < 0) {
      for (int axis = 0; axis < 2; ++axis) {
        const int64_t kept = v[1][axis];
        v[1][axis] = v[2][axis];
        v[2][axis] = kept;
      }
    }
    draw_triangle((const int64_t(*)[2])v, area < 0, scene, target);
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "example",
      .summary = "8 subpixel bits in 64-bit integers",
      .profile = "gl-canonical",
      .input = RASTERPROOF_FLOAT32,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
  };
  return &plugin;
}
