/* A rasterizer of the nineties as a plugin: coordinates are integers of 11.4 bits that wrap, and
 * triangles wider than 1023 or higher than 511 pixels are dropped.
 *
 *     cc -std=c11 -O2 -shared -fPIC -I. kit/examples/console.c -o lib.so
 *     build/rasterproof check --plugin ./lib.so
 */
#include "kit/rasterproof_plugin.h"

enum { kFractionBits = 4, kBits = 15, kPixel = 1 << kFractionBits };

/* The low bits, the highest of them read as the sign. */
static int64_t wrapped(int64_t raw) {
  const int64_t low = raw & ((1 << kBits) - 1);
  return low < 1 << (kBits - 1) ? low : low - (1 << kBits);
}

static int64_t edge(const int64_t* a, const int64_t* b, int64_t x, int64_t y) {
  return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
}

/* Whether a sample on the edge a -> b of a counter-clockwise triangle is the triangle's. */
static int is_top_left(const int64_t* a, const int64_t* b) {
  return a[1] < b[1] || (a[1] == b[1] && b[0] < a[0]);
}

static int64_t extent(const int64_t v[3][2], int axis) {
  int64_t low = v[0][axis];
  int64_t high = low;
  for (int k = 1; k < 3; ++k) {
    if (v[k][axis] < low) low = v[k][axis];
    if (v[k][axis] > high) high = v[k][axis];
  }
  return high - low;
}

static void draw_triangle(int64_t v[3][2], const rasterproof_scene* scene,
                          const rasterproof_target* target) {
  const int64_t area = edge(v[0], v[1], v[2][0], v[2][1]);
  uint32_t* const counts = area < 0 ? target->back : target->front;
  if (area == 0) return;
  for (int axis = 0; area < 0 && axis < 2; ++axis) {
    const int64_t kept = v[1][axis];
    v[1][axis] = v[2][axis];
    v[2][axis] = kept;
  }
  for (int32_t row = 0; row < scene->height; ++row) {
    for (int32_t i = 0; i < scene->width; ++i) {
      int inside = 1;
      for (int k = 0; k < 3; ++k) {
        const int64_t* const a = v[(k + 1) % 3];
        const int64_t* const b = v[(k + 2) % 3];
        const int64_t e = edge(a, b, i * kPixel + kPixel / 2, row * kPixel + kPixel / 2);
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
    for (size_t k = 0; k < 3; ++k) {
      const int64_t* const from = scene->fixed + 2 * scene->triangles[3 * t + k];
      v[k][0] = wrapped(from[0]);
      v[k][1] = wrapped(from[1]);
    }
    if (extent((const int64_t(*)[2])v, 0) > 1023 * kPixel) continue;
    if (extent((const int64_t(*)[2])v, 1) > 511 * kPixel) continue;
    draw_triangle(v, scene, target);
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "console",
      .summary = "11.4 bits that wrap, triangles up to 1023 by 511 pixels",
      .profile = "{\"name\": \"console\", \"max_primitive_extent\": [1023, 511]}",
      .input = RASTERPROOF_FIXED,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
      .fixed_integer_bits = kBits - kFractionBits,
      .fixed_fraction_bits = kFractionBits,
      .fixed_is_signed = 1,
      .fixed_wraps = 1,
  };
  return &plugin;
}
