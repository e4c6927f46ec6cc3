/* cairo without antialiasing: a triangle covers pixels beside it, in the row of a vertex.
 *
 *   cc cairo_beyond_vertex.c $(pkg-config --cflags --libs cairo) && ./a.out
 *
 * (3, 1.5) is the topmost corner of (3, 1.5) (4096, 8) (0, 4), and the centres of row 1 are at 1.5:
 * none of them is in the triangle. The second one, (0, -8) (3, 1.5) (0, 4), lies to the left of
 * their common edge. Prints how many cover each pixel, and those of the first one alone.
 */
#include <cairo.h>
#include <stdio.h>
#include <string.h>

static unsigned char first[8][64];
static unsigned char second[8][64];

static void Draw(unsigned char* pixels, const double* v) {
  cairo_surface_t* surface =
      cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_A8, 64, 8, 64);
  cairo_t* cr = cairo_create(surface);
  cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
  cairo_move_to(cr, v[0], v[1]);
  cairo_line_to(cr, v[2], v[3]);
  cairo_line_to(cr, v[4], v[5]);
  cairo_close_path(cr);
  cairo_fill(cr);
  cairo_destroy(cr);
  cairo_surface_destroy(surface);
}

int main(void) {
  const double right[6] = {3, 1.5, 4096, 8, 0, 4};
  const double left[6] = {0, -8, 3, 1.5, 0, 4};
  printf("cairo %s\n", cairo_version_string());
  Draw(&first[0][0], right);
  Draw(&second[0][0], left);
  for (int y = 0; y < 4; ++y) {
    printf("row %d: ", y);
    for (int x = 0; x < 16; ++x) printf("%d", (first[y][x] != 0) + (second[y][x] != 0));
    printf("   right one alone: ");
    for (int x = 0; x < 16; ++x) printf("%d", first[y][x] != 0);
    printf("\n");
  }
  return 0;
}
