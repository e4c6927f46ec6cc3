/* Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.
   rasterproof vectors generate --profile P --format c --out vectors.h
   cc -I. reader.c -o reader          -DINCLUSIVE=1: a wrong tie rule, which is convicted */
#include <stdio.h>

#include "vectors.h"

static int drawn(int triangle, int x, int y); /* your rasterizer */

/* The reader: compare, say what contradicts. The columns of a table stand above it. */
static int bit(const uint64_t* row, int x) { return (int)(row[x / 64] >> (x % 64) & 1); }

static int judge_triangle(const int32_t* c, const char* name, int t) {
  int wrong = 0;
  for (int y = 0; y < c[1]; ++y) {
    for (int x = 0; x < c[0]; ++x) {
      const int row = vectors_triangles[t][4] + y, must = bit(vectors_must[row], x);
      if (drawn(t, x, y) == must || bit(vectors_may[row], x)) continue;
      printf("%s triangle %d column %d row %d: must%s be covered\n", name, t - c[5], x, y,
             must ? "" : " not");
      ++wrong;
    }
  }
  return wrong;
}

static int judge_joint(const int32_t* c, const char* name, const int32_t* joint) {
  int count = 0;
  for (int t = 0; t < c[6]; ++t)
    if (joint[3] >> t & 1) count += drawn(c[5] + t, joint[0], joint[1]);
  if (joint[4] >> count & 1) return 0;
  printf("%s column %d row %d: %d triangles cover it\n", name, joint[0], joint[1], count);
  return 1;
}

int main(void) {
  long wrong = 0;
  if (VECTORS_VERSION != 1 || VECTORS_LATTICE_BITS != 8 || VECTORS_Y_UP) return 2;
  for (int n = 0; n < VECTORS_CASES; ++n) {
    const int32_t* c = vectors_cases[n];
    for (int t = c[5]; t < c[5] + c[6]; ++t) wrong += judge_triangle(c, vectors_names[n], t);
    for (int j = c[7]; j < c[7] + c[8]; ++j)
      wrong += judge_joint(c, vectors_names[n], vectors_joints[j]);
  }
  if (wrong != 0) printf("%ld contradictions in %d cases\n", wrong, VECTORS_CASES);
  if (wrong == 0) printf("no contradiction in %d cases\n", VECTORS_CASES);
  return wrong != 0;
}

/* Your rasterizer in place of this one. All numbers in 1/256 pixel; the rule is top-left. */
#ifndef INCLUSIVE
#define INCLUSIVE 0
#endif

typedef __int128 wide; /* products of the largest coordinates have 66 bits */

static wide edge(const int32_t* a, const int32_t* b, wide x, wide y) {
  return (x - a[0]) * ((wide)b[1] - a[1]) - (y - a[1]) * ((wide)b[0] - a[0]);
}

static int covers(const int32_t* a, const int32_t* b, const int32_t* c, int x, int y) {
  const wide area = edge(a, b, c[0], c[1]);
  const int32_t* const ccw[4] = {a, area > 0 ? b : c, area > 0 ? c : b, a};
  for (int k = 0; k < 3; ++k) {
    const int32_t *p = ccw[k], *q = ccw[k + 1];
    const wide e = edge(p, q, x, y);
    const int owns = INCLUSIVE || q[1] > p[1] || (q[1] == p[1] && q[0] < p[0]);
    if (e < 0 || (e == 0 && !owns)) return 0;
  }
  return area != 0;
}

static int drawn(int triangle, int x, int y) {
  const int32_t* v = vectors_triangles[triangle];
  return covers(vectors_vertices[v[0]], vectors_vertices[v[1]], vectors_vertices[v[2]],
                256 * x + 128, 256 * y + 128);
}
