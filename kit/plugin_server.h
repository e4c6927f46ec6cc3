/* Answers the requests of docs/subjects.md (version 1) with a plugin's calls, so that a program can
 * be a subject without being a shared library: kit/plugin_driver.c makes such a program of a
 * plugin's sources, kit/gtest.h of a test program.
 *
 * Of a plugin that shows fragments the ids alone are answered; edge values and batches are not
 * asked for. C99 and C++.
 */
#ifndef RASTERPROOF_KIT_PLUGIN_SERVER_H_
#define RASTERPROOF_KIT_PLUGIN_SERVER_H_

#include <locale.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/rasterproof_plugin.h"

static void* rasterproof_room(size_t count, size_t size) {
  void* const memory = calloc(count == 0 ? 1 : count, size);
  if (memory == NULL) {
    fputs("rasterproof: not enough memory\n", stderr);
    exit(1);
  }
  return memory;
}

static int rasterproof_shows_ids(const rasterproof_plugin* plugin) {
  return plugin->coverage >= RASTERPROOF_PRIMITIVE_IDS;
}

/* A text as one line. */
static void rasterproof_print_line(FILE* out, const char* key, const char* text) {
  fprintf(out, "%s ", key);
  for (; *text != '\0'; ++text) fputc(*text == '\n' || *text == '\r' ? ' ' : *text, out);
  fputc('\n', out);
}

/* Prints the lines of a description but `command`. */
static void rasterproof_describe(const rasterproof_plugin* plugin, FILE* out) {
  static const char* const coverages[] = {"facing-counts", "counts", "mask", "primitive-id",
                                          "primitive-id"};
  rasterproof_print_line(out, "name", plugin->name == NULL ? "plugin" : plugin->name);
  rasterproof_print_line(out, "profile", plugin->profile == NULL ? "real" : plugin->profile);
  fprintf(out, "coverage %s\n", coverages[plugin->coverage]);
  if (plugin->input == RASTERPROOF_FIXED) {
    fprintf(out, "input fixed %u.%u %s%s\n", (unsigned)plugin->fixed_integer_bits,
            (unsigned)plugin->fixed_fraction_bits, plugin->fixed_is_signed ? "signed" : "unsigned",
            plugin->fixed_wraps ? " wrap" : "");
  } else {
    fprintf(out, "input %s\n", plugin->input == RASTERPROOF_FLOAT64 ? "float64" : "float32");
  }
  if (rasterproof_shows_ids(plugin)) {
    fprintf(out, "visible %s\n",
            plugin->visible == RASTERPROOF_FIRST_DRAWN ? "first-drawn" : "last-drawn");
  }
  fprintf(out, "takes%s%s%s%s%s%s\n",
          plugin->takes & RASTERPROOF_TAKES_NO_WINDOW_SPACE ? "" : " window",
          plugin->takes & RASTERPROOF_TAKES_CLIP_SPACE ? " clip" : "",
          plugin->takes & RASTERPROOF_TAKES_CULLING ? " culling" : "",
          plugin->takes & RASTERPROOF_TAKES_SCISSOR ? " scissor" : "",
          plugin->takes & RASTERPROOF_TAKES_TILES ? " tiles" : "",
          plugin->takes & RASTERPROOF_TAKES_THREADS ? " threads" : "");
}

/* The options at the end of a request's line. */
static void rasterproof_take_option(rasterproof_scene* scene, const char* word) {
  if (strcmp(word, "cull=front") == 0) scene->cull = RASTERPROOF_CULL_FRONT;
  if (strcmp(word, "cull=back") == 0) scene->cull = RASTERPROOF_CULL_BACK;
  if (strncmp(word, "tile=", 5) == 0) scene->tile = atoi(word + 5);
  if (strncmp(word, "threads=", 8) == 0) scene->threads = atoi(word + 8);
  if (strncmp(word, "scissor=", 8) == 0) {
    int32_t* const s = scene->scissor;
    sscanf(word + 8, "%d,%d,%d,%d", (int*)&s[0], (int*)&s[1], (int*)&s[2], (int*)&s[3]);
  }
}

static void rasterproof_print_rows(const uint32_t* counts, int32_t height, size_t columns,
                                   FILE* out) {
  for (int32_t row = 0; row < height; ++row) {
    for (size_t k = 0; k < columns; ++k) fprintf(out, "%u ", (unsigned)*counts++);
    fputc('\n', out);
  }
}

