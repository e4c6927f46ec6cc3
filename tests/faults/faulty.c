/* A rasterizer in plain C with faults that are chosen by name in RASTERPROOF_FAULT, as "int32-all"
 * or, two, "truncates+lost-small". It shares nothing with the suspects of props/cause, which are
 * held to name these faults, or none (tests/faults/causes_test.py). Sound without a fault: 8
 * subpixel bits, nearest-even, top-left.
 */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "kit/rasterproof_plugin.h"

enum { kUnits = 256, kHalf = 128 }; /* steps of a pixel, and of half of it */
static const double kSteps = 256;

static const char* chosen = "";

/* Whether the fault of this name is planted. */
static int is(const char* name) {
  const size_t length = strlen(name);
  for (const char* at = chosen; *at != '\0';) {
    const char* const end = strchr(at, '+');
    const size_t size = end == NULL ? strlen(at) : (size_t)(end - at);
    if (size == length && strncmp(at, name, size) == 0) return 1;
    if (end == NULL) break;
    at = end + 1;
  }
  return 0;
}

typedef struct {
  int64_t x, y;
} Point;

typedef struct {
  Point v[3];
  double given[3][3];
  int32_t index[3];
  size_t number;
  int is_back;
} Triangle;

static uint64_t calls;

static int64_t wrapped(int64_t value, int bits) {
  return (int64_t)((uint64_t)value << (64 - bits)) >> (64 - bits);
}

/* ---- vertices ------------------------------------------------------------------------------- */

static int64_t snapped(double x, int is_y) {
  const double steps = x * kSteps;
  if (is("truncates") || (is("truncates-y") && is_y)) return (int64_t)steps;
  if (is("floors")) return (int64_t)floor(steps);
  if (is("ceils")) return (int64_t)ceil(steps);
  if (is("half-up")) return (int64_t)floor(steps + 0.5);
  if (is("half-down")) return (int64_t)ceil(steps - 0.5);
  if (is("half-away")) return (int64_t)round(steps);
  if (is("half-up-in-float")) return (int64_t)floorf((float)steps + 0.5f);
  if (is("4-bits")) return (int64_t)nearbyint(x * 16) * 16;
  if (is("7-bits")) return (int64_t)nearbyint(x * 128) * 2;
  if (is("whole-pixels")) return (int64_t)nearbyint(x) * 256;
  if (is("float16")) { /* 11 significant bits */
    int exponent = 0;
    const double mantissa = frexp(x, &exponent);
    return (int64_t)nearbyint(ldexp(nearbyint(mantissa * 2048), exponent - 11) * kSteps);
  }
  return (int64_t)nearbyint(steps);
}

static double limited(double x, double low, double high) {
  return x < low ? low : x > high ? high : x;
}

static Point placed(const double* at, const rasterproof_scene* scene) {
  double x = at[0], y = at[1];
  if (is("clamps-negative")) x = fmax(x, 0), y = fmax(y, 0);
  if (is("clamps-2048")) x = limited(x, -2048, 2048), y = limited(y, -2048, 2048);
  if (is("clamps-to-target")) x = limited(x, 0, scene->width), y = limited(y, 0, scene->height);
  Point p = {snapped(x, 0), snapped(y, 1)};
  if (is("int16-coordinates")) p.x = wrapped(p.x, 16), p.y = wrapped(p.y, 16);
  if (is("int20-coordinates")) p.x = wrapped(p.x, 20), p.y = wrapped(p.y, 20);
  return p;
}

/* ---- edges ---------------------------------------------------------------------------------- */

static int64_t product(int64_t a, int64_t b) {
  const int64_t ab = a * b;
  if (is("int32-products")) return wrapped(ab, 32);
  return ab;
}

/* Bits that every value has, 64 if none is planted. */
static int bits_of_all(void) {
  return is("int32-all")   ? 32
         : is("int24-all") ? 24
         : is("int28-all") ? 28
         : is("int33-all") ? 33
                           : 64;
}

