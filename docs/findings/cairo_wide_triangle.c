/* cairo without antialiasing: a triangle that is 2^23 pixels wide covers nothing.
 *
 *   cc cairo_wide_triangle.c $(pkg-config --cflags --libs cairo) && ./a.out
 *
 * cairo's coordinates are 24.8: from -8388608 up to 8388608. (LEFT, -1) (4194304, 4) (LEFT, 9)
 * covers the rows 2 to 5 of the target for either LEFT. Prints the pixels covered of each row.
 */
#include <cairo.h>
#include <stdio.h>
#include <string.h>

static void Draw(double left) {
  static unsigned char pixels[8][16];
  memset(pixels, 0, sizeof pixels);
  cairo_surface_t* surface =
      cairo_image_surface_create_for_data(&pixels[0][0], CAIRO_FORMAT_A8, 16, 8, 16);
  cairo_t* cr = cairo_create(surface);
  cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
  cairo_move_to(cr, left, -1);
  cairo_line_to(cr, 4194304, 4);
  cairo_line_to(cr, left, 9);
  cairo_close_path(cr);
  cairo_fill(cr);
  cairo_destroy(cr);
  cairo_surface_destroy(surface);
  printf("left %.0f:", left);
  for (int y = 0; y < 8; ++y) {
    int covered = 0;
    for (int x = 0; x < 16; ++x) covered += pixels[y][x] != 0;
    printf(" %d", covered);
  }
  printf("\n");
}

int main(void) {
  printf("cairo %s\n", cairo_version_string());
  Draw(-4194303);
  Draw(-4194304);
  return 0;
}
