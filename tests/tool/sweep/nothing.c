/* States the model and draws nothing: all builds agree, and none is right. */
#define PROFILE "{\"name\": \"swept\", \"subpixel_bits\": 8, \"coordinate_limit\": 32768}"
#include "tests/tool/sweep/draws.h"

static int covers(const float v[3][2], float x, float y) {
  (void)v, (void)x, (void)y;
  return 0;
}
