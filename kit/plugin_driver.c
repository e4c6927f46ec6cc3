/* A plugin's source as a program that answers the requests of docs/subjects.md (version 1) on a
 * pipe, for processors that only an emulator runs:
 *
 *     aarch64-linux-gnu-gcc -O2 -I. kit/plugin_driver.c kit/examples/plugin.c -o mine -lm
 *     qemu-aarch64 -L /usr/aarch64-linux-gnu ./mine --describe > mine.subject
 *
 * `--describe` prints the lines of a description but `command`. Of a library that shows fragments
 * the ids alone are answered; edge values and batches are not asked for.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

static void* room(size_t count, size_t size) {
  void* const memory = calloc(count == 0 ? 1 : count, size);
  if (memory == NULL) {
    fputs("plugin_driver: not enough memory\n", stderr);
    exit(1);
  }
  return memory;
}

static int shows_ids(const rasterproof_plugin* plugin) {
  return plugin->coverage >= RASTERPROOF_PRIMITIVE_IDS;
}

/* A text as one line. */
static void print_line(const char* key, const char* text) {
  printf("%s ", key);
  for (; *text != '\0'; ++text) putchar(*text == '\n' || *text == '\r' ? ' ' : *text);
  putchar('\n');
}

static void describe(const rasterproof_plugin* plugin) {
  static const char* const coverages[] = {"facing-counts", "counts", "mask", "primitive-id",
                                          "primitive-id"};
  print_line("name", plugin->name == NULL ? "plugin" : plugin->name);
  print_line("profile", plugin->profile == NULL ? "real" : plugin->profile);
  printf("coverage %s\n", coverages[plugin->coverage]);
  if (plugin->input == RASTERPROOF_FIXED) {
    printf("input fixed %u.%u %s%s\n", (unsigned)plugin->fixed_integer_bits,
           (unsigned)plugin->fixed_fraction_bits, plugin->fixed_is_signed ? "signed" : "unsigned",
           plugin->fixed_wraps ? " wrap" : "");
  } else {
    printf("input %s\n", plugin->input == RASTERPROOF_FLOAT64 ? "float64" : "float32");
  }
  if (shows_ids(plugin)) {
    printf("visible %s\n",
           plugin->visible == RASTERPROOF_FIRST_DRAWN ? "first-drawn" : "last-drawn");
  }
  printf("takes%s%s%s%s%s%s\n", plugin->takes & RASTERPROOF_TAKES_NO_WINDOW_SPACE ? "" : " window",
         plugin->takes & RASTERPROOF_TAKES_CLIP_SPACE ? " clip" : "",
         plugin->takes & RASTERPROOF_TAKES_CULLING ? " culling" : "",
         plugin->takes & RASTERPROOF_TAKES_SCISSOR ? " scissor" : "",
         plugin->takes & RASTERPROOF_TAKES_TILES ? " tiles" : "",
         plugin->takes & RASTERPROOF_TAKES_THREADS ? " threads" : "");
}

/* The options at the end of a request's line. */
static void take_option(rasterproof_scene* scene, const char* word) {
  if (strcmp(word, "cull=front") == 0) scene->cull = RASTERPROOF_CULL_FRONT;
  if (strcmp(word, "cull=back") == 0) scene->cull = RASTERPROOF_CULL_BACK;
  if (strncmp(word, "tile=", 5) == 0) scene->tile = atoi(word + 5);
  if (strncmp(word, "threads=", 8) == 0) scene->threads = atoi(word + 8);
  if (strncmp(word, "scissor=", 8) == 0) {
    int32_t* const s = scene->scissor;
    sscanf(word + 8, "%d,%d,%d,%d", (int*)&s[0], (int*)&s[1], (int*)&s[2], (int*)&s[3]);
  }
}

static void print_rows(const uint32_t* counts, int32_t height, size_t columns) {
  for (int32_t row = 0; row < height; ++row) {
    for (size_t k = 0; k < columns; ++k) printf("%u ", (unsigned)*counts++);
    putchar('\n');
  }
}

