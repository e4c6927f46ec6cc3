/* A sound rasterizer with every kind of output, and its faults, by -DBUG_...: 8 subpixel bits,
 * nearest-even, top-left, 64-bit integers, barycentrics and depths in double from the snapped
 * vertices. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

#if defined(KIND_FACING_COUNTS)
#define KIND RASTERPROOF_FACING_COUNTS
#elif defined(KIND_COUNTS)
#define KIND RASTERPROOF_COUNTS
#elif defined(KIND_MASK)
#define KIND RASTERPROOF_MASK
#elif defined(KIND_PRIMITIVE_IDS)
#define KIND RASTERPROOF_PRIMITIVE_IDS
#else
#define KIND RASTERPROOF_FRAGMENTS
#endif

#if defined(BUG_FIRST_WINS)
static const int kFirstWins = 1;
#else
static const int kFirstWins = 0;
#endif

/* With w: the places are x / w and y / w, and everything between them is affine. */
#if defined(TAKES_BOTH_SPACES)
#define SPACES RASTERPROOF_TAKES_CLIP_SPACE
#else
#define SPACES 0
#endif

#if defined(SHOWS_CENTROIDS)
#define CENTROIDS RASTERPROOF_SHOWS_CENTROIDS
#else
#define CENTROIDS 0
#endif

#if defined(SHOWS_VALUES)
#define VALUES (RASTERPROOF_SHOWS_VALUES | RASTERPROOF_SHOWS_DERIVATIVES)
#elif defined(SHOWS_DERIVATIVES_ALONE)
#define VALUES RASTERPROOF_SHOWS_DERIVATIVES
#else
#define VALUES 0
#endif

typedef struct triangle {
  const int32_t* vertices;
  int64_t v[3][2];
  double z[3];
  int is_back;
} triangle;

static int64_t edge(const int64_t* a, const int64_t* b, int64_t x, int64_t y) {
  return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
}

/* Whether a sample on the edge a -> b of a counter-clockwise triangle is the triangle's. */
static int is_top_left(const int64_t* a, const int64_t* b) {
  return a[1] < b[1] || (a[1] == b[1] && b[0] < a[0]);
}

static int covers(const triangle* t, int64_t x, int64_t y, int64_t e[3]) {
  const int64_t sign = t->is_back ? -1 : 1;
  int inside = 1;
  for (int k = 0; k < 3; ++k) {
    const int64_t* const a = t->v[(k + (t->is_back ? 2 : 1)) % 3];
    const int64_t* const b = t->v[(k + (t->is_back ? 1 : 2)) % 3];
    e[k] = edge(a, b, x, y);
    inside &= e[k] > 0 || (e[k] == 0 && is_top_left(a, b));
    e[k] *= sign;
  }
  return inside;
}

/* Of the one sample of a pixel it is the centre. */
static void show_centroid(const double w[3], const rasterproof_target* target, size_t at) {
#if defined(SHOWS_CENTROIDS)
  if (target->centroids == NULL) return;
  double* const centroid = target->centroids + 3 * at;
  memcpy(centroid, w, 3 * sizeof(double));
#if defined(BUG_CENTROID)
  centroid[0] += 0x1p-20;
  centroid[1] -= 0x1p-20;
#endif
#else
  (void)w;
  (void)target;
  (void)at;
#endif
}