static int sign_of_float(float e) { return (e > 0) - (e < 0); }

static float direct(Point a, Point b, Point p) {
  const float px = (float)p.x - (float)a.x, py = (float)p.y - (float)a.y;
  const float dx = (float)b.x - (float)a.x, dy = (float)b.y - (float)a.y;
  return px * dy - py * dx;
}

static float affine(Point a, Point b, Point p) {
  const float ca = (float)(b.y - a.y), cb = (float)(a.x - b.x);
  const float cc = (float)a.y * (float)b.x - (float)a.x * (float)b.y;
  return ca * (float)p.x + cb * (float)p.y + cc;
}

static int64_t value(Point a, Point b, Point p) {
  return product(p.x - a.x, b.y - a.y) - product(p.y - a.y, b.x - a.x);
}

/* Its sign; 0: on the edge. */
static int edge(const Triangle* t, int k, Point p, Point first) {
  const Point a = t->v[(k + 1) % 3], b = t->v[(k + 2) % 3];
  if (is("float-direct") || is("float-direct-all")) return sign_of_float(direct(a, b, p));
  if (is("float-affine") || is("float-affine-all")) return sign_of_float(affine(a, b, p));
  if (is("float-stepped")) {
    float e = direct(a, b, first);
    const float step = (float)(b.y - a.y) * (float)kSteps;
    for (int64_t x = first.x; x < p.x; x += kUnits) e += step;
    return sign_of_float(e);
  }
  int64_t e = value(a, b, p);
  e = wrapped(e, bits_of_all());
  if (is("int32-edges")) e = wrapped(e, 32);
  if (is("int36-edges")) e = wrapped(e, 36);
  if (is("drops-4-bits")) e >>= 4;
  if (is("drops-8-bits")) e /= 256;
  if (is("epsilon-inside") && e > -64) return 1;
  if (is("epsilon-outside") && e < 64) return -1;
  return (e > 0) - (e < 0);
}

static int owns(const Triangle* t, int k) {
  const Point a = t->v[(k + 1) % 3], b = t->v[(k + 2) % 3];
  const int left = a.y < b.y, top = a.y == b.y && b.x < a.x, level = a.y == b.y;
  if (is("ties-inclusive")) return 1;
  if (is("ties-exclusive")) return 0;
  if (is("ties-bottom-left")) return left || (level && b.x > a.x);
  if (is("ties-top-right")) return a.y > b.y || top;
  if (is("ties-bottom-right")) return a.y > b.y || (level && b.x > a.x);
  if (is("ties-no-top")) return left;
  if (is("ties-all-level")) return left || level;
  if (is("ties-no-upright")) return (left && a.x != b.x) || top;
  if (is("ties-of-front-alone")) return (left || top) && !t->is_back;
  if (is("ties-by-index")) return t->index[(k + 1) % 3] < t->index[(k + 2) % 3];
  if (is("ties-opposite-first")) return k == 0 ? !(left || top) : left || top;
  if (is("ties-first-edge-inclusive")) return k == 0 || left || top;
  return left || top;
}

static int sign_of_area(const Triangle* t) {
  const Point a = t->v[0], b = t->v[1], c = t->v[2];
  if (is("float-direct-all") || is("float-affine-all")) return sign_of_float(direct(a, b, c));
  if (is("facing-of-input")) {
    const double area = (t->given[2][0] - t->given[0][0]) * (t->given[1][1] - t->given[0][1]) -
                        (t->given[2][1] - t->given[0][1]) * (t->given[1][0] - t->given[0][0]);
    const int64_t e = value(a, b, c);
    return e == 0 ? 0 : (area > 0) - (area < 0);
  }
  int64_t e = wrapped(value(a, b, c), bits_of_all());
  if (is("int32-area")) e = wrapped(e, 32);
  if (is("int24-area")) e = wrapped(e, 24);
  return (e > 0) - (e < 0);
}

