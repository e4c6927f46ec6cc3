/* A plugin that shows edge values and steps in float, five operations each, and its faults, by
 * -DBUG_...: it draws nothing, and states nothing of coverage. */
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
#if defined(BUG_SIGN)
  return -e;
#elif defined(BUG_NAN)
  return e == 0 ? NAN : e;
#else
  return e;
#endif
}

static int32_t edge_value(void* state, const double* a, const double* b, const double* p,
                          double* value) {
  (void)state;
#if defined(BUG_HANGS)
  if (p[0] == a[0] && p[1] == a[1]) {
    for (;;) sleep(1000);
  }
#endif
  *value = (double)value_of(a, b, (float)p[0], (float)p[1]);
  return 0;
}

#ifndef BUG_NO_STEPS
static int32_t edge_steps(void* state, const double* a, const double* b, const double* p,
                          const rasterproof_stepping* stepping, double* values) {
  (void)state;
#if defined(BUG_STEPS_CRASHES)
  if (stepping->length == 16) abort();
#endif
  const float d = stepping->along_y != 0 ? -(float)(b[0] - a[0]) : (float)(b[1] - a[1]);
  const float step = d * (float)(stepping->sign * stepping->length);
  float e = value_of(a, b, (float)p[0], (float)p[1]);
  for (int32_t n = 0; n <= stepping->steps; ++n) {
    values[n] = (double)e;
#if defined(BUG_STEPS_LATE)
    if (n == 5) continue;
#endif
    e += step;
  }
#if defined(BUG_STEPS_TOO_LONG)
  values[stepping->steps + 1] = (double)e;
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
#ifndef BUG_NO_STEPS
      .edge_steps = edge_steps,
#endif
#if defined(BUG_STATES_EXACT)
      .edge_error = 0,
#elif defined(BUG_STATES_NOTHING)
      .edge_error = -1,
#else
      /* Two differences, a product and the sum: four roundings, and a little of second order. */
      .edge_error = 5,
#endif
      .stepping_error = 8};
  return &plugin;
}
