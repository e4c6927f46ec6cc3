// The scenes of `bench --kernels`: what triangles are like decides what a kernel costs.
#ifndef RASTERPROOF_BENCH_KERNEL_SCENES_H_
#define RASTERPROOF_BENCH_KERNEL_SCENES_H_

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene.h"
#include "reference/kernels/kernel.h"

namespace rasterproof::bench {

/// A scene that owns its vertices.
struct KernelInput {
  std::string name;
  std::string summary;
  std::vector<reference::kernels::KernelVertex> vertices;
  std::vector<std::uint32_t> indices;
  int width = 1;
  int height = 1;

  reference::kernels::KernelScene View() const { return {vertices, indices, width, height}; }
  std::uint64_t triangles() const { return indices.size() / 3; }
};

/// A scene by name, made when it is asked for: the large ones take some 50 MB each.
struct KernelSceneKind {
  std::string_view name;
  std::string_view summary;
  KernelInput (*make)(int width, int height, std::uint64_t seed);
};

/// "tiny", "medium", "huge", "sliver", "partition", "torus", "tie-grid", "fan".
std::span<const KernelSceneKind> KernelSceneKinds();

/// A scene of the project's own as a kernel's: triangles in order, x, y and z.
///
/// Domain:     window space and float32; InputError otherwise.
KernelInput KernelInputFrom(const Scene& scene);

/// The scene as the rest of the project knows it.
Scene SceneFrom(const KernelInput& input);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_KERNEL_SCENES_H_