/* In window space, where 1/w is 1; flat is the first vertex's. */
static void show_values(const triangle* t, const double w[3], double area,
                        const rasterproof_scene* scene, const rasterproof_target* target,
                        size_t at) {
#if defined(SHOWS_VALUES)
  for (size_t c = 0; target->values != NULL && c < scene->channel_count; ++c) {
    const rasterproof_channel* const channel = scene->channels + c;
    const int is_flat = channel->interpolation == RASTERPROOF_FLAT;
    const int is_inverse_w = channel->interpolation == RASTERPROOF_INVERSE_W;
    double value = 0;
    double along[2] = {0, 0};
    for (int k = 0; k < 3; ++k) {
      const int64_t* const a = t->v[(k + 1) % 3];
      const int64_t* const b = t->v[(k + 2) % 3];
      const double x = is_inverse_w ? 1 : channel->values[t->vertices[is_flat ? 0 : k]];
      value += w[k] * x;
      along[0] += x * (double)(256 * (b[1] - a[1])) / area;
      along[1] -= x * (double)(256 * (b[0] - a[0])) / area;
    }
    const size_t entry = scene->channel_count * at + c;
    target->values[entry] = value;
    if (target->derivatives != NULL) memcpy(target->derivatives + 2 * entry, along, sizeof along);
#if defined(BUG_VALUES_OUTSIDE)
    target->values[entry + scene->channel_count * target->stride * (size_t)scene->height] = value;
#endif
  }
#else
  (void)t, (void)w, (void)area, (void)scene, (void)target, (void)at;
#endif
}

static void show_fragment(const triangle* t, const int64_t e[3], const rasterproof_scene* scene,
                          const rasterproof_target* target, size_t at) {
  const double area = (double)edge(t->v[0], t->v[1], t->v[2][0], t->v[2][1]);
  double w[3];
  for (int k = 0; k < 3; ++k) w[k] = (double)e[k] / area;
  double depth = w[0] * t->z[0] + w[1] * t->z[1] + w[2] * t->z[2];
#if defined(BUG_BARYCENTRICS_PERMUTED)
  const double first = w[0];
  w[0] = w[1];
  w[1] = first;
#elif defined(BUG_EQUAL_WEIGHTS)
  for (int k = 0; k < 3; ++k) w[k] = 1.0 / 3;
#elif defined(BUG_SUM)
  w[2] *= 1 + 0x1p-44;
#elif defined(BUG_DEPTH)
  depth = w[0] * t->z[0] + w[1] * t->z[2] + w[2] * t->z[1];
#elif defined(BUG_HULL)
  depth = t->z[0] + t->z[1] + t->z[2];
#endif
#if defined(NEEDS_ALL)
  const uint32_t wants = RASTERPROOF_WANTS_BARYCENTRICS | RASTERPROOF_WANTS_DEPTHS;
#else
  const uint32_t wants = target->wants;
#endif
  if ((wants & RASTERPROOF_WANTS_BARYCENTRICS) != 0)
    memcpy(target->barycentrics + 3 * at, w, sizeof w);
  if ((wants & RASTERPROOF_WANTS_DEPTHS) != 0) target->depths[at] = depth;
  show_centroid(w, target, at);
  show_values(t, w, area, scene, target, at);
}

static void show(const triangle* t, int32_t index, const int64_t e[3],
                 const rasterproof_scene* scene, const rasterproof_target* target, size_t at) {
  if (KIND == RASTERPROOF_FACING_COUNTS) {
    (t->is_back ? target->back : target->front)[at] += 1;
  } else if (KIND == RASTERPROOF_COUNTS) {
    target->front[at] += 1;
  } else if (KIND == RASTERPROOF_MASK) {
    target->front[at] = 1;
  } else {
    if (kFirstWins && target->primitive_ids[at] >= 0) return;
#if defined(BUG_ID)
    target->primitive_ids[at] = index >= 256 ? index - 1 : index;
#elif defined(BUG_NO_ID)
    target->primitive_ids[at] = index + 100000;
#else
    target->primitive_ids[at] = index;
#endif
    if (KIND == RASTERPROOF_FRAGMENTS) show_fragment(t, e, scene, target, at);
  }
}

#if defined(BUG_EVERY_THIRD)
static int is_third = 0;
#endif

