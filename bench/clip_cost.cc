// The kernel of clip space beside the exact kernel of window space, by turns: the same triangles
// with w = 1, with w of their own, divided by it first, and cut by the near plane.
//
// usage: clip_cost
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "bench/family.h"
#include "core/clock.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;

constexpr int kTimes = 11;
constexpr std::array<std::string_view, 4> kFamilies{"px5", "torus", "px100", "needles"};

struct ClipMesh {
  std::vector<kernels::ClipVertex> vertices;
  kernels::KernelScene window;

  kernels::ClipScene View(kernels::NearPlane near_plane) const {
    return {vertices, window.indices, window.width, window.height, near_plane};
  }
};

// Every vertex times a w between 1 and `most`, rounded to float32.
ClipMesh MeshOf(const kernels::KernelScene& window, float most) {
  std::mt19937 bits(1);
  ClipMesh mesh{{}, window};
  for (const kernels::KernelVertex& v : window.vertices) {
    const float w = 1 + (most - 1) * (static_cast<float>(bits() >> 8) * 0x1p-24F);
    mesh.vertices.push_back({v.x * w, v.y * w, v.z * w, w});
  }
  return mesh;
}

// The same with every other vertex before the near plane, which cuts most triangles then.
ClipMesh CutMesh(ClipMesh mesh) {
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    kernels::ClipVertex& v = mesh.vertices[k];
    v.z = k % 2 == 0 ? v.w : -v.w;
  }
  return mesh;
}

// Least ns a triangle of each, and the median ratio of the fourth one to the first.
struct Costs {
  std::array<double, 5> least{1e9, 1e9, 1e9, 1e9, 1e9};
  double ratio = 0;
};

Costs Measure(const kernels::KernelScene& window, kernels::Target target, kernels::Sink sink) {
  const ClipMesh flat = MeshOf(window, 1);
  const ClipMesh deep = MeshOf(window, 8);
  const ClipMesh cut = CutMesh(deep);
  kernels::Surface surface(sink, window.width, window.height);
  std::vector<kernels::KernelVertex> divided(window.vertices.size());
  Costs costs;
  std::array<double, kTimes> ratios{};
  for (double& ratio : ratios) {
    const auto time = [&](const auto& draw) {
      surface.Clear();
      return Timed(draw).wall_seconds;
    };
    const std::array seconds{
        time([&] { kernels::Draw(target, window, surface); }), time([&] {
          for (std::size_t k = 0; k < divided.size(); ++k) {
            const kernels::ClipVertex& v = deep.vertices[k];
            const float by = 1 / v.w;
            divided[k] = {v.x * by, v.y * by, v.z * by};
          }
          kernels::Draw(target, {divided, window.indices, window.width, window.height}, surface);
        }),
        time([&] { kernels::DrawClip(target, flat.View(kernels::NearPlane::kNone), surface); }),
        time([&] { kernels::DrawClip(target, deep.View(kernels::NearPlane::kNone), surface); }),
        time([&] { kernels::DrawClip(target, cut.View(kernels::NearPlane::kZero), surface); })};
    for (std::size_t k = 0; k < seconds.size(); ++k) {
      costs.least[k] = std::min(costs.least[k], seconds[k]);
    }
    ratio = seconds[3] / seconds[0];
  }
  std::ranges::sort(ratios);
  costs.ratio = ratios[kTimes / 2];
  return costs;
}

void PrintAll() {
  std::printf(
      "ns a triangle, least of %d; clip / window: median of pairs\n"
      "scene    set     sink    window  divided  clip, w = 1  clip, w to 8  cut  clip / window\n",
      kTimes);
  for (const FamilyKind& kind : FamilyKinds()) {
    if (std::ranges::find(kFamilies, kind.name) == kFamilies.end()) continue;
    const FamilyInput family = MakeFamily(kind, FamilySize::kFull, 1);
    for (const kernels::Target target : kernels::SupportedTargets()) {
      if (target == kernels::Target::kScalar || target == kernels::Target::kSse4) continue;
      for (const kernels::Sink sink :
           {kernels::Sink::kCount8, kernels::Sink::kMask, kernels::Sink::kDepth}) {
        const Costs c = Measure(family.KernelScene(), target, sink);
        const std::size_t triangles = family.indices.size() / 3;
        const double each = 1e9 / static_cast<double>(triangles);
        std::printf("%-8s %-7s %-7s %6.1f  %7.1f  %11.1f  %12.1f  %8.1f  %.2f\n",
                    family.name.c_str(), std::string(kernels::NameOf(target)).c_str(),
                    std::string(kernels::NameOf(sink)).c_str(), c.least[0] * each,
                    c.least[1] * each, c.least[2] * each, c.least[3] * each, c.least[4] * each,
                    c.ratio);
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::bench

int main() { rasterproof::bench::PrintAll(); }
