/* GD: gdImageFilledPolygon covers nothing of an image that lies inside a large triangle.
 *
 *   cc gd_large_triangle.c $(pkg-config --cflags --libs gdlib) && ./a.out
 *
 * The triangle (0, -64) (RIGHT, 4) (0, 4) contains the 4 x 4 image. Prints how many of its 16
 * pixels are filled.
 */
#include <gd.h>
#include <stdio.h>

static void Draw(int right) {
  gdImagePtr image = gdImageCreate(4, 4);
  int filled = 0;
  gdImageColorAllocate(image, 0, 0, 0);
  const int white = gdImageColorAllocate(image, 255, 255, 255);
  gdPoint corners[3] = {{0, -64}, {right, 4}, {0, 4}};
  gdImageFilledPolygon(image, corners, 3, white);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) filled += gdImageGetPixel(image, x, y) == white;
  }
  printf("right %d: %d\n", right, filled);
  gdImageDestroy(image);
}

int main(void) {
  printf("GD %s\n", gdVersionString());
  Draw(1 << 20);
  Draw(1 << 25);
  Draw(1 << 26);
  return 0;
}
