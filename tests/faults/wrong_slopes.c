/* A rasterizer in plain C that shows values and their derivatives, with a fault that is chosen by
 * name in RASTERPROOF_FAULT. RASTERPROOF_DERIVATIVES: analytic, fine or coarse; with quads that are
 * stated to begin at even pixels if RASTERPROOF_QUADS is set. It shares nothing with the product:
 * it divides by w first, and computes in double. Sound without a fault.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

static const char* fault = "";
static const char* by = "analytic";
static const char* quads = "";

static int is(const char* name) { return strcmp(fault, name) == 0; }

typedef struct {
  double x[3], y[3], z[3], w[3], a[3];
  double area;
  int interpolation;
} plane;

/* 0 if it is not drawn: it has no area, or is not wholly in front of the eye. */
static int set_up(const rasterproof_scene* scene, size_t number, plane* t) {
  for (int i = 0; i < 3; ++i) {
    const double* const v = scene->vertices + 4 * scene->triangles[3 * number + (size_t)i];
    if (!isfinite(v[0]) || !isfinite(v[1]) || !isfinite(v[3]) || v[3] <= 0) return 0;
    t->x[i] = v[0] / v[3];
    t->y[i] = v[1] / v[3];
    t->z[i] = v[2] / v[3];
    t->w[i] = v[3];
  }
  t->area = (t->x[1] - t->x[0]) * (t->y[2] - t->y[0]) - (t->y[1] - t->y[0]) * (t->x[2] - t->x[0]);
  return t->area != 0;
}

static void weights_at(const plane* t, double px, double py, double* l) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    l[i] = ((t->x[j] - px) * (t->y[k] - py) - (t->y[j] - py) * (t->x[k] - px)) / t->area;
  }
}

static void use(const rasterproof_scene* scene, size_t number, const rasterproof_channel* channel,
                plane* t) {
  for (int i = 0; i < 3; ++i) {
    const int32_t index = scene->triangles[3 * number + (size_t)i];
    t->a[i] = channel->values == NULL ? 1 : channel->values[index];
  }
  t->interpolation = channel->interpolation;
}

static double value_at(const plane* t, double px, double py) {
  double l[3], value = 0, sum = 0;
  if (t->interpolation == RASTERPROOF_FLAT) return t->a[0];
  weights_at(t, px, py, l);
  for (int i = 0; i < 3; ++i) {
    const double over = t->interpolation == RASTERPROOF_LINEAR ? 1 : 1 / t->w[i];
    value += l[i] * over * t->a[i];
    sum += l[i] * over;
  }
  return t->interpolation == RASTERPROOF_INVERSE_W ? value : value / sum;
}

/* Of the plane: (n / d)' = (n' - v d') / d. */
static void slopes_at(const plane* t, double px, double py, double* slopes) {
  double l[3], n[2] = {0, 0}, d[2] = {0, 0}, sum = 0;
  const double value = value_at(t, px, py);
  slopes[0] = slopes[1] = 0;
  if (t->interpolation == RASTERPROOF_FLAT) return;
  weights_at(t, px, py, l);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double over = t->interpolation == RASTERPROOF_LINEAR ? 1 : 1 / t->w[i];
    const double along[2] = {(t->y[j] - t->y[k]) / t->area, (t->x[k] - t->x[j]) / t->area};
    for (int axis = 0; axis < 2; ++axis) {
      n[axis] += along[axis] * over * t->a[i];
      d[axis] += along[axis] * over;
    }
    sum += l[i] * over;
  }
  for (int axis = 0; axis < 2; ++axis)
    slopes[axis] =
        t->interpolation == RASTERPROOF_INVERSE_W ? n[axis] : (n[axis] - value * d[axis]) / sum;
}

static int quad_begin(int pixel) {
  const int odd = is("odd-quads");
  return pixel - (pixel + odd) % 2;
}

static void differences_at(const plane* t, int32_t column, int32_t row, double* slopes) {
  const int is_coarse = strcmp(by, "coarse") == 0;
  int x = quad_begin(column), y = quad_begin(row);
  if (is("quad-right") || is("quad-across")) x += 2, column += 2;
  if (is("quad-below") || is("quad-across")) y += 2, row += 2;
  const double own_y = 0.5 + (is_coarse ? y : row), own_x = 0.5 + (is_coarse ? x : column);
  slopes[0] = value_at(t, x + 1.5, own_y) - value_at(t, x + 0.5, own_y);
  slopes[1] = value_at(t, own_x, y + 1.5) - value_at(t, own_x, y + 0.5);
  if (is("left-minus-right")) slopes[0] = -slopes[0];
}

