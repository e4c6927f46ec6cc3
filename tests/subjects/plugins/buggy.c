/* Plugins with one bug each, by -DBUG_...: what the host of plugins must live through. But for
 * the bug they cover nothing, which is right for scenes of triangles without area. */
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>

#include "kit/rasterproof_plugin.h"

static int calls = 0;

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  ++calls;
#if defined(BUG_CRASH)
  if (scene->triangle_count >= 2) *(volatile int*)NULL = calls;
#elif defined(BUG_EXIT)
  if (scene->triangle_count >= 2) exit(3);
#elif defined(BUG_HANG)
  if (scene->triangle_count >= 2) fprintf(stderr, "it hangs\n");
  while (scene->triangle_count >= 2) {
  }
#elif defined(BUG_RIGHT_OF_ROW)
  target->front[(size_t)scene->width * (size_t)target->samples] += 1;
#elif defined(BUG_ABOVE)
  *(target->front - target->stride) += 1;
#elif defined(BUG_FAR_BELOW)
  target->front[(size_t)(scene->height + 2000) * target->stride + 100000] += 1;
#elif defined(BUG_UNSTEADY)
  target->front[0] += (uint32_t)(calls % 2);
#elif defined(BUG_PRINTS)
  printf("counts 1\nthis is no answer\n");
  fflush(stdout);
#elif defined(BUG_ROUNDS)
  target->front[0] += fegetround() == FE_UPWARD;
  fesetround(FE_UPWARD);
#elif defined(BUG_REFUSES)
  return scene->width > 0;
#endif
  (void)scene;
  (void)target;
  return 0;
}

#if !defined(BUG_NO_SYMBOL)
const rasterproof_plugin* rasterproof_plugin_describe(void) {
#if defined(BUG_AT_LOAD)
  abort();
#endif
  static const rasterproof_plugin plugin = {
#if defined(BUG_VERSION)
      .version = 99,
#else
      .version = RASTERPROOF_PLUGIN_VERSION,
#endif
#if defined(BUG_FIRST_SIZE)
      .size = offsetof(rasterproof_plugin, fixed_integer_bits), /* no bug: an older header's */
      .fixed_integer_bits = 99,
#else
      .size = sizeof(rasterproof_plugin),
#endif
      .name = "buggy",
#if defined(BUG_PROFILE)
      .profile = "{\"snap\": {\"bits\": 99}}",
#else
      .profile = "gl-canonical",
#endif
#if defined(BUG_FIXED_BITS)
      .input = RASTERPROOF_FIXED,
      .fixed_integer_bits = 32,
#else
      .input = RASTERPROOF_FLOAT32,
#endif
      .coverage = RASTERPROOF_FACING_COUNTS,
      .draw = draw,
  };
  return &plugin;
}
#else
int draw_nothing(void) { return draw(NULL, NULL, NULL); }
#endif
