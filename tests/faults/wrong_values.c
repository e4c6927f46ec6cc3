/* A rasterizer in plain C that shows what samples hold, with a fault that is chosen by name in
 * RASTERPROOF_FAULT. It shares nothing with the product: it divides by w first, snaps nothing, and
 * weights 1/w by areas on the screen, in double. RASTERPROOF_WEIGHTS=screen states and shows
 * barycentrics of the screen. Sound without a fault.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

static const char* fault = "";
static int shows_screen;

static int is(const char* name) { return strcmp(fault, name) == 0; }

typedef struct {
  double x[3], y[3], z[3], w[3];
  int32_t index[3];
  double area;
} Triangle;

static double area_of(double ax, double ay, double bx, double by, double cx, double cy) {
  return (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
}

/* Of the three corners, on the screen, at a point. */
static void weights_at(const Triangle* t, double px, double py, double* l) {
  l[0] = area_of(px, py, t->x[1], t->y[1], t->x[2], t->y[2]) / t->area;
  l[1] = area_of(t->x[0], t->y[0], px, py, t->x[2], t->y[2]) / t->area;
  l[2] = area_of(t->x[0], t->y[0], t->x[1], t->y[1], px, py) / t->area;
}

static void swap(double* l, int i, int j) {
  const double kept = l[i];
  l[i] = l[j];
  l[j] = kept;
}

/* The weights in perspective, or what a fault takes for them. */
static void in_perspective(const Triangle* t, const double* screen, double* b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    b[i] = screen[i] / t->w[i];
    if (is("affine")) b[i] = screen[i];
    if (is("twice")) b[i] /= t->w[i];
    if (is("multiplied")) b[i] = screen[i] * t->w[i];
    sum += b[i];
  }
  if (is("not-divided")) return;
  for (int i = 0; i < 3; ++i) b[i] /= sum;
}

static void exchange(const Triangle* t, double* l) {
  if (is("first-two")) swap(l, 0, 1);
  if (is("last-two")) swap(l, 1, 2);
  if (is("last-two-of-back") && t->area < 0) swap(l, 1, 2);
  if (is("rotated")) {
    swap(l, 0, 1);
    swap(l, 1, 2);
  }
}

static double value_at(const Triangle* t, const rasterproof_channel* channel, double px,
                       double py) {
  double l[3], b[3], value = 0;
  if (channel->interpolation == RASTERPROOF_FLAT) {
    return channel->values[t->index[is("flat-last") ? 2 : 0]];
  }
  weights_at(t, px, py, l);
  in_perspective(t, l, b);
  exchange(t, l);
  exchange(t, b);
  for (int i = 0; i < 3; ++i) {
    if (channel->interpolation == RASTERPROOF_INVERSE_W) {
      value += l[i] / t->w[i];
    } else {
      const int is_linear = channel->interpolation == RASTERPROOF_LINEAR && !is("linear-curved");
      value += (is_linear ? l[i] : b[i]) * channel->values[t->index[i]];
    }
  }
  if (is("half") && channel->interpolation == RASTERPROOF_PERSPECTIVE) {
    int exponent;
    const double mantissa = frexp(value, &exponent);
    return ldexp(nearbyint(ldexp(mantissa, 11)), exponent - 11);
  }
  return value;
}

static void show(const rasterproof_scene* scene, const rasterproof_target* target,
                 const Triangle* t, size_t number, double px, double py, size_t k) {
  double l[3], b[3];
  target->primitive_ids[k] = (int32_t)number;
  weights_at(t, px, py, l);
  if (target->depths != NULL) {
    double z = 0, w = 0;
    for (int i = 0; i < 3; ++i) {
      z += l[i] * t->z[i] / t->w[i];
      w += l[i] / t->w[i];
    }
    target->depths[k] = is("depth-in-perspective") ? z / w : is("depth-mapped") ? 2 * z - 1 : z;
    if (is("depth-reversed")) target->depths[k] = 1 - z;
    if (is("depth-cut")) target->depths[k] = floor(fmin(fmax(z, 0), 1) * 0xffff) / 0xffff;
  }
  if (target->barycentrics != NULL) {
    in_perspective(t, l, b);
    exchange(t, l);
    exchange(t, b);
    memcpy(target->barycentrics + 3 * k, shows_screen ? l : b, sizeof l);
  }
  if (is("corner")) px -= 0.5, py -= 0.5;
  for (size_t c = 0; target->values != NULL && c < scene->channel_count; ++c) {
    const size_t asked = is("next-channel") ? (c + 1) % scene->channel_count : c;
    const rasterproof_channel* const channel = &scene->channels[asked];
    double value = value_at(t, channel, px, py);
    if (is("clamped")) value = fmin(fmax(value, 0), 1);
    if (is("w") && channel->interpolation == RASTERPROOF_INVERSE_W) value = 1 / value;
    target->values[scene->channel_count * k + c] = value;
  }
}

static int covers(const Triangle* t, double px, double py) {
  double l[3];
  weights_at(t, px, py, l);
  return l[0] >= 0 && l[1] >= 0 && l[2] >= 0;
}

/* 0 if it is not drawn: it has no area, or is not wholly in front of the eye. */
static int set_up(const rasterproof_scene* scene, size_t number, Triangle* t) {
  for (int i = 0; i < 3; ++i) {
    t->index[i] = scene->triangles[3 * number + (size_t)i];
    const double* const v = scene->vertices + 4 * t->index[i];
    for (int k = 0; k < 4; ++k) {
      if (!isfinite(v[k])) return 0;
    }
    if (v[3] <= 0) return 0;
    t->x[i] = v[0] / v[3];
    t->y[i] = v[1] / v[3];
    t->z[i] = v[2];
    t->w[i] = v[3];
  }
  t->area = area_of(t->x[0], t->y[0], t->x[1], t->y[1], t->x[2], t->y[2]);
  return t->area != 0;
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  for (size_t n = 0; n < scene->triangle_count; ++n) {
    Triangle t;
    if (!set_up(scene, n, &t)) continue;
    for (int32_t row = 0; row < scene->height; ++row) {
      for (int32_t i = 0; i < scene->width; ++i) {
        const double px = i + 0.5, py = row + 0.5;
        if (!covers(&t, px, py)) continue;
        show(scene, target, &t, n, px, py, (size_t)row * target->stride + (size_t)i);
      }
    }
  }
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin;
  static char profile[512];
  const char* const weights = getenv("RASTERPROOF_WEIGHTS");
  if (getenv("RASTERPROOF_FAULT") != NULL) fault = getenv("RASTERPROOF_FAULT");
  shows_screen = weights != NULL && strcmp(weights, "screen") == 0;
  memset(&plugin, 0, sizeof plugin);
  snprintf(profile, sizeof profile,
           "{\"name\": \"wrong values\", \"contract\": \"none\", \"values\": {\"weights\": \"%s\", "
           "\"provoking\": \"first\", \"flat\": true, \"linear\": true, \"inverse_w\": true}}",
           shows_screen ? "screen" : "perspective");
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = "wrong-values";
  plugin.profile = profile;
  plugin.input = RASTERPROOF_FLOAT32;
  plugin.coverage = RASTERPROOF_FRAGMENTS;
  plugin.barycentrics_of = RASTERPROOF_OF_GIVEN;
  plugin.takes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_WANTS | RASTERPROOF_SHOWS_VALUES;
  plugin.draw = draw;
  return &plugin;
}
