/* The sound rasterizer of shown.c behind a cache of images whose key holds too little, chosen by
 * -DKEY_...: the pixels that the vertices lie in, sixteenths, target and indices alone, the places
 * of the lists in memory; or, rightly, every bit. */
#define rasterproof_plugin_describe sound_describe
#include "tests/subjects/plugins/shown.c"
#undef rasterproof_plugin_describe

#define MOST_KEPT 64
#define MOST_WORDS 256

typedef struct kept {
  int64_t key[MOST_WORDS];
  uint32_t* front;
  uint32_t* back;
} kept;

static kept* store = NULL;
static size_t kept_count = 0;

#if !defined(KEY_INDICES) && !defined(KEY_ADDRESSES)
static int64_t key_of(double x) {
#if defined(KEY_FLOOR)
  return (int64_t)floor(x);
#elif defined(KEY_SIXTEENTHS)
  return (int64_t)nearbyint(x * 16);
#else
  int64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
#endif
}
#endif

/* Whether the scene has a key; fills it in, the rest zero. */
static int make_key(const rasterproof_scene* scene, const rasterproof_target* target,
                    int64_t key[MOST_WORDS]) {
  memset(key, 0, MOST_WORDS * sizeof *key);
  size_t n = 0;
  key[n++] = scene->width;
  key[n++] = scene->height;
  key[n++] = target->samples;
  key[n++] = scene->cull;
  for (int k = 0; k < 4; ++k) key[n++] = scene->scissor[k];
  key[n++] = (int64_t)scene->vertex_count;
  key[n++] = (int64_t)scene->triangle_count;
#if defined(KEY_ADDRESSES)
  key[n++] = (int64_t)(intptr_t)scene->vertices;
  key[n++] = (int64_t)(intptr_t)scene->triangles;
#else
  if (n + 3 * scene->triangle_count + 2 * scene->vertex_count > MOST_WORDS) return 0;
  for (size_t t = 0; t < 3 * scene->triangle_count; ++t) key[n++] = scene->triangles[t];
#if !defined(KEY_INDICES)
  for (size_t v = 0; v < scene->vertex_count; ++v) {
    if (!(fabs(scene->vertices[4 * v]) < 1e9 && fabs(scene->vertices[4 * v + 1]) < 1e9)) return 0;
    key[n++] = key_of(scene->vertices[4 * v]);
    key[n++] = key_of(scene->vertices[4 * v + 1]);
  }
#endif
#endif
  return 1;
}

/* The rows of the target, out of an image or into it. */
static void copy(const rasterproof_scene* scene, const rasterproof_target* target, kept* image,
                 int is_found) {
  const size_t row_size = (size_t)scene->width * (size_t)target->samples;
  for (size_t row = 0; row < (size_t)scene->height; ++row) {
    uint32_t* const front = target->front + row * target->stride;
    uint32_t* const back = target->back + row * target->stride;
    uint32_t* const kept_front = image->front + row * row_size;
    uint32_t* const kept_back = image->back + row * row_size;
    memcpy(is_found ? front : kept_front, is_found ? kept_front : front, 4 * row_size);
    memcpy(is_found ? back : kept_back, is_found ? kept_back : back, 4 * row_size);
  }
}

static int32_t draw_or_find(void* state, const rasterproof_scene* scene,
                            const rasterproof_target* target) {
  int64_t key[MOST_WORDS];
  const size_t size = (size_t)scene->width * (size_t)scene->height * (size_t)target->samples;
  if (size > 4096 || !make_key(scene, target, key)) return draw(state, scene, target);
  if (store == NULL) store = calloc(MOST_KEPT, sizeof *store);
  /* The last ones alone: what is older would take long to look through. */
  for (size_t back = 1; back <= 64 && back <= kept_count; ++back) {
    kept* const image = &store[(kept_count - back) % MOST_KEPT];
    if (memcmp(image->key, key, sizeof key) != 0) continue;
    copy(scene, target, image, 1);
    return 0;
  }
  const int32_t refused = draw(state, scene, target);
  kept* const image = &store[kept_count++ % MOST_KEPT];
  free(image->front);
  free(image->back);
  memcpy(image->key, key, sizeof key);
  image->front = malloc(4 * size);
  image->back = malloc(4 * size);
  copy(scene, target, image, 0);
  return refused;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static rasterproof_plugin plugin;
  plugin = *sound_describe();
  plugin.draw = draw_or_find;
  plugin.draw_many = NULL;
  return &plugin;
}