/* Draws and answers request `id`. */
static void rasterproof_answer(const rasterproof_plugin* plugin, void* state, const char* id,
                               const rasterproof_scene* scene, int32_t samples, FILE* out) {
  const size_t columns = (size_t)scene->width * (size_t)samples;
  const size_t size = columns * (size_t)scene->height;
  const int fragments = plugin->coverage == RASTERPROOF_FRAGMENTS;
  rasterproof_target target;
  memset(&target, 0, sizeof target);
  target.size = sizeof target;
  target.samples = samples;
  target.stride = columns;
  if (rasterproof_shows_ids(plugin)) {
    target.primitive_ids = (int32_t*)rasterproof_room(size, sizeof(int32_t));
    for (size_t k = 0; k < size; ++k) target.primitive_ids[k] = -1;
  } else {
    target.front = (uint32_t*)rasterproof_room(size, sizeof(uint32_t));
  }
  if (plugin->coverage == RASTERPROOF_FACING_COUNTS) {
    target.back = (uint32_t*)rasterproof_room(size, sizeof(uint32_t));
  }
  if (fragments) {
    target.barycentrics = (double*)rasterproof_room(3 * size, sizeof(double));
    target.depths = (double*)rasterproof_room(size, sizeof(double));
    target.wants = RASTERPROOF_WANTS_BARYCENTRICS | RASTERPROOF_WANTS_DEPTHS;
  }
  if (plugin->reset != NULL) plugin->reset(state);
  const int32_t refused = plugin->draw(state, scene, &target);
  if (refused != 0) {
    fprintf(out, "refused %s draw returned %d\n", id, (int)refused);
  } else if (rasterproof_shows_ids(plugin)) {
    fprintf(out, "primitive-ids %s\n", id);
    for (size_t k = 0; k < size; ++k) {
      fprintf(out, "%d%c", (int)target.primitive_ids[k], (k + 1) % columns == 0 ? '\n' : ' ');
    }
  } else {
    fprintf(out, "counts %s\n", id);
    rasterproof_print_rows(target.front, scene->height, columns, out);
    if (target.back != NULL) rasterproof_print_rows(target.back, scene->height, columns, out);
  }
  fflush(out);
  free(target.front);
  free(target.back);
  free(target.primitive_ids);
  free(target.barycentrics);
  free(target.depths);
}

static void rasterproof_malformed(void) {
  fputs("rasterproof: malformed request on standard input\n", stderr);
  exit(1);
}

/* The number that a request has, whatever the program's locale writes in place of a point: a test
 * or a toolkit may have called setlocale(LC_ALL, ""). */
static double rasterproof_number(const char* word) {
  char local[600];
  const char* const point = localeconv()->decimal_point;
  const char* const at = strchr(word, '.');
  char* end = NULL;
  double number = 0;
  if (at == NULL || strcmp(point, ".") == 0 || strlen(word) + strlen(point) >= sizeof local) {
    number = strtod(word, &end);
  } else {
    const size_t whole = (size_t)(at - word);
    memcpy(local, word, whole);
    strcpy(local + whole, point);
    strcat(local, at + 1);
    number = strtod(local, &end);
  }
  if (*end != '\0') rasterproof_malformed();
  return number;
}

static double rasterproof_next_number(FILE* in) {
  char word[512];
  if (fscanf(in, "%511s", word) != 1) rasterproof_malformed();
  return rasterproof_number(word);
}

/* Reads one request and answers it; 0 at the end of the input. */
static int rasterproof_serve_one(const rasterproof_plugin* plugin, void* state, FILE* in,
                                 FILE* out) {
  static char line[4096];
  char id[32], space[16];
  int width = 0, height = 0, samples = 0, options = 0;
  unsigned long vertices = 0, triangles = 0;
  do {
    if (fgets(line, sizeof line, in) == NULL) return 0;
  } while (line[0] == '\n'); /* what is left of the last request's line */
  if (sscanf(line, "draw %31s %d %d %d %15s %lu %lu%n", id, &width, &height, &samples, space,
             &vertices, &triangles, &options) != 7) {
    rasterproof_malformed();
  }
  double* const places = (double*)rasterproof_room(4 * vertices, sizeof(double));
  int64_t* const fixed = (int64_t*)rasterproof_room(2 * vertices, sizeof(int64_t));
  int32_t* const indices = (int32_t*)rasterproof_room(3 * triangles, sizeof(int32_t));
  const double units = (double)(INT64_C(1) << (plugin->fixed_fraction_bits & 31));
  for (size_t k = 0; k < 4 * vertices; ++k) places[k] = rasterproof_next_number(in);
  for (size_t k = 0; k < 3 * triangles; ++k) indices[k] = (int32_t)rasterproof_next_number(in);
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
    rasterproof_take_option(&scene, word);
  }
  rasterproof_answer(plugin, state, id, &scene, samples, out);
  free(places);
  free(fixed);
  free(indices);
  return 1;
}

/* Answers all requests from `in` on `out`. */
static void rasterproof_serve(const rasterproof_plugin* plugin, FILE* in, FILE* out) {
  void* const state = plugin->open == NULL ? NULL : plugin->open();
  while (rasterproof_serve_one(plugin, state, in, out)) {
  }
  if (plugin->close != NULL) plugin->close(state);
}

#endif /* RASTERPROOF_KIT_PLUGIN_SERVER_H_ */
