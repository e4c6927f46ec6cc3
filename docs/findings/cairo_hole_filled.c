/* cairo without antialiasing: a hole that is one pixel wide is filled.
 *
 *   cc cairo_hole_filled.c $(pkg-config --cflags --libs cairo) && ./a.out
 *
 * A path of two triangles, one on either side of columns 3 to 3 + WIDTH - 1, whose inner sides are
 * upright. Prints a row of the path, and of the two triangles filled one after the other.
 */
#include <cairo.h>
#include <stdio.h>
#include <string.h>

static void Triangle(cairo_t* cr, double x, double apex) {
  cairo_move_to(cr, x, 0);
  cairo_line_to(cr, apex, 4);
  cairo_line_to(cr, x, 8);
  cairo_close_path(cr);
}

static void Draw(int width, int at_once) {
  static unsigned char pixels[8][16];
  memset(pixels, 0, sizeof pixels);
  cairo_surface_t* surface =
      cairo_image_surface_create_for_data(&pixels[0][0], CAIRO_FORMAT_A8, 16, 8, 16);
  cairo_t* cr = cairo_create(surface);
  cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
  Triangle(cr, 3, 0);
  if (!at_once) cairo_fill(cr);
  Triangle(cr, 3 + width, 12);
  cairo_fill(cr);
  cairo_destroy(cr);
  cairo_surface_destroy(surface);
  printf("hole of %d, %s: ", width, at_once ? "one path " : "two paths");
  for (int x = 0; x < 16; ++x) printf("%d", pixels[4][x] != 0);
  printf("\n");
}

int main(void) {
  printf("cairo %s\n", cairo_version_string());
  for (int width = 1; width <= 2; ++width) {
    Draw(width, 0);
    Draw(width, 1);
  }
  return 0;
}
