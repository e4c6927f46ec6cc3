/* Plugins with one fault each, by -DFAULT_...: what the host of plugins must live through. But for
 * the fault they cover nothing, which is right for scenes of triangles without area. */
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>

#include "kit/rasterproof_plugin.h"

static int calls = 0;

static int32_t draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  (void)state;
  ++calls;
#if defined(FAULT_CRASH)
  if (scene->triangle_count >= 2) *(volatile int*)NULL = calls;
#elif defined(FAULT_EXIT)
  if (scene->triangle_count >= 2) exit(3);
#elif defined(FAULT_HANG)
  if (scene->triangle_count >= 2) fprintf(stderr, "it hangs\n");
  while (scene->triangle_count >= 2) {
  }
#elif defined(FAULT_RIGHT_OF_ROW)
  target->front[(size_t)scene->width * (size_t)target->samples] += 1;
#elif defined(FAULT_ABOVE)
  *(target->front - target->stride) += 1;
#elif defined(FAULT_FAR_BELOW)
  target->front[(size_t)(scene->height + 2000) * target->stride + 100000] += 1;
#elif defined(FAULT_UNSTEADY)
  target->front[0] += (uint32_t)(calls % 2);
#elif defined(FAULT_PRINTS)
  printf("counts 1\nthis is no answer\n");
  fflush(stdout);
#elif defined(FAULT_ROUNDS)
  target->front[0] += fegetround() == FE_UPWARD;
  fesetround(FE_UPWARD);
#elif defined(FAULT_REFUSES)
  return scene->width > 0;
#endif
  (void)scene;
  (void)target;
  return 0;
}

#if !defined(FAULT_NO_SYMBOL)
const rasterproof_plugin* rasterproof_plugin_describe(void) {
#if defined(FAULT_AT_LOAD)
  abort();
#endif
  static const rasterproof_plugin plugin = {
#if defined(FAULT_VERSION)
      .version = 99,
#else
      .version = RASTERPROOF_PLUGIN_VERSION,
#endif
#if defined(FAULT_FIRST_SIZE)
      .size = offsetof(rasterproof_plugin, fixed_integer_bits), /* no fault: an older header's */
      .fixed_integer_bits = 99,
#else
      .size = sizeof(rasterproof_plugin),
#endif
      .name = "faulty",
#if defined(FAULT_PROFILE)
      .profile = "{\"snap\": {\"bits\": 99}}",
#else
      .profile = "gl",
#endif
#if defined(FAULT_FIXED_BITS)
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