/* ---- triangles that are left out ------------------------------------------------------------ */

static int64_t least(const Triangle* t, int y) {
  int64_t n = INT64_MAX;
  for (int k = 0; k < 3; ++k) n = (y ? t->v[k].y : t->v[k].x) < n ? (y ? t->v[k].y : t->v[k].x) : n;
  return n;
}
static int64_t most(const Triangle* t, int y) {
  int64_t n = INT64_MIN;
  for (int k = 0; k < 3; ++k) n = (y ? t->v[k].y : t->v[k].x) > n ? (y ? t->v[k].y : t->v[k].x) : n;
  return n;
}
static int64_t floored(int64_t n) { return n >= 0 ? n / kUnits : -((-n + kUnits - 1) / kUnits); }

static int is_lost(const Triangle* t) {
  const int64_t wide = most(t, 0) - least(t, 0), high = most(t, 1) - least(t, 1);
  const double area = fabs((double)value(t->v[0], t->v[1], t->v[2])) / 2 / kSteps / kSteps;
  const double far = fmax(fmax(fabs((double)least(t, 0)), fabs((double)most(t, 0))),
                          fmax(fabs((double)least(t, 1)), fabs((double)most(t, 1)))) /
                     kSteps;
  if (is("lost-small") && area < 0.5) return 1;
  if (is("lost-tiny") && area < 1.0 / 64) return 1;
  if (is("lost-box-of-a-pixel") && wide < kUnits && high < kUnits) return 1;
  if (is("lost-narrow") && (wide < kUnits / 4 || high < kUnits / 4)) return 1;
  /* Between whole pixels, where centres are meant. */
  if (is("lost-between-corners") &&
      (floored(least(t, 0)) == floored(most(t, 0)) || floored(least(t, 1)) == floored(most(t, 1))))
    return 1;
  if (is("lost-thin") && area / fmax(1e-9, fmax((double)wide, (double)high) / kSteps) < 1.0 / 32)
    return 1;
  if (is("lost-far") && far > 4096) return 1;
  if (is("lost-from-16") && t->number >= 16) return 1;
  if (is("lost-by-hash") &&
      ((uint64_t)(t->v[0].x * 31 + t->v[1].y * 17 + t->v[2].x) * 2654435761U >> 7) % 7 == 0)
    return 1;
  if (is("lost-each-third") && t->number % 3 == 2) return 1;
  if (is("lost-behind-half") && t->given[0][2] > 0.5) return 1;
  if (is("culls-back") && t->is_back) return 1;
  if (is("culls-front") && !t->is_back) return 1;
  return 0;
}

/* ---- samples -------------------------------------------------------------------------------- */

static int covers(const Triangle* t, Point p, Point first) {
  if (is("lost-on-vertices")) {
    for (int k = 0; k < 3; ++k) {
      if (t->v[k].x == p.x && t->v[k].y == p.y) return 0;
    }
  }
  for (int k = 0; k < 3; ++k) {
    const int sign = edge(t, k, p, first);
    if (sign < 0 || (sign == 0 && !owns(t, k))) return 0;
  }
  return 1;
}

static Point sample_of(int32_t x, int32_t row) {
  Point p = {x * (int64_t)kUnits + kHalf, row * (int64_t)kUnits + kHalf};
  if (is("sample-corner")) p.x -= kHalf, p.y -= kHalf;
  if (is("sample-off-x")) p.x += 1;
  if (is("sample-off-y")) p.y -= 16;
  return p;
}

