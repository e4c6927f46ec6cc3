/* pixman: a triangle 32768 pixels wide or more covers nothing where it should, or where it should
 * not.
 *
 *   cc pixman_wide_triangle.c $(pkg-config --cflags --libs pixman-1) && ./a.out
 *
 * All coordinates are within pixman_fixed_t (-32768 up to 32767.99998). The triangle
 * (-28672, 0) (0, 4) (4096, 0) covers the pixels (0, 0) to (2, 2); 28671 covers them.
 */
#include <pixman.h>
#include <stdint.h>
#include <stdio.h>

static void Draw(int left) {
  uint32_t bits[3] = {0, 0, 0};
  pixman_image_t* image = pixman_image_create_bits(PIXMAN_a1, 3, 3, bits, 4);
  pixman_triangle_t triangle = {
      {pixman_int_to_fixed(left), 0}, {0, pixman_int_to_fixed(4)}, {pixman_int_to_fixed(4096), 0}};
  pixman_add_triangles(image, 0, 0, 1, &triangle);
  printf("(%d,0) (0,4) (4096,0): rows %x %x %x\n", left, bits[0] & 7, bits[1] & 7, bits[2] & 7);
  pixman_image_unref(image);
}

int main(void) {
  printf("pixman %s\n", pixman_version_string());
  Draw(-28671);
  Draw(-28672);
  return 0;
}
