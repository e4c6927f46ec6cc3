#include "reference/whole_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/float_environment.h"
#include "core/vertex.h"
#include "reference/box.h"

namespace rasterproof::reference {
namespace {

bool IsFloat32(double x) { return std::isnan(x) || static_cast<float>(x) == x; }

void AddPlane(const std::uint32_t* plane, std::ptrdiff_t pitch, const PixelRect& area, int width,
              std::uint32_t* counts) {
  for (int y = area.y0; y < area.y1; ++y) {
    const std::uint32_t* const from = plane + y * pitch;
    std::uint32_t* const to = counts + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = area.x0; x < area.x1; ++x) to[x] += from[x];
  }
}

std::vector<std::uint32_t> IndicesOf(const Scene& scene) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * scene.triangles.size());
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) indices.push_back(static_cast<std::uint32_t>(index));
  }
  return indices;
}

/// Adds what a surface of facings holds.
void AddSurface(library::kernels::Surface& surface, const Scene& scene, const DrawOptions& options,
                CoverageCounts& counts) {
  const PixelRect area = DrawArea(scene, options);
  const auto add = [&](int plane, std::vector<std::uint32_t>& to) {
    AddPlane(reinterpret_cast<const std::uint32_t*>(surface.plane(plane)), surface.pitch(), area,
             counts.width, to.data());
  };
  if (options.cull != Cull::kFront) add(0, counts.front);
  if (options.cull != Cull::kBack) add(1, counts.back);
}

}  // namespace

bool KernelsTake(const Scene& scene) {
  return !scene.clip_space && std::ranges::all_of(scene.vertices, [](const Vertex& v) {
    return IsFloat32(v.x) && IsFloat32(v.y);
  });
}

bool KernelsPay(const Scene& scene) {
  constexpr std::size_t kFewest = 64;
  constexpr std::size_t kPixelsATriangle = 256;
  const auto pixels =
      static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  return scene.triangles.size() >= std::max(kFewest, pixels / kPixelsATriangle);
}

namespace {

/// Draws into a surface of facings by draw(kernel scene, surface) and adds what it holds.
template <class Drawing>
void DrawAndAdd(const Scene& scene, const DrawOptions& options, CoverageCounts& counts,
                const Drawing& draw) {
  std::vector<library::kernels::KernelVertex> vertices;
  vertices.reserve(scene.vertices.size());
  for (const Vertex& v : scene.vertices) {
    vertices.push_back({static_cast<float>(v.x), static_cast<float>(v.y), 0});
  }
  const std::vector<std::uint32_t> indices = IndicesOf(scene);
  library::kernels::Surface surface(library::kernels::Sink::kFacing, scene.width, scene.height);
  draw(library::kernels::KernelScene{vertices, indices, scene.width, scene.height}, surface);
  AddSurface(surface, scene, options, counts);
}

}  // namespace

void DrawByKernel(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  DrawAndAdd(scene, options, counts, [&](const auto& kernel_scene, auto& surface) {
    library::kernels::Draw(library::kernels::SupportedTargets().back(), kernel_scene, surface);
  });
}

void DrawByRival(const library::rivals::Rival& rival, const Scene& scene,
                 const DrawOptions& options, CoverageCounts& counts) {
  std::optional<FloatEnvironment> sane;  // its vertices are rounded to the grid
  if (Snaps(rival.arithmetic)) sane.emplace();
  DrawAndAdd(scene, options, counts, [&](const auto& kernel_scene, auto& surface) {
    Draw(rival, library::rivals::WidestTarget(), kernel_scene, surface);
  });
}

bool ClipKernelTakes(const Scene& scene) {
  return scene.clip_space && std::ranges::all_of(scene.vertices, [](const Vertex& v) {
           return IsFloat32(v.x) && IsFloat32(v.y) && IsFloat32(v.w);
         });
}

void DrawByClipKernel(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  std::vector<library::kernels::ClipVertex> vertices;
  vertices.reserve(scene.vertices.size());
  for (const Vertex& v : scene.vertices) {
    vertices.push_back(
        {static_cast<float>(v.x), static_cast<float>(v.y), 0, static_cast<float>(v.w)});
  }
  const std::vector<std::uint32_t> indices = IndicesOf(scene);
  library::kernels::Surface surface(library::kernels::Sink::kFacing, scene.width, scene.height);
  library::kernels::DrawClip(library::kernels::SupportedTargets().back(),
                             {vertices, indices, scene.width, scene.height}, surface);
  AddSurface(surface, scene, options, counts);
}

}  // namespace rasterproof::reference