static void derive(const rasterproof_scene* scene, size_t number, const plane* t, int channel,
                   int32_t column, int32_t row, double* slopes) {
  plane other = *t;
  double px = column + 0.5, py = row + 0.5;
  if (strcmp(by, "analytic") != 0) {
    differences_at(t, column, row, slopes);
    return;
  }
  if (is("pixel-before")) px -= 1;
  if (is("triangle-before") && number > 0 && set_up(scene, number - 1, &other))
    use(scene, number - 1, &scene->channels[channel], &other);
  slopes_at(&other, px, py, slopes);
  if (is("dy-negated")) slopes[1] = -slopes[1];
}

static void show(const rasterproof_scene* scene, const rasterproof_target* target, plane* t,
                 size_t number, int32_t column, int32_t row) {
  const size_t k = (size_t)row * target->stride + (size_t)column;
  double l[3], sum = 0;
  target->primitive_ids[k] = (int32_t)number;
  weights_at(t, column + 0.5, row + 0.5, l);
  for (int i = 0; i < 3; ++i) sum += l[i] / t->w[i];
  for (int i = 0; i < 3 && target->barycentrics != NULL; ++i)
    target->barycentrics[3 * k + (size_t)i] = l[i] / t->w[i] / sum;
  if (target->depths != NULL) target->depths[k] = l[0] * t->z[0] + l[1] * t->z[1] + l[2] * t->z[2];
  for (size_t c = 0; target->values != NULL && c < scene->channel_count; ++c) {
    const size_t n = scene->channel_count * k + c;
    use(scene, number, &scene->channels[c], t);
    target->values[n] = value_at(t, column + 0.5, row + 0.5);
    if (target->derivatives != NULL)
      derive(scene, number, t, (int)c, column, row, target->derivatives + 2 * n);
  }
}

/* What the target holds beside a pixel, of whichever triangle. */
static void take_from_target(const rasterproof_scene* scene, const rasterproof_target* target) {
  const size_t count = scene->channel_count;
  for (int32_t row = 0; row < scene->height; ++row) {
    for (int32_t column = 0; column < scene->width; ++column) {
      const size_t k = (size_t)row * target->stride + (size_t)column;
      const int step_x = column % 2 == 0 ? 1 : -1, step_y = row % 2 == 0 ? 1 : -1;
      const int32_t x = column + step_x, y = row + step_y;
      for (size_t c = 0; target->primitive_ids[k] >= 0 && c < count; ++c) {
        const double own = target->values[count * k + c];
        const size_t beside = (size_t)row * target->stride + (size_t)x;
        const size_t below = (size_t)y * target->stride + (size_t)column;
        double* const slopes = target->derivatives + 2 * (count * k + c);
        if (x < scene->width && target->primitive_ids[beside] >= 0)
          slopes[0] = step_x * (target->values[count * beside + c] - own);
        if (y < scene->height && target->primitive_ids[below] >= 0)
          slopes[1] = step_y * (target->values[count * below + c] - own);
      }
    }
  }
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t n = 0; n < scene->triangle_count; ++n) {
    plane t;
    if (!set_up(scene, n, &t)) continue;
    for (int32_t row = 0; row < scene->height; ++row) {
      for (int32_t column = 0; column < scene->width; ++column) {
        double l[3];
        weights_at(&t, column + 0.5, row + 0.5, l);
        if (l[0] >= 0 && l[1] >= 0 && l[2] >= 0) show(scene, target, &t, n, column, row);
      }
    }
  }
  if (is("from-target") && target->derivatives != NULL) take_from_target(scene, target);
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin;
  static char profile[512];
  if (getenv("RASTERPROOF_FAULT") != NULL) fault = getenv("RASTERPROOF_FAULT");
  if (getenv("RASTERPROOF_DERIVATIVES") != NULL) by = getenv("RASTERPROOF_DERIVATIVES");
  if (getenv("RASTERPROOF_QUADS") != NULL) quads = "\"quads\": \"even\", ";
  memset(&plugin, 0, sizeof plugin);
  snprintf(profile, sizeof profile,
           "{\"name\": \"wrong slopes\", \"contract\": \"none\", \"values\": {\"weights\": "
           "\"perspective\", \"provoking\": \"first\", \"derivatives\": \"%s\", %s\"flat\": true, "
           "\"linear\": true}}",
           by, quads);
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = "wrong-slopes";
  plugin.profile = profile;
  plugin.input = RASTERPROOF_FLOAT32;
  plugin.coverage = RASTERPROOF_FRAGMENTS;
  plugin.barycentrics_of = RASTERPROOF_OF_GIVEN;
  plugin.takes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_WANTS | RASTERPROOF_SHOWS_VALUES |
                 RASTERPROOF_SHOWS_DERIVATIVES;
  plugin.draw = draw;
  return &plugin;
}
