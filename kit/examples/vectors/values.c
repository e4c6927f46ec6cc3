/* Judges an interpolator by vectors with values.
   rasterproof vectors generate --profile P --values --format c --out vectors.h
   cc -I. values.c -o values          -DAFFINE=1: affine for perspective, which is convicted */
#include <stdio.h>
#include <string.h>

#include "vectors.h"

static float number(int32_t bits) {
  float x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* Your interpolator: a channel of a triangle at a sample (x, y), in units of the lattice. */
#ifndef AFFINE
#define AFFINE 0
#endif
static double value_at(const int32_t* triangle, int channel, double x, double y) {
  double above = 0, below = 0;
  const int interpolation =
      vectors_channels[channel][0]; /* 0 flat, 1 linear, 2 perspective, 3 1/w */
  if (interpolation == 0) return number(vectors_numbers[triangle[0]][1 + channel]);
  for (int i = 0; i < 3; ++i) {
    const int32_t *a = vectors_vertices[triangle[(i + 1) % 3]],
                  *b = vectors_vertices[triangle[(i + 2) % 3]],
                  *numbers = vectors_numbers[triangle[i]];
    const double area = (x - a[0]) * ((double)b[1] - a[1]) - (y - a[1]) * ((double)b[0] - a[0]);
    const double over_w = area / number(numbers[0]);
    above += (interpolation == 1 || AFFINE ? area : over_w) * number(numbers[1 + channel]);
    below += interpolation == 2 && !AFFINE ? over_w : area;
  }
  return above / below;
}

int main(void) {
  long wrong = 0;
  for (int n = 0; n < VECTORS_VALUES; ++n) {
    const int32_t *v = vectors_values[n], *c = vectors_cases[v[0]];
    const int32_t* at = vectors_locations[c[3] + v[4]];
    const int is_centre = vectors_channels[v[5]][1] == 1;
    const double unit = (double)(1 << VECTORS_LATTICE_BITS) / 256;
    const double x = (256 * v[2] + (is_centre ? 128 : at[0])) * unit;
    const double y = (256 * v[3] + (is_centre ? 128 : at[1])) * unit;
    const float value = (float)value_at(vectors_triangles[v[1]], v[5], x, y);
    if (value >= number(v[7]) && value <= number(v[8])) continue;
    printf("%s column %d row %d channel %d: %a is not from %a to %a\n", vectors_names[v[0]], v[2],
           v[3], v[5], value, number(v[7]), number(v[8]));
    ++wrong;
  }
  printf("%ld of %d values are wrong\n", wrong, VECTORS_VALUES);
  return wrong != 0;
}
