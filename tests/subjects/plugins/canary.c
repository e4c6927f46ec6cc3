/* A library that leaves a trace as soon as anybody loads it: the file that CANARY names. */
#include <stdio.h>
#include <stdlib.h>

__attribute__((constructor)) static void sing(void) {
  const char* path = getenv("CANARY");
  FILE* file = path != NULL ? fopen(path, "w") : NULL;
  if (file != NULL) fclose(file);
}
