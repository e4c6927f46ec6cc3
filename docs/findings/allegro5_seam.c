/* Allegro 5, memory bitmap: two triangles on either side of an edge both cover a pixel, or
 * neither does.
 *
 *   cc allegro5_seam.c $(pkg-config --cflags --libs allegro-5 allegro_primitives-5) && ./a.out
 *
 * Prints how often each pixel of a 3 x 3 bitmap is covered: 1 is right.
 */
#include <allegro5/allegro.h>
#include <allegro5/allegro_primitives.h>
#include <stdio.h>
#include <string.h>

static void Draw(ALLEGRO_BITMAP* bitmap, const char* title, const float (*corners)[6]) {
  int counts[3][3] = {{0}};
  for (int t = 0; t < 2; ++t) {
    ALLEGRO_VERTEX v[3];
    memset(v, 0, sizeof v);
    for (int k = 0; k < 3; ++k) {
      v[k].x = corners[t][2 * k];
      v[k].y = corners[t][2 * k + 1];
      v[k].color = al_map_rgb(255, 255, 255);
    }
    al_clear_to_color(al_map_rgba(0, 0, 0, 0));
    al_draw_prim(v, NULL, NULL, 0, 3, ALLEGRO_PRIM_TRIANGLE_LIST);
    for (int k = 0; k < 9; ++k) counts[k / 3][k % 3] += al_get_pixel(bitmap, k % 3, k / 3).r > 0;
  }
  printf("%s:", title);
  for (int y = 0; y < 3; ++y) printf(" %d%d%d", counts[y][0], counts[y][1], counts[y][2]);
  printf("\n");
}

int main(void) {
  const float overlap[2][6] = {{-32, 1, -8, -8, 64, 64}, {-8, -8, 0, -4, 64, 64}};
  const float top[2] = {0x1.df7ap+2f, 0x1.2cb8p+10f};
  const float middle[2] = {0x1.277d8p-3f, -0x1.0e53p+8f};
  const float gap[2][6] = {{top[0], top[1], middle[0], middle[1], 0, -768},
                           {top[0], top[1], 0, 0, middle[0], middle[1]}};
  const unsigned version = al_get_allegro_version();
  printf("Allegro %u.%u.%u\n", version >> 24, version >> 16 & 255, version >> 8 & 255);
  if (!al_install_system(ALLEGRO_VERSION_INT, NULL) || !al_init_primitives_addon()) return 2;
  al_set_new_bitmap_flags(ALLEGRO_MEMORY_BITMAP);
  ALLEGRO_BITMAP* bitmap = al_create_bitmap(3, 3);
  al_set_target_bitmap(bitmap);
  Draw(bitmap, "overlap", overlap);
  Draw(bitmap, "gap", gap);
  return 0;
}