/* The pixels along an axis that the triangle reaches: from the first on, before the end. */
static int32_t first(const triangle* t, int axis, int32_t from) {
  int64_t least = t->v[0][axis];
  for (int k = 1; k < 3; ++k) least = t->v[k][axis] < least ? t->v[k][axis] : least;
  const int64_t pixel = (least >> 8) - 1;
  return pixel > from ? (int32_t)pixel : from;
}
static int32_t end(const triangle* t, int axis, int32_t to) {
  int64_t most = t->v[0][axis];
  for (int k = 1; k < 3; ++k) most = t->v[k][axis] > most ? t->v[k][axis] : most;
  const int64_t pixel = (most >> 8) + 1;
  return pixel < to ? (int32_t)pixel : to;
}

static void draw_triangle(const triangle* t, int32_t index, const rasterproof_scene* scene,
                          const rasterproof_target* target) {
  const int32_t* cut = scene->scissor;
#if defined(BUG_SCISSOR)
  const int32_t whole[4] = {0, 0, scene->width, scene->height};
  cut = whole;
#elif defined(BUG_EVERY_THIRD)
  const int32_t below[4] = {cut[0], cut[1] > 0 ? cut[1] : 1, cut[2], cut[3]};
  if (is_third) cut = below;
#endif
  for (int32_t row = first(t, 1, cut[1]); row < end(t, 1, cut[3]); ++row) {
    for (int32_t i = first(t, 0, cut[0]); i < end(t, 0, cut[2]); ++i) {
      int64_t e[3];
      if (!covers(t, i * INT64_C(256) + 128, row * INT64_C(256) + 128, e)) continue;
      show(t, index, e, scene, target, (size_t)row * target->stride + (size_t)i);
    }
  }
}

static int is_culled(const triangle* t, const rasterproof_scene* scene) {
#if defined(BUG_CULLING)
  return 0;
#endif
  return (scene->cull == RASTERPROOF_CULL_FRONT && !t->is_back) ||
         (scene->cull == RASTERPROOF_CULL_BACK && t->is_back);
}

static int set_up(const rasterproof_scene* scene, size_t index, triangle* t) {
  t->vertices = scene->triangles + 3 * index;
  for (int k = 0; k < 3; ++k) {
    const double* const from = scene->vertices + 4 * t->vertices[k];
    for (int axis = 0; axis < 2; ++axis) {
      const double at = SPACES != 0 ? from[axis] / from[3] : from[axis];
      if (!(fabs(at) <= 32768) || (SPACES != 0 && !(from[3] > 0))) return 0;
      t->v[k][axis] = (int64_t)nearbyint(at * 256);
    }
    t->z[k] = SPACES != 0 ? from[2] / from[3] : from[2];
  }
  const int64_t area = edge(t->v[0], t->v[1], t->v[2][0], t->v[2][1]);
  t->is_back = area < 0;
  return area != 0;
}

#if defined(BUG_ONE_SAMPLE)
/* One sample of a large mesh: covered if it is not, and the other way round. */
static void turn_middle(const rasterproof_scene* scene, const rasterproof_target* target) {
  const size_t at = (size_t)(scene->height / 2) * target->stride + (size_t)(scene->width / 2);
  if (KIND == RASTERPROOF_MASK) {
    target->front[at] = target->front[at] == 0;
  } else {
    target->primitive_ids[at] = target->primitive_ids[at] < 0 ? 0 : -1;
  }
}
#endif

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
#if defined(BUG_EVERY_THIRD)
  static int draws = 0;
  is_third = ++draws % 3 == 0;
#endif
#if defined(SHOWS_VALUES)
  const int wants_values = (target->wants & RASTERPROOF_WANTS_VALUES) != 0;
  const int wants_derivatives = (target->wants & RASTERPROOF_WANTS_DERIVATIVES) != 0;
  if (wants_values != (target->values != NULL) || wants_values != (scene->channel_count != 0) ||
      wants_derivatives != (target->derivatives != NULL)) {
    return 1;
  }
#endif
#if defined(BUG_CRASHES_THIRD)
  static int calls = 0;
  if (++calls % 3 == 0) abort();
#endif
  size_t count = scene->triangle_count;
#if defined(BUG_MESH)
  if (count > 1) --count;
#elif defined(BUG_MANY)
  if (count > 256) count = 256;
