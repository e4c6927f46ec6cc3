/* Integers after the snap, which no flag changes; but one build never ends. */
#include "tests/tool/sweep/robust.c"

#ifdef __FAST_MATH__
__attribute__((constructor)) static void hang(void) {
  for (volatile int turns = 0;;) ++turns;
}
#endif
