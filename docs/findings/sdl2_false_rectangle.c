/* SDL 2, software renderer: two triangles of a mesh that are drawn at once are taken for a
 * rectangle. Pixels are missing then, and others are covered that neither triangle covers.
 *
 *   cc sdl2_false_rectangle.c $(pkg-config --cflags --libs sdl2) && ./a.out
 *
 * (6, 2) (0, -1) (0, 2) and (6, 8) (0, 2) (6, 2) share the edge from (0, 2) to (6, 2). Prints the
 * pixels of the triangles drawn one after the other, and at once, row by row.
 */
#include <SDL.h>
#include <stdio.h>

static const SDL_Vertex kVertices[6] = {
    {{6, 2}, {255, 255, 255, 255}, {0, 0}}, {{0, -1}, {255, 255, 255, 255}, {0, 0}},
    {{0, 2}, {255, 255, 255, 255}, {0, 0}}, {{6, 8}, {255, 255, 255, 255}, {0, 0}},
    {{0, 2}, {255, 255, 255, 255}, {0, 0}}, {{6, 2}, {255, 255, 255, 255}, {0, 0}}};

static void Print(const char* title, SDL_Renderer* renderer, SDL_Surface* surface) {
  SDL_RenderFlush(renderer);
  printf("%s:", title);
  for (int y = 0; y < 8; ++y) {
    const Uint32* row = (const Uint32*)((const char*)surface->pixels + y * surface->pitch);
    printf(" ");
    for (int x = 0; x < 6; ++x) printf("%d", row[x] != 0);
  }
  printf("\n");
  SDL_FillRect(surface, NULL, 0);
}

int main(void) {
  SDL_version version;
  SDL_GetVersion(&version);
  printf("SDL %d.%d.%d\n", version.major, version.minor, version.patch);
  SDL_Surface* surface = SDL_CreateRGBSurfaceWithFormat(0, 6, 8, 32, SDL_PIXELFORMAT_ARGB8888);
  SDL_Renderer* renderer = SDL_CreateSoftwareRenderer(surface);
  SDL_RenderGeometry(renderer, NULL, kVertices, 3, NULL, 0);
  SDL_RenderGeometry(renderer, NULL, kVertices + 3, 3, NULL, 0);
  Print("one after the other", renderer, surface);
  SDL_RenderGeometry(renderer, NULL, kVertices, 6, NULL, 0);
  Print("at once", renderer, surface);
  return 0;
}
