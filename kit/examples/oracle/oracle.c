/* Checks one triangle of a rasterizer of yours, sample by sample, without the command:
 *
 *     cc -std=c99 oracle.c -lrasterproof_oracle -o oracle && ./oracle
 *
 * Prints each sample on which it contradicts what every legal Vulkan rasterizer does. */
#include <stdio.h>

#include "rasterproof/kit/rasterproof_oracle.h"

/* Yours. This one forgets to own the samples of left and top edges. */
static int covers(double x0, double y0, double x1, double y1, double x2, double y2, double x,
                  double y) {
  return (x - x0) * (y1 - y0) - (y - y0) * (x1 - x0) < 0 &&
         (x - x1) * (y2 - y1) - (y - y1) * (x2 - x1) < 0 &&
         (x - x2) * (y0 - y2) - (y - y2) * (x0 - x2) < 0;
}

int main(void) {
  enum { SIDE = 8 };
  int column, row, wrong = 0;
  rasterproof_oracle_profile* gl = NULL;
  if (rasterproof_oracle_open("gl-canonical", &gl) != RASTERPROOF_ORACLE_OK) {
    fprintf(stderr, "%s\n", rasterproof_oracle_message());
    return 2;
  }
  for (row = 0; row < SIDE; ++row) {
    for (column = 0; column < SIDE; ++column) {
      const int legal =
          rasterproof_oracle_covers(gl, SIDE, SIDE, 0.5, 0.5, 6.5, 0.5, 0.5, 6.5, column, row, 0);
      const int mine = covers(0.5, 0.5, 6.5, 0.5, 0.5, 6.5, column + 0.5, row + 0.5);
      if (legal < 0) {
        fprintf(stderr, "%s\n", rasterproof_oracle_message());
        return 2;
      }
      if (legal == RASTERPROOF_ORACLE_MAY || mine == legal) continue;
      printf("column %d row %d: %s, and must %scover it\n", column, row,
             mine ? "covered" : "not covered", legal ? "" : "not ");
      ++wrong;
    }
  }
  printf("%d of %d samples contradict it\n", wrong, SIDE * SIDE);
  rasterproof_oracle_close(gl);
  return wrong != 0;
}
