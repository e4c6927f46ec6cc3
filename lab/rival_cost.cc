// The exact kernel, its rivals and a stranger's plugin side by side, into counts of either facing
// or a mask: nanoseconds a triangle, the least of interleaved draws.
//
//     rival_cost PLUGIN.so TARGET SINK ROUNDS FAMILY... (TARGET: avx2, avx512, ...)
#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "bench/family.h"
#include "core/clock.h"
#include "core/scene.h"
#include "kit/rasterproof_plugin.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"

namespace rasterproof::lab {
namespace {

using bench::FamilyInput;
using bench::FamilyKind;
using bench::FamilyKinds;
using bench::FamilySize;
namespace kernels = library::kernels;
namespace rivals = library::rivals;

using DrawCall = std::function<void()>;
struct Runner {
  std::string name;
  DrawCall draw;
  double least = std::numeric_limits<double>::infinity();
};

/// The plugin as it draws in its own process: vertices converted before.
class Plugin {
 public:
  explicit Plugin(const char* path) {
    void* const library = dlopen(path, RTLD_NOW);
    void* const describe =
        library == nullptr ? nullptr : dlsym(library, "rasterproof_plugin_describe");
    if (describe == nullptr) {
      std::fprintf(stderr, "rival_cost: %s\n", dlerror());
      std::exit(2);
    }
    plugin_ = reinterpret_cast<const rasterproof_plugin* (*)()>(describe)();
  }
  /// Into the surface's own memory, so that all draw into the same.
  DrawCall On(const FamilyInput& family, kernels::Surface& surface) {
    vertices_.clear();
    for (const kernels::KernelVertex& v : family.vertices) {
      vertices_.insert(vertices_.end(), {v.x, v.y, 0.0, 1.0});
    }
    indices_.assign(family.indices.begin(), family.indices.end());
    scene_ = {};
    scene_.size = sizeof scene_;
    scene_.width = family.scene.width;
    scene_.height = family.scene.height;
    scene_.vertices = vertices_.data();
    scene_.triangles = indices_.data();
    scene_.vertex_count = family.vertices.size();
    scene_.triangle_count = indices_.size() / 3;
    target_ = {};
    target_.size = sizeof target_;
    target_.samples = 1;
    target_.stride = static_cast<std::size_t>(surface.pitch());
    target_.front = reinterpret_cast<std::uint32_t*>(surface.plane(0));
    target_.back = reinterpret_cast<std::uint32_t*>(surface.plane(1));
    return [this] { plugin_->draw(nullptr, &scene_, &target_); };
  }

 private:
  const rasterproof_plugin* plugin_ = nullptr;
  std::vector<double> vertices_;
  std::vector<std::int32_t> indices_;
  rasterproof_scene scene_{};
  rasterproof_target target_{};
};

int Run(int argc, char** argv) {
  if (argc < 6) {
    std::fputs("rival_cost: give PLUGIN.so TARGET SINK ROUNDS FAMILY...\n", stderr);
    return 2;
  }
  Plugin plugin(argv[1]);
  const auto named = [](auto value) { return NameOf(value); };
  const auto target = *std::ranges::find(kernels::kTargets, std::string_view(argv[2]), named);
  const auto sink = *std::ranges::find(kernels::kSinks, std::string_view(argv[3]), named);
  for (int i = 5; i < argc; ++i) {
    const auto kinds = FamilyKinds();
    const auto kind = std::ranges::find(kinds, std::string_view(argv[i]), &FamilyKind::name);
    if (kind == kinds.end()) return 2;
    const FamilyInput family = bench::MakeFamily(*kind, FamilySize::kQuick, 1);
    const kernels::KernelScene scene = family.KernelScene();
    kernels::Surface surface(sink, scene.width, scene.height);
    std::vector<Runner> runners;
    runners.push_back({"kernel-exact", [&] { kernels::Draw(target, scene, surface); }});
    for (const rivals::Rival& rival : rivals::kRivals) {
      if (!Draws(rival, target, sink)) continue;
      runners.push_back({NameOf(rival), [&, rival] { Draw(rival, target, scene, surface); }});
    }
    if (sink == kernels::Sink::kFacing) runners.push_back({"plugin", plugin.On(family, surface)});
    for (int round = 0; round < std::atoi(argv[4]); ++round) {
      // Each begins a round in turn.
      std::ranges::rotate(runners, runners.begin() + 1);
      for (Runner& runner : runners) {
        runner.draw();
        runner.least = std::min(runner.least, Timed(runner.draw).seconds);
      }
    }
    std::ranges::sort(runners, {}, &Runner::least);
    const double exact = std::ranges::find(runners, "kernel-exact", &Runner::name)->least;
    const std::size_t triangles = scene.indices.size() / 3;
    const double nanoseconds = 1e9 / static_cast<double>(triangles);
    std::printf("%s (%zu triangles), %s, %s\n", argv[i], triangles, argv[2], argv[3]);
    for (const Runner& runner : runners) {
      std::printf("  %-20s %12.1f %8.2f\n", runner.name.c_str(), nanoseconds * runner.least,
                  runner.least / exact);
    }
  }
  return 0;
}

}  // namespace
}  // namespace rasterproof::lab

int main(int argc, char** argv) { return rasterproof::lab::Run(argc, argv); }
