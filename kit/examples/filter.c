/* Three culling filters, judged: what they drop covers no sample.
 *
 *     cc -std=c11 -O2 -shared -fPIC -I. kit/examples/filter.c -o lib.so -lm
 *     build/rasterproof check --plugin ./lib.so --property CoverageEqualsTheModel
 *
 * -DBUG=1: samples on the left and upper edge of the box are lost, as where
 *          round(min) == round(max) decides and halves are rounded up
 * -DBUG=2: the box is the one before vertices are snapped
 * -DBUG=3: the target is rejected by the corner that is nearest to the edge's outer side
 */
#include "kit/filter_plugin.h"

#ifndef BUG
#define BUG 0
#endif

/* A multiple of 1/256 pixel. */
static double snapped(double x) { return BUG == 2 ? x : nearbyint(x * 256) / 256; }

static double least(double a, double b, double c) { return fmin(a, fmin(b, c)); }
static double largest(double a, double b, double c) { return fmax(a, fmax(b, c)); }

/* Cull small: whether no pixel centre lies in [low, high]. */
static int holds_no_centre(double low, double high) {
  if (BUG == 1) return floor(low + 0.5) == floor(high + 0.5);
  return ceil(low - 0.5) > floor(high - 0.5);
}

static double edge(const double* a, const double* b, double x, double y) {
  return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
}

/* Reject a tile, here the target: whether it lies on the outer side of the edge a -> b of a
 * triangle of positive area. E grows with x where b lies below a: its largest value is there. */
static int is_beyond(const double* a, const double* b, int width, int height) {
  const int rightmost = (b[1] > a[1]) != (BUG == 3);
  const int lowest = (b[0] < a[0]) != (BUG == 3);
  return edge(a, b, rightmost ? width : 0, lowest ? height : 0) < 0;
}

static int keep(const double given[6], int width, int height) {
  double v[6];
  for (int k = 0; k < 6; ++k) v[k] = snapped(given[k]);
  for (int axis = 0; axis < 2; ++axis) {
    const double low = least(v[axis], v[axis + 2], v[axis + 4]);
    const double high = largest(v[axis], v[axis + 2], v[axis + 4]);
    if (holds_no_centre(low, high)) return 0;
  }
  const double area = edge(v, v + 2, v[4], v[5]);
  if (area == 0) return BUG == 2; /* no area, no sample: after snapping */
  for (int k = 0; k < 3; ++k) {
    const double* const a = v + 2 * k;
    const double* const b = v + 2 * ((k + 1) % 3);
    if (area > 0 ? is_beyond(a, b, width, height) : is_beyond(b, a, width, height)) return 0;
  }
  return 1;
}

RASTERPROOF_FILTER("filter", keep)