/* 0 to 2: how often a covered sample counts. */
static uint32_t times(const Triangle* t, int32_t x, int32_t row, const rasterproof_scene* scene) {
  if (is("no-last-column") && x == scene->width - 1) return 0;
  if (is("no-first-row") && row == 0) return 0;
  if (is("no-column-from-16") && x >= 16) return 0;
  if (is("no-row-of-odd-height") && scene->height % 2 == 1 && row == scene->height - 1) return 0;
  if (is("seams-twice") && x % 16 == 0 && x > 0) return 2;
  if (is("seams-lost") && row % 8 == 7) return 0;
  if (is("right-half-lost") && x * (int64_t)kUnits > (least(t, 0) + most(t, 0)) / 2) return 0;
  return 1;
}

typedef struct {
  int32_t x0, y0, x1, y1;
} Box;

static int32_t within(int64_t pixel, int32_t size) {
  return pixel < 0 ? 0 : pixel > size ? size : (int32_t)pixel;
}

static Box box_of(const Triangle* t, const rasterproof_scene* scene) {
  int64_t x0 = floored(least(t, 0)), x1 = floored(most(t, 0)) + 1;
  int64_t y0 = floored(least(t, 1)), y1 = floored(most(t, 1)) + 1;
  if (is("box-ends-early-x")) x1 -= 1;
  if (is("box-ends-early-y")) y1 -= 1;
  if (is("box-begins-late"))
    x0 = floored(least(t, 0) + kUnits - 1), y0 = floored(least(t, 1) + kUnits - 1);
  if (is("box-row-lost")) y0 += 1;
  const Box box = {within(x0, scene->width), within(y0, scene->height), within(x1, scene->width),
                   within(y1, scene->height)};
  return box;
}

static void count(const Triangle* t, int32_t x, int32_t row, uint32_t n,
                  const rasterproof_scene* scene, const rasterproof_target* target) {
  if (is("upside-down")) row = scene->height - 1 - row;
  const int is_back = is("exchanged") ? !t->is_back : is("all-front") ? 0 : t->is_back;
  uint32_t* const counts = is_back ? target->back : target->front;
  uint32_t* const at = counts + (size_t)row * target->stride + (size_t)x;
  if (is("counts-once")) {
    *at = n != 0 && target->front[(size_t)row * target->stride + (size_t)x] == 0 &&
                  target->back[(size_t)row * target->stride + (size_t)x] == 0
              ? 1
              : *at;
    return;
  }
  *at = is("counts-parity") ? (*at + n) % 2 : *at + n;
}

/* Blocks of pixels that are taken or left whole by the sign at one point of theirs. */
static int block(const Triangle* t, int32_t x, int32_t row) {
  const int side = 8;
  const Point middle = {(x / side * side + side / 2) * (int64_t)kUnits,
                        (row / side * side + side / 2) * (int64_t)kUnits};
  int inside = 1, near = 1;
  for (int k = 0; k < 3; ++k) {
    const Point a = t->v[(k + 1) % 3], b = t->v[(k + 2) % 3];
    const int64_t e = value(a, b, middle);
    const int64_t reach = (llabs(b.x - a.x) + llabs(b.y - a.y)) * (side / 2) * kUnits;
    inside &= e > reach * 3 / 4;
    near &= e > -reach * 3 / 4;
  }
  return inside ? 1 : near ? 0 : -1;
}

static void draw_triangle(const Triangle* t, const rasterproof_scene* scene,
                          const rasterproof_target* target, uint8_t* budget) {
  const Box box = box_of(t, scene);
  for (int32_t row = box.y0; row < box.y1; ++row) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      int covered = covers(t, sample_of(x, row), sample_of(box.x0, row));
      if (is("block-accepted") && block(t, x, row) > 0) covered = 1;
      if (is("block-rejected") && block(t, x, row) < 0) covered = 0;
      if (budget != NULL) {
        uint8_t* const left = budget + (row / 8 * 1024 + x / 8) % 65536;
        if (x % 8 == 0 || x == box.x0) *left = (uint8_t)(*left + (*left < 255));
        if (*left > 24) covered = 0;
      }
      const uint32_t n = covered ? times(t, x, row, scene) : 0;
      if (n != 0) count(t, x, row, n, scene, target);
    }
  }
}

