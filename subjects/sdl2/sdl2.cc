// SDL 2's software renderer. The build makes two: one call a triangle, and one call a scene.
#include <SDL.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "kit/rasterproof_plugin.h"

namespace {

constexpr bool kBatch = RASTERPROOF_SDL2_BATCH;
constexpr std::size_t kMostInBatch = 255;  // counts are added up in eight bits
constexpr double kLimit = 0x1p30;
constexpr int kMaxSide = 16384;

struct Destroy {
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
  void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
};

struct Canvas {
  std::unique_ptr<SDL_Surface, Destroy> surface;
  std::unique_ptr<SDL_Renderer, Destroy> renderer;
  std::vector<SDL_Vertex> vertices;
};

bool Resize(Canvas& canvas, int width, int height) {
  const SDL_Surface* const old = canvas.surface.get();
  if (old != nullptr && old->w == width && old->h == height) return true;
  canvas.renderer.reset();
  canvas.surface.reset(
      SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888));
  if (canvas.surface == nullptr) return false;
  canvas.renderer.reset(SDL_CreateSoftwareRenderer(canvas.surface.get()));
  if (canvas.renderer == nullptr) return false;
  SDL_SetRenderDrawBlendMode(canvas.renderer.get(), SDL_BLENDMODE_ADD);
  return true;
}

bool Gather(const rasterproof_scene& scene, std::vector<SDL_Vertex>& vertices) {
  vertices.clear();
  for (std::size_t k = 0; k < 3 * scene.triangle_count; ++k) {
    const double* const v = scene.vertices + 4 * static_cast<std::size_t>(scene.triangles[k]);
    if (!(v[0] >= -kLimit && v[0] <= kLimit && v[1] >= -kLimit && v[1] <= kLimit)) return false;
    SDL_Vertex vertex{};
    vertex.position = {static_cast<float>(v[0]), static_cast<float>(v[1])};
    vertex.color = {0, 0, 1, 255};
    vertices.push_back(vertex);
  }
  return true;
}

bool DrawSome(Canvas& canvas, const SDL_Vertex* first, std::size_t triangles,
              const rasterproof_target& target) {
  SDL_Surface& surface = *canvas.surface;
  const auto width = static_cast<std::size_t>(surface.w);
  for (int y = 0; y < surface.h; ++y) {
    std::fill_n(static_cast<std::uint8_t*>(surface.pixels) + y * surface.pitch, 4 * width,
                std::uint8_t{0});
  }
  if (SDL_RenderGeometry(canvas.renderer.get(), nullptr, first, static_cast<int>(3 * triangles),
                         nullptr, 0) != 0 ||
      SDL_RenderFlush(canvas.renderer.get()) != 0) {
    return false;
  }
  for (int y = 0; y < surface.h; ++y) {
    const auto* const pixels = reinterpret_cast<const std::uint32_t*>(
        static_cast<const std::uint8_t*>(surface.pixels) + y * surface.pitch);
    std::uint32_t* const counts = target.front + static_cast<std::size_t>(y) * target.stride;
    for (std::size_t x = 0; x < width; ++x) counts[x] += pixels[x] & 0xffU;
  }
  return true;
}

void* Open() { return std::make_unique<Canvas>().release(); }

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  Canvas& canvas = *static_cast<Canvas*>(state);
  if (scene->width > kMaxSide || scene->height > kMaxSide) return 1;
  if (!Resize(canvas, scene->width, scene->height) || !Gather(*scene, canvas.vertices)) return 1;
  const std::size_t at_once = kBatch ? kMostInBatch : 1;
  for (std::size_t t = 0; t < scene->triangle_count; t += at_once) {
    const std::size_t some = std::min(at_once, scene->triangle_count - t);
    if (!DrawSome(canvas, canvas.vertices.data() + 3 * t, some, *target)) return 1;
  }
  return 0;
}

void Close(void* state) { delete static_cast<Canvas*>(state); }

// SDL_RenderGeometry's documentation says nothing of which pixels a triangle covers; that a mesh of
// sprites or of a user interface has no seams is what its users rely on.
constexpr const char* kProfile = R"({"name": "sdl2", "subpixel_bits": 0,
  "snap_rule": "truncate", "contract": "watertight", "coordinate_limit": 16384})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin described{};
    described.version = RASTERPROOF_PLUGIN_VERSION;
    described.size = sizeof(rasterproof_plugin);
    described.name = kBatch ? "sdl2-batch" : "sdl2";
    described.summary = "SDL_RenderGeometry of the software renderer, additive blending";
    described.profile = kProfile;
    described.input = RASTERPROOF_FLOAT32;
    described.coverage = RASTERPROOF_COUNTS;
    described.draw = Draw;
    described.open = Open;
    described.close = Close;
    return described;
  }();
  return &plugin;
}
