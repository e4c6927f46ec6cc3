/* What the sweep test's rasterizers share: a plugin that counts where covers() says so. */
#ifndef RASTERPROOF_TESTS_TOOL_SWEEP_DRAWS_H_
#define RASTERPROOF_TESTS_TOOL_SWEEP_DRAWS_H_

#include "kit/rasterproof_plugin.h"

#ifndef PROFILE
#define PROFILE "real"
#endif

/* Whether a triangle's three sides all have the point on their inner side. */
static int covers(const float v[3][2], float x, float y);

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    float v[3][2];
    for (int k = 0; k < 6; ++k) {
      v[k / 2][k % 2] = (float)scene->vertices[4 * scene->triangles[3 * t + k / 2] + k % 2];
    }
    for (int row = 0; row < scene->height; ++row) {
      for (int i = 0; i < scene->width; ++i) {
        target->front[row * target->stride + i] +=
            (uint32_t)covers(v, (float)i + 0.5F, (float)row + 0.5F);
      }
    }
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin;
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = "swept";
  plugin.profile = PROFILE;
  plugin.coverage = RASTERPROOF_COUNTS;
  plugin.draw = draw;
  return &plugin;
}

#endif
