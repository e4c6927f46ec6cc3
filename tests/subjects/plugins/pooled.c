/* Edge functions in float32, in the calling thread, or with POOLED in a thread that was started by
 * the first draw: which floating-point mode reaches them. MODE_OF_ITS_OWN: the same, but each draw
 * sets the usual mode and restores the caller's, or with LEAVES_A_MODE another one. */
#include <fenv.h>
#include <pthread.h>
#include <stddef.h>

#include "kit/rasterproof_plugin.h"

static const rasterproof_scene* scene;
static const rasterproof_target* target;

static float edge(const double* a, const double* b, float x, float y) {
  const float dx = (float)b[0] - (float)a[0];
  const float dy = (float)b[1] - (float)a[1];
  return (x - (float)a[0]) * dy - (y - (float)a[1]) * dx;
}

static void draw_triangle(const double* v[3]) {
  const float area = edge(v[0], v[1], (float)v[2][0], (float)v[2][1]);
  if (!(area > 0) && !(area < 0)) return;
  const float sign = area > 0 ? 1 : -1;
  uint32_t* const counts = area > 0 ? target->front : target->back;
  for (int row = 0; row < scene->height; ++row) {
    for (int x = 0; x < scene->width; ++x) {
      int inside = 1;
      for (int k = 0; k < 3; ++k) {
        inside &= sign * edge(v[k], v[(k + 1) % 3], (float)x + 0.5F, (float)row + 0.5F) >= 0;
      }
      counts[(size_t)row * target->stride + (size_t)x] += (uint32_t)inside;
    }
  }
}

static void draw_all(void) {
  for (size_t t = 0; t < scene->triangle_count; ++t) {
    const double* v[3];
    for (size_t k = 0; k < 3; ++k) v[k] = scene->vertices + 4 * scene->triangles[3 * t + k];
    draw_triangle(v);
  }
}

#if defined(POOLED)
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int has_work = 0;
static int is_running = 0;

static void* work(void* nothing) {
  (void)nothing;
  pthread_mutex_lock(&mutex);
  for (;;) {
    while (!has_work) pthread_cond_wait(&changed, &mutex);
    draw_all();
    has_work = 0;
    pthread_cond_broadcast(&changed);
  }
  return NULL;
}

static void draw_in_its_place(void) {
  pthread_mutex_lock(&mutex);
  pthread_t thread;
  if (!is_running) is_running = pthread_create(&thread, NULL, work, NULL) == 0;
  has_work = 1;
  pthread_cond_broadcast(&changed);
  while (has_work) pthread_cond_wait(&changed, &mutex);
  pthread_mutex_unlock(&mutex);
}
#elif defined(MODE_OF_ITS_OWN)
static void draw_in_its_place(void) {
  fenv_t callers;
  fegetenv(&callers);
  fesetenv(FE_DFL_ENV);
  draw_all();
#if defined(LEAVES_A_MODE)
  fesetround(FE_UPWARD);
#else
  fesetenv(&callers);
#endif
}
#else
static void draw_in_its_place(void) { draw_all(); }
#endif

static int32_t draw(void* state, const rasterproof_scene* the_scene,
                    const rasterproof_target* the_target) {
  (void)state;
  scene = the_scene;
  target = the_target;
  draw_in_its_place();
  return 0;
}

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = {
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = "pooled",
      .profile = "real",
      .input = RASTERPROOF_FLOAT32,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
  };
  return &plugin;
}
