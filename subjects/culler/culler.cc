// MaskedOcclusionCulling, a culler by masks, as a plugin: scripts/bench_others fetches it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

// It names size_t and includes nothing.
#include <MaskedOcclusionCulling.h>

#include "kit/rasterproof_plugin.h"

namespace {

constexpr auto kSet = MaskedOcclusionCulling::RASTERPROOF_CULLER_SET;

struct Destroy {
  void operator()(MaskedOcclusionCulling* culler) const { MaskedOcclusionCulling::Destroy(culler); }
};

struct Culler {
  std::unique_ptr<MaskedOcclusionCulling, Destroy> library{MaskedOcclusionCulling::Create(kSet)};
  std::vector<float> vertices;  // clip space, y up, w = 1
  std::vector<float> depths;    // of a target in whole tiles
};

// Returns whether all vertices lie on the target.
bool Gather(const rasterproof_scene& scene, float half_width, float half_height,
            std::vector<float>& vertices) {
  bool is_inside = true;
  vertices.clear();
  for (std::size_t k = 0; k < scene.vertex_count; ++k) {
    const float x = (static_cast<float>(scene.vertices[4 * k]) - half_width) / half_width;
    const float y = (half_height - static_cast<float>(scene.vertices[4 * k + 1])) / half_height;
    is_inside = is_inside && std::fabs(x) <= 1 && std::fabs(y) <= 1;
    vertices.insert(vertices.end(), {x, y, 0, 1});
  }
  return is_inside;
}

void* Open() {
  auto culler = std::make_unique<Culler>();
  const bool has_set = culler->library && culler->library->GetImplementation() == kSet;
  return has_set ? culler.release() : nullptr;
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  if (state == nullptr) return 1;
  auto& culler = *static_cast<Culler*>(state);
  const int width = (scene->width + 7) / 8 * 8;
  const int height = (scene->height + 3) / 4 * 4;
  unsigned known_width = 0, known_height = 0;
  culler.library->GetResolution(known_width, known_height);
  if (known_width != static_cast<unsigned>(width) ||
      known_height != static_cast<unsigned>(height)) {
    culler.library->SetResolution(static_cast<unsigned>(width), static_cast<unsigned>(height));
  }
  culler.library->ClearBuffer();
  const bool is_inside = Gather(*scene, static_cast<float>(width) / 2,
                                static_cast<float>(height) / 2, culler.vertices);
  if (scene->triangle_count != 0) {
    culler.library->RenderTriangles(
        culler.vertices.data(), reinterpret_cast<const unsigned*>(scene->triangles),
        static_cast<int>(scene->triangle_count), nullptr, MaskedOcclusionCulling::BACKFACE_NONE,
        is_inside ? MaskedOcclusionCulling::CLIP_PLANE_NONE
                  : MaskedOcclusionCulling::CLIP_PLANE_SIDES);
  }
  culler.depths.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  culler.library->ComputePixelDepthBuffer(culler.depths.data(), false);
  for (int y = 0; y < scene->height; ++y) {
    const float* const from = culler.depths.data() + static_cast<std::ptrdiff_t>(y) * width;
    std::uint32_t* const to = target->front + static_cast<std::size_t>(y) * target->stride;
    std::transform(from, from + scene->width, to, [](float d) { return d > 0.5F ? 1U : 0U; });
  }
  return 0;
}

void Close(void* state) { delete static_cast<Culler*>(state); }

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin described{};
    described.version = RASTERPROOF_PLUGIN_VERSION;
    described.size = sizeof(rasterproof_plugin);
    described.name = RASTERPROOF_CULLER_NAME;
    described.summary = "MaskedOcclusionCulling, masks of tiles with two layers of depth";
    described.profile = R"({"name": "culler", "contract": "none", "coordinate_limit": 16384})";
    described.input = RASTERPROOF_FLOAT32;
    described.coverage = RASTERPROOF_MASK;
    described.draw = Draw;
    described.open = Open;
    described.close = Close;
    return described;
  }();
  return &plugin;
}