/* A flat triangle as the samples on it. */
static void draw_flat(const Triangle* t, const rasterproof_scene* scene,
                      const rasterproof_target* target) {
  const Box box = box_of(t, scene);
  for (int32_t row = box.y0; row < box.y1; ++row) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      int on = 1;
      const Point p = sample_of(x, row);
      for (int k = 0; k < 3; ++k) on &= value(t->v[k], t->v[(k + 1) % 3], p) == 0;
      if (on && p.x >= least(t, 0) && p.x <= most(t, 0) && p.y >= least(t, 1) && p.y <= most(t, 1))
        count(t, x, row, 1, scene, target);
    }
  }
}

static double finite(double x) {
  if (is("nan-is-zero") && isnan(x)) return 0;
  return x;
}

/* 0: it has a vertex that is not to be drawn. */
static int take(Triangle* t, const rasterproof_scene* scene, size_t number) {
  t->number = number;
  for (int k = 0; k < 3; ++k) {
    int32_t index = scene->triangles[3 * number + (size_t)k];
    if (is("index-of-8-bits")) index &= 0xff;
    t->index[k] = index;
    const double* const from = scene->vertices + 4 * (size_t)index;
    for (int axis = 0; axis < 3; ++axis) t->given[k][axis] = finite(from[axis]);
    if (!(fabs(t->given[k][0]) <= 32768 && fabs(t->given[k][1]) <= 32768)) return 0;
    t->v[k] = placed(t->given[k], scene);
  }
  return 1;
}

/* What no one foresees: the clock, as a race has it. */
static uint64_t chance(void) {
  static uint64_t state;
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  state = state * UINT64_C(6364136223846793005) + (uint64_t)now.tv_nsec * 2 + 1;
  return state >> 33;
}

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  ++calls;
  if (is("draws-nothing") || (is("each-third-draw-lost") && calls % 3 == 0)) return 0;
  static Triangle last;
  static uint8_t budget[65536];
  memset(budget, 0, sizeof budget);
  for (size_t n = 0; n < scene->triangle_count; ++n) {
    Triangle t;
    if (!take(&t, scene, n)) continue;
    const int sign = sign_of_area(&t);
    if (sign == 0) {
      if (is("flat-as-lines")) draw_flat(&t, scene, target);
      continue;
    }
    t.is_back = sign < 0;
    if (t.is_back) {
      const Point v = t.v[1];
      const int32_t index = t.index[1];
      t.v[1] = t.v[2], t.v[2] = v;
      t.index[1] = t.index[2], t.index[2] = index;
    }
    if (is_lost(&t)) continue;
    if (is("keeps-last-edge") && n > 0) t.v[0].y = last.v[0].y;
    draw_triangle(&t, scene, target, is("budget-of-a-tile") ? budget : NULL);
    last = t;
  }
  const int by_chance = is("race") && chance() % 4 == 0;
  const uint64_t hit =
      by_chance ? chance() % ((uint64_t)scene->width * (uint64_t)scene->height) : 0;
  for (int32_t row = 0; row < scene->height; ++row) {
    for (int32_t x = 0; x < scene->width; ++x) {
      uint32_t* const at = target->front + (size_t)row * target->stride + (size_t)x;
      if (is("garbage")) *at = (uint32_t)(chance() % 3);
      if (is("fills-all")) *at = 1;
      if (by_chance && hit == (uint64_t)row * (uint64_t)scene->width + (uint64_t)x) ++*at;
    }
  }
  return 0;
}

static void start(void* state) { (void)state; }

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "faulty",
      .summary = "8 subpixel bits in 64-bit integers, and a fault",
      .profile = "gl-canonical",
      .input = RASTERPROOF_FLOAT32,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
      .reset = start,
  };
  const char* const named = getenv("RASTERPROOF_FAULT");
  chosen = named == NULL ? "" : named;
  return &plugin;
}
