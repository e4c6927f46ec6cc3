/* SDL 2, software renderer: a triangle of some 20000 pixels covers nothing.
 *
 *   cc sdl2_large_triangle.c $(pkg-config --cflags --libs sdl2) && ./a.out
 *
 * (-8192, 12288) (0, -14336) (12288, 12288) covers the whole target; so does the same at half the
 * size. 1 is right.
 */
#include <SDL.h>
#include <stdio.h>

static void Draw(SDL_Renderer* renderer, SDL_Surface* surface, float scale) {
  SDL_Vertex v[3] = {{{-8192 * scale, 12288 * scale}, {255, 255, 255, 255}, {0, 0}},
                     {{0, -14336 * scale}, {255, 255, 255, 255}, {0, 0}},
                     {{12288 * scale, 12288 * scale}, {255, 255, 255, 255}, {0, 0}}};
  SDL_FillRect(surface, NULL, 0);
  SDL_RenderGeometry(renderer, NULL, v, 3, NULL, 0);
  SDL_RenderFlush(renderer);
  printf("scale %g: %d\n", scale, *(Uint32*)surface->pixels != 0);
}

int main(void) {
  SDL_version version;
  SDL_GetVersion(&version);
  printf("SDL %d.%d.%d\n", version.major, version.minor, version.patch);
  SDL_Surface* surface = SDL_CreateRGBSurfaceWithFormat(0, 8, 8, 32, SDL_PIXELFORMAT_ARGB8888);
  SDL_Renderer* renderer = SDL_CreateSoftwareRenderer(surface);
  Draw(renderer, surface, 0.5f);
  Draw(renderer, surface, 1);
  return 0;
}
