/* A plugin that shows edge values and walks in float, five operations each, and its faults, by
 * -DFAULT_...: it draws nothing, and promises nothing of coverage. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "kit/rasterproof_plugin.h"

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state, (void)scene, (void)target;
  return 0;
}

static float value_of(const double* a, const double* b, float x, float y) {
  const float ax = (float)a[0];
  const float ay = (float)a[1];
  const float e = (x - ax) * ((float)b[1] - ay) - (y - ay) * ((float)b[0] - ax);
#if defined(FAULT_SIGN)
  return -e;
#elif defined(FAULT_NAN)
  return e == 0 ? NAN : e;
#else
  return e;
#endif
}

static int32_t edge_value(void* state, const double* a, const double* b, const double* p,
                          double* value) {
  (void)state;
#if defined(FAULT_HANGS)
  if (p[0] == a[0] && p[1] == a[1]) {
    for (;;) sleep(1000);
  }
#endif
  *value = (double)value_of(a, b, (float)p[0], (float)p[1]);
  return 0;
}

#ifndef FAULT_NO_WALKS
static int32_t edge_walk(void* state, const double* a, const double* b, const double* p,
                         const rasterproof_walk* walk, double* values) {
  (void)state;
#if defined(FAULT_WALK_CRASHES)
  if (walk->length == 16) abort();
#endif
  const float d = walk->along_y != 0 ? -(float)(b[0] - a[0]) : (float)(b[1] - a[1]);
  const float step = d * (float)(walk->sign * walk->length);
  float e = value_of(a, b, (float)p[0], (float)p[1]);
  for (int32_t n = 0; n <= walk->steps; ++n) {
    values[n] = (double)e;
#if defined(FAULT_WALK_LATE)
    if (n == 5) continue;
#endif
    e += step;
  }
#if defined(FAULT_WALK_TOO_LONG)
  values[walk->steps + 1] = (double)e;
#endif
  return 0;
}
#endif

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "edges",
      .profile = "{\"name\": \"edges\", \"contract\": \"none\"}",
      .coverage = RASTERPROOF_COUNTS,
      .draw = draw,
      .edge_value = edge_value,
#ifndef FAULT_NO_WALKS
      .edge_walk = edge_walk,
#endif
#if defined(FAULT_CLAIMS_EXACT)
      .edge_error = 0,
#elif defined(FAULT_CLAIMS_NOTHING)
      .edge_error = -1,
#else
      /* Two differences, a product and the sum: four roundings, and a little of second order. */
      .edge_error = 5,
#endif
      .walk_error = 8};
  return &plugin;
}