#endif
  for (size_t n = 0; n < count; ++n) {
    triangle t;
    if (!set_up(scene, n, &t) || is_culled(&t, scene)) continue;
    draw_triangle(&t, (int32_t)n, scene, target);
  }
#if defined(BUG_ONE_SAMPLE)
  if (count > 1000) turn_middle(scene, target);
#endif
  return 0;
}

#if !defined(NO_BATCHES)
static int32_t draw_many(void* state, const rasterproof_scene* const* scenes,
                         const rasterproof_target* const* targets, size_t n) {
  for (size_t k = 0; k < n; ++k) {
#if defined(BUG_BATCH_LAST)
    if (k + 1 == n) continue;
#elif defined(BUG_BATCH_LEAK)
    if (k > 0 && targets[k - 1]->front[0] != 0) targets[k]->front[0] += 1;
#elif defined(BUG_BATCH_INDICES) || defined(BUG_BATCH_VERTICES)
    if (k > 0 && scenes[k]->triangle_count == scenes[k - 1]->triangle_count &&
        scenes[k]->vertex_count == scenes[k - 1]->vertex_count) {
      rasterproof_scene stale = *scenes[k];
#if defined(BUG_BATCH_INDICES)
      stale.triangles = scenes[k - 1]->triangles;
#else
      stale.vertices = scenes[k - 1]->vertices;
#endif
      if (draw(state, &stale, targets[k]) != 0) return 1;
      continue;
    }
#elif defined(BUG_BATCH_OPTIONS)
    if (k > 0 && scenes[k]->width == scenes[0]->width && scenes[k]->height == scenes[0]->height) {
      rasterproof_scene stale = *scenes[k];
      stale.cull = scenes[0]->cull;
      if (draw(state, &stale, targets[k]) != 0) return 1;
      continue;
    }
#elif defined(BUG_BATCH_CRASH)
    if (scenes[k]->triangle_count == 3) abort();
#elif defined(BUG_BATCH_CRASH_TOGETHER)
    if (k > 0 && scenes[k]->triangle_count + scenes[k - 1]->triangle_count == 5) abort();
#elif defined(BUG_BATCH_REFUSED)
    return 1;
#endif
    const int32_t refused = draw(state, scenes[k], targets[k]);
    if (refused != 0) return refused;
  }
  return 0;
}
#endif

#if defined(BUG_BATCH_CRASH)
static int32_t draw_or_crash(void* state, const rasterproof_scene* scene,
                             const rasterproof_target* target) {
  if (scene->triangle_count == 3) abort();
  return draw(state, scene, target);
}
#define DRAW draw_or_crash
#else
#define DRAW draw
#endif

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
#if defined(OLD_SIZE)
      .size = offsetof(rasterproof_plugin, draw_many),
#else
      .size = sizeof(rasterproof_plugin),
#endif
      .name = "shown",
#if defined(SHOWS_CENTROIDS)
      .profile =
          "{\"name\": \"shown\", \"subpixel_bits\": 8, \"coordinate_limit\": 32768, "
          "\"infinite_vertex\": \"unspecified\", \"centroid\": \"inside\"}",
#else
      .profile = "gl-canonical",
#endif
      .input = RASTERPROOF_FLOAT32,
      .coverage = KIND,
#if defined(NEEDS_ALL)
      .takes = RASTERPROOF_TAKES_SCISSOR | RASTERPROOF_TAKES_CULLING,
#else
      .takes = RASTERPROOF_TAKES_SCISSOR | RASTERPROOF_TAKES_CULLING | RASTERPROOF_TAKES_WANTS |
               CENTROIDS | VALUES | SPACES,
#endif
      .draw = DRAW,
#if defined(NO_BATCHES)
      .draw_many = NULL,
#else
      .draw_many = draw_many,
#endif
      .barycentrics_of = RASTERPROOF_OF_SNAPPED,
      .barycentric_error = 0x1p-46,
      .depth_error = 0x1p-44,
  };
  return &plugin;
}
