/* Allegro 5, memory bitmap: the time that a triangle takes grows with what lies off the bitmap, and
 * a NaN takes minutes.
 *
 *   cc allegro5_offscreen_time.c $(pkg-config --cflags --libs allegro-5 allegro_primitives-5) &&
 *   ./a.out && ./a.out nan
 *
 * Prints the seconds for triangles that cover all of an 8 x 8 bitmap, or that have one NaN.
 */
#include <allegro5/allegro.h>
#include <allegro5/allegro_primitives.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static void Draw(float size, float first_y) {
  const float corners[3][2] = {{0, first_y}, {-size, size}, {size, size}};
  ALLEGRO_VERTEX v[3];
  memset(v, 0, sizeof v);
  for (int k = 0; k < 3; ++k) {
    v[k].x = corners[k][0];
    v[k].y = corners[k][1];
    v[k].color = al_map_rgb(255, 255, 255);
  }
  const double begun = al_get_time();
  al_draw_prim(v, NULL, NULL, 0, 3, ALLEGRO_PRIM_TRIANGLE_LIST);
  printf("size %g, first y %g: %.3f s\n", size, first_y, al_get_time() - begun);
}

int main(int argc, char** argv) {
  (void)argv;
  if (!al_install_system(ALLEGRO_VERSION_INT, NULL) || !al_init_primitives_addon()) return 2;
  al_set_new_bitmap_flags(ALLEGRO_MEMORY_BITMAP);
  al_set_target_bitmap(al_create_bitmap(8, 8));
  if (argc > 1) {
    Draw(8, NAN);
    return 0;
  }
  for (float size = 1e4f; size < 3e8f; size *= 10) Draw(size, -size);
  return 0;
}