/* Draws and answers request `id`. */
static void answer(const rasterproof_plugin* plugin, void* state, const char* id,
                   const rasterproof_scene* scene, int32_t samples) {
  const size_t columns = (size_t)scene->width * (size_t)samples;
  const size_t size = columns * (size_t)scene->height;
  const int fragments = plugin->coverage == RASTERPROOF_FRAGMENTS;
  rasterproof_target target;
  memset(&target, 0, sizeof target);
  target.size = sizeof target;
  target.samples = samples;
  target.stride = columns;
  if (shows_ids(plugin)) {
    target.primitive_ids = (int32_t*)room(size, sizeof(int32_t));
    for (size_t k = 0; k < size; ++k) target.primitive_ids[k] = -1;
  } else {
    target.front = (uint32_t*)room(size, sizeof(uint32_t));
  }
  if (plugin->coverage == RASTERPROOF_FACING_COUNTS) {
    target.back = (uint32_t*)room(size, sizeof(uint32_t));
  }
  if (fragments) {
    target.barycentrics = (double*)room(3 * size, sizeof(double));
    target.depths = (double*)room(size, sizeof(double));
    target.wants = RASTERPROOF_WANTS_BARYCENTRICS | RASTERPROOF_WANTS_DEPTHS;
  }
  if (plugin->reset != NULL) plugin->reset(state);
  const int32_t refused = plugin->draw(state, scene, &target);
  if (refused != 0) {
    printf("refused %s draw returned %d\n", id, (int)refused);
  } else if (shows_ids(plugin)) {
    printf("primitive-ids %s\n", id);
    for (size_t k = 0; k < size; ++k) {
      printf("%d%c", (int)target.primitive_ids[k], (k + 1) % columns == 0 ? '\n' : ' ');
    }
  } else {
    printf("counts %s\n", id);
    print_rows(target.front, scene->height, columns);
    if (target.back != NULL) print_rows(target.back, scene->height, columns);
  }
  fflush(stdout);
  free(target.front);
  free(target.back);
  free(target.primitive_ids);
  free(target.barycentrics);
  free(target.depths);
}

static void malformed(void) {
  fputs("plugin_driver: not what a request looks like\n", stderr);
  exit(1);
}

static double next_number(void) {
  char word[512];
  if (scanf("%511s", word) != 1) malformed();
  return strtod(word, NULL);
}

/* Reads one request and answers it; 0 at the end of the input. */
static int serve(const rasterproof_plugin* plugin, void* state) {
  static char line[4096];
  char id[32], space[16];
  int width = 0, height = 0, samples = 0, options = 0;
  unsigned long vertices = 0, triangles = 0;
  do {
    if (fgets(line, sizeof line, stdin) == NULL) return 0;
  } while (line[0] == '\n'); /* what is left of the last request's line */
  if (sscanf(line, "draw %31s %d %d %d %15s %lu %lu%n", id, &width, &height, &samples, space,
             &vertices, &triangles, &options) != 7) {
    malformed();
  }
  double* const places = (double*)room(4 * vertices, sizeof(double));
  int64_t* const fixed = (int64_t*)room(2 * vertices, sizeof(int64_t));
  int32_t* const indices = (int32_t*)room(3 * triangles, sizeof(int32_t));
  const double units = (double)(INT64_C(1) << (plugin->fixed_fraction_bits & 31));
  for (size_t k = 0; k < 4 * vertices; ++k) places[k] = next_number();
  for (size_t k = 0; k < 3 * triangles; ++k) indices[k] = (int32_t)next_number();
  rasterproof_scene scene;
  memset(&scene, 0, sizeof scene);
  scene.size = sizeof scene;
  scene.width = width;
  scene.height = height;
  scene.clip_space = strcmp(space, "clip") == 0;
  scene.vertices = places;
  scene.triangles = indices;
  scene.vertex_count = vertices;
  scene.triangle_count = triangles;
  scene.scissor[2] = width;
  scene.scissor[3] = height;
  if (plugin->input == RASTERPROOF_FIXED) {
    for (size_t k = 0; k < 2 * vertices; ++k) {
      fixed[k] = (int64_t)(places[4 * (k / 2) + k % 2] * units);
    }
    scene.fixed = fixed;
  }
  for (char* word = strtok(line + options, " \r\n"); word != NULL; word = strtok(NULL, " \r\n")) {
    take_option(&scene, word);
  }
  answer(plugin, state, id, &scene, samples);
  free(places);
  free(fixed);
  free(indices);
  return 1;
}

int main(int argc, char** argv) {
  static rasterproof_plugin plugin; /* what an older description lacks is zero */
  const rasterproof_plugin* const described = rasterproof_plugin_describe();
  if (described == NULL || described->version != RASTERPROOF_PLUGIN_VERSION ||
      described->draw == NULL || described->coverage > RASTERPROOF_FRAGMENTS) {
    fputs("plugin_driver: the description has no draw, or is of another version\n", stderr);
    return 2;
  }
  memcpy(&plugin, described, described->size < sizeof plugin ? described->size : sizeof plugin);
  if (argc > 1 && strcmp(argv[1], "--describe") == 0) {
    describe(&plugin);
    return 0;
  }
  void* const state = plugin.open == NULL ? NULL : plugin.open();
  while (serve(&plugin, state)) {
  }
  if (plugin.close != NULL) plugin.close(state);
  return 0;
}
