/* A culling filter as a plugin: a triangle that it drops must cover no sample.
 *
 *     static int keep(const double v[6], int width, int height) { ... }
 *     RASTERPROOF_FILTER("mine", keep)
 *
 * The plugin draws exactly, with 8 subpixel bits, nearest-even, top-left, but only the triangles
 * that `keep` says to keep. So its coverage is the model's if and only if no dropped triangle
 * covers a sample:
 *
 *     rasterproof check --plugin ./lib.so --property CoverageEqualsTheModel
 *
 * A filter that keeps too many is slow and right, and holds.
 *
 * keep:       v holds x0, y0, x1, y1, x2, y2 in pixels, y down, as the scene has them: not snapped,
 *             of either facing, finite, of magnitude 32768 at most. Samples are the centres of the
 *             pixels of a target of width x height. Returns 0: the triangle need not be drawn.
 *
 * Include it in one file, in C99 or C++11, and link with -lm.
 */
#ifndef RASTERPROOF_KIT_FILTER_PLUGIN_H_
#define RASTERPROOF_KIT_FILTER_PLUGIN_H_

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "kit/rasterproof_plugin.h"

typedef int (*rasterproof_keep)(const double v[6], int width, int height);

/* The place of a coordinate on the grid, in units of 1/256 pixel. */
static inline int64_t rasterproof_filter_snap(double x) { return (int64_t)nearbyint(x * 256); }

static inline int64_t rasterproof_filter_edge(const int64_t* a, const int64_t* b, int64_t x,
                                              int64_t y) {
  return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
}

/* Whether the triangle, whose sign of area is `turn`, covers the sample. */
static inline int rasterproof_filter_covers(const int64_t* v, int64_t turn, int64_t x, int64_t y) {
  for (int k = 0; k < 3; ++k) {
    const int64_t* const a = v + 2 * (turn > 0 ? k : (k + 1) % 3);
    const int64_t* const b = v + 2 * (turn > 0 ? (k + 1) % 3 : k);
    const int64_t e = rasterproof_filter_edge(a, b, x, y);
    const int owns_edge = a[1] < b[1] || (a[1] == b[1] && b[0] < a[0]);
    if (e < 0 || (e == 0 && !owns_edge)) return 0;
  }
  return 1;
}

/* Draws the triangles that are kept. Returns 0. */
static inline int32_t rasterproof_filter_draw(rasterproof_keep keep, const rasterproof_scene* scene,
                                              const rasterproof_target* target) {
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    double given[6];
    int64_t v[6];
    int is_finite = 1;
    for (size_t k = 0; k < 6; ++k) {
      given[k] = scene->vertices[4 * scene->triangles[3 * t + k / 2] + (int32_t)(k % 2)];
      is_finite &= fabs(given[k]) <= 32768;
      v[k] = is_finite ? rasterproof_filter_snap(given[k]) : 0;
    }
    if (!is_finite || !keep(given, scene->width, scene->height)) continue;
    const int64_t area = rasterproof_filter_edge(v, v + 2, v[4], v[5]);
    if (area == 0) continue;
    uint32_t* const counts = area < 0 ? target->back : target->front;
    for (int32_t row = 0; row < scene->height; ++row) {
      for (int32_t column = 0; column < scene->width; ++column) {
        counts[(size_t)row * target->stride + (size_t)column] +=
            (uint32_t)rasterproof_filter_covers(v, area, column * INT64_C(256) + 128,
                                                row * INT64_C(256) + 128);
      }
    }
  }
  return 0;
}

#ifdef __cplusplus
#define RASTERPROOF_FILTER_LINKAGE extern "C"
#else
#define RASTERPROOF_FILTER_LINKAGE
#endif

/* The function that the library exports. */
#define RASTERPROOF_FILTER(filter_name, keep)                                              \
  static int32_t rasterproof_filter_draw_kept(void* state, const rasterproof_scene* scene, \
                                              const rasterproof_target* target) {          \
    (void)state;                                                                           \
    return rasterproof_filter_draw(keep, scene, target);                                   \
  }                                                                                        \
  RASTERPROOF_FILTER_LINKAGE const rasterproof_plugin* rasterproof_plugin_describe(void) { \
    static rasterproof_plugin plugin;                                                      \
    plugin.version = RASTERPROOF_PLUGIN_VERSION;                                           \
    plugin.size = sizeof plugin;                                                           \
    plugin.name = filter_name;                                                             \
    plugin.summary =                                                                       \
        "draws exactly the triangles that a filter keeps; 8 subpixel bits, nearest-even, " \
        "top-left";                                                                        \
    plugin.profile = "gl-canonical";                                                       \
    plugin.input = RASTERPROOF_FLOAT32;                                                    \
    plugin.coverage = RASTERPROOF_FACING_COUNTS;                                           \
    plugin.draw = rasterproof_filter_draw_kept;                                            \
    return &plugin;                                                                        \
  }

#endif /* RASTERPROOF_KIT_FILTER_PLUGIN_H_ */
