/* A rasterizer in C that shows what covered samples hold: barycentrics, depth, values of channels
 * and their derivatives, in window space and in clip space, in float32.
 *
 *     cc -std=c11 -O2 -ffp-contract=off -shared -fPIC -I. kit/examples/values.c -o values.so -lm
 *     build/rasterproof check --plugin ./values.so
 *
 * With V_i = (x_i, y_i, w_i) and the sample p, the edge values b_i = (V_j x V_k) . (p.x, p.y, 1)
 * are weights in perspective once divided by their sum, b_i w_i by theirs weights on the screen.
 */
#include <math.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

typedef struct {
  float x[3], y[3], w[3], z[3];
} corners;

typedef struct {
  float at[3], by_x[3], by_y[3]; /* of the three edges: value, and derivatives */
} edges;

/* Anchored at the sample, so that little is lost far from the origin. */
static edges edges_at(const corners* v, float px, float py) {
  edges e;
  float x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = v->x[i] - px * v->w[i];
    y[i] = v->y[i] - py * v->w[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    e.at[i] = x[j] * y[k] - y[j] * x[k];
    e.by_x[i] = y[j] * v->w[k] - v->w[j] * y[k];
    e.by_y[i] = v->w[j] * x[k] - x[j] * v->w[k];
  }
  return e;
}

/* Of n / d with n = sum b_i c_i and d = sum b_i e_i. */
static void divide(const edges* b, const float* c, const float* e, double* value,
                   double* derivatives) {
  float n = 0, d = 0, nx = 0, ny = 0, dx = 0, dy = 0;
  for (int i = 0; i < 3; ++i) {
    n += b->at[i] * c[i];
    d += b->at[i] * e[i];
    nx += b->by_x[i] * c[i];
    ny += b->by_y[i] * c[i];
    dx += b->by_x[i] * e[i];
    dy += b->by_y[i] * e[i];
  }
  const float quotient = n / d;
  *value = quotient;
  if (derivatives == NULL) return;
  derivatives[0] = (nx - quotient * dx) / d;
  derivatives[1] = (ny - quotient * dy) / d;
}

static void interpolate(const rasterproof_channel* channel, const int32_t* t, const corners* v,
                        const edges* b, double* value, double* derivatives) {
  float c[3], e[3];
  for (int i = 0; i < 3; ++i) {
    const float a = channel->values == NULL ? 1 : (float)channel->values[t[i]];
    c[i] = channel->interpolation == RASTERPROOF_LINEAR ? a * v->w[i] : a;
    e[i] = channel->interpolation == RASTERPROOF_PERSPECTIVE ? 1 : v->w[i];
  }
  if (channel->interpolation != RASTERPROOF_FLAT) {
    divide(b, c, e, value, derivatives);
    return;
  }
  *value = channel->values[t[0]];
  if (derivatives != NULL) derivatives[0] = derivatives[1] = 0;
}

static void show(const rasterproof_scene* scene, const rasterproof_target* target, size_t number,
                 const corners* v, const edges* b, size_t k) {
  const int32_t* const t = scene->triangles + 3 * number;
  const float units[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const float ones[3] = {1, 1, 1};
  target->primitive_ids[k] = (int32_t)number;
  if (target->barycentrics != NULL) {
    for (int i = 0; i < 3; ++i)
      divide(b, units[i], ones, &target->barycentrics[3 * k + (size_t)i], NULL);
  }
  if (target->depths != NULL) divide(b, v->z, v->w, &target->depths[k], NULL);
  if (target->values == NULL) return;
  for (size_t c = 0; c < scene->channel_count; ++c) {
    const size_t n = scene->channel_count * k + c;
    interpolate(&scene->channels[c], t, v, b, &target->values[n],
                target->derivatives == NULL ? NULL : &target->derivatives[2 * n]);
  }
}

/* The edge values in double decide which samples are covered; ties are. */
static int covers(const corners* v, double px, double py) {
  double b[3], sum = 0, area = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    b[i] = (v->x[j] - px * v->w[j]) * (v->y[k] - py * v->w[k]) -
           (v->y[j] - py * v->w[j]) * (v->x[k] - px * v->w[k]);
    sum += b[i];
    area += b[i] * v->w[i];
  }
  if (area == 0 || sum * area <= 0) return 0; /* flat, or behind the eye */
  return b[0] * sum >= 0 && b[1] * sum >= 0 && b[2] * sum >= 0;
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    corners v;
    int is_finite = 1;
    for (int i = 0; i < 3; ++i) {
      const double* const from = scene->vertices + 4 * scene->triangles[3 * t + (size_t)i];
      for (int k = 0; k < 4; ++k) is_finite &= k == 2 || isfinite(from[k]);
      v.x[i] = (float)from[0];
      v.y[i] = (float)from[1];
      v.z[i] = (float)from[2];
      v.w[i] = (float)from[3];
    }
    if (!is_finite) continue;
    for (int32_t row = 0; row < scene->height; ++row) {
      for (int32_t i = 0; i < scene->width; ++i) {
        if (!covers(&v, i + 0.5, row + 0.5)) continue;
        const edges b = edges_at(&v, (float)i + 0.5f, (float)row + 0.5f);
        show(scene, target, t, &v, &b, (size_t)row * target->stride + (size_t)i);
      }
    }
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin;
  memset(&plugin, 0, sizeof plugin);
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = "values";
  plugin.summary = "values in float32 by homogeneous edge functions";
  plugin.profile =
      "{\"name\": \"values\", \"contract\": \"none\", \"values\": {\"weights\": \"perspective\", "
      "\"provoking\": \"first\", \"derivatives\": \"analytic\", \"flat\": true, \"linear\": true, "
      "\"inverse_w\": true}}";
  plugin.input = RASTERPROOF_FLOAT32;
  plugin.coverage = RASTERPROOF_FRAGMENTS;
  plugin.barycentrics_of = RASTERPROOF_OF_GIVEN;
  plugin.takes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_WANTS | RASTERPROOF_SHOWS_VALUES |
                 RASTERPROOF_SHOWS_DERIVATIVES;
  plugin.draw = draw;
  return &plugin;
}
