/* Which triangle is under the cursor? A sphere as a buffer of ids, and as a picture.
 *
 *     picking sphere.ppm
 */
#include <math.h>
#include <stdio.h>

#include "library/rasterproof_rasterize.h"

#define WIDTH 320
#define HEIGHT 240
#define SLICES 48
#define STACKS 24

static float positions[3 * (SLICES + 1) * (STACKS + 1)];
static uint32_t indices[6 * SLICES * STACKS];
static uint32_t ids[WIDTH * HEIGHT];

static void make_vertices(void) {
  const double pi = 3.14159265358979323846;
  for (int j = 0; j <= STACKS; ++j) {
    for (int i = 0; i <= SLICES; ++i) {
      float* const v = positions + 3 * (j * (SLICES + 1) + i);
      const double around = 2 * pi * i / SLICES;
      const double down = pi * j / STACKS;
      const double y = cos(down), z = sin(down) * sin(around); /* then tilted towards the eye */
      v[0] = (float)(WIDTH / 2 + 100 * sin(down) * cos(around));
      v[1] = (float)(HEIGHT / 2 - 100 * (0.8 * y - 0.6 * z));
      v[2] = (float)(0.6 * y + 0.8 * z);
    }
  }
}

/* Adds a triangle if it turns to the eye: clockwise, with y down. */
static size_t add(size_t count, uint32_t a, uint32_t b, uint32_t c) {
  const float *p = positions + 3 * a, *q = positions + 3 * b, *r = positions + 3 * c;
  if ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) <= 0) return count;
  indices[3 * count] = a;
  indices[3 * count + 1] = b;
  indices[3 * count + 2] = c;
  return count + 1;
}

static size_t make_triangles(void) {
  size_t count = 0;
  for (uint32_t j = 0; j < STACKS; ++j) {
    for (uint32_t i = 0; i < SLICES; ++i) {
      const uint32_t a = j * (SLICES + 1) + i, b = a + SLICES + 1;
      count = add(count, a, a + 1, b + 1);
      count = add(count, a, b + 1, b);
    }
  }
  return count;
}

/* Writes each triangle in its own colour; black where there is none. */
static int write_picture(const char* path) {
  FILE* const file = fopen(path, "wb");
  if (file == NULL) return 0;
  fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
  for (size_t k = 0; k < WIDTH * HEIGHT; ++k) {
    const uint32_t mixed = (ids[k] + 1) * UINT32_C(2654435761);
    for (int channel = 0; channel < 3; ++channel) fputc((int)(mixed >> (8 * channel) & 255), file);
  }
  return fclose(file) == 0;
}

static void print_under(int x, int y) {
  const uint32_t id = ids[y * WIDTH + x];
  if (id == RASTERPROOF_RASTER_NO_TRIANGLE) {
    printf("pixel %d, %d: nothing\n", x, y);
  } else {
    printf("pixel %d, %d: triangle %u\n", x, y, (unsigned)id);
  }
}

int main(int argc, char** argv) {
  rasterproof_raster_target target = {.output = RASTERPROOF_RASTER_IDS,
                                      .width = WIDTH,
                                      .height = HEIGHT,
                                      .pitch = WIDTH * sizeof *ids,
                                      .memory = ids,
                                      .memory_size = sizeof ids};
  make_vertices();
  const rasterproof_raster_mesh sphere = {.positions = positions,
                                          .vertex_count = (SLICES + 1) * (STACKS + 1),
                                          .indices = indices,
                                          .triangle_count = make_triangles()};
  if (argc != 2) {
    fprintf(stderr, "usage: picking PICTURE.ppm\n");
    return 2;
  }
  if (rasterproof_raster_clear(&target) != RASTERPROOF_RASTER_OK ||
      rasterproof_rasterize(&sphere, &target, RASTERPROOF_RASTER_BEST) != RASTERPROOF_RASTER_OK) {
    fprintf(stderr, "%s\n", rasterproof_raster_message());
    return 1;
  }
  size_t covered = 0;
  for (size_t k = 0; k < WIDTH * HEIGHT; ++k) covered += ids[k] != RASTERPROOF_RASTER_NO_TRIANGLE;
  printf("%zu triangles cover %zu pixels\n", sphere.triangle_count, covered);
  print_under(WIDTH / 2, HEIGHT / 2);
  print_under(WIDTH / 2 + 60, HEIGHT / 2 - 40);
  print_under(5, 5);
  if (!write_picture(argv[1])) {
    fprintf(stderr, "%s: not written\n", argv[1]);
    return 1;
  }
  printf("wrote %s\n", argv[1]);
  return 0;
}
