// Draws one family once by one method: scripts/count_instructions counts its instructions.
//
//     count_instructions METHOD FAMILY
//
// Kernels and rivals draw a mask, by the widest vectors that there are (under callgrind: AVX2).
// Prints how many triangles were drawn, and how many rows of pixel centres their boxes meet.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>

#include "bench/family.h"
#include "core/coverage.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/method.h"
#include "reference/rasterize.h"

namespace rasterproof::bench {
namespace {

// Counted alone: a name that the tool finds.
__attribute__((noinline)) void Counted(const Scene& scene, const reference::Method& method,
                                       CoverageCounts& counts) {
  reference::Rasterize(scene, method, {}, counts);
}

__attribute__((noinline)) void Counted(const FamilyInput& family,
                                       const std::optional<library::rivals::Rival>& rival,
                                       library::kernels::Surface& surface) {
  const auto target = library::rivals::WidestTarget();
  if (rival) {
    Draw(*rival, target, family.KernelScene(), surface);
  } else {
    library::kernels::Draw(target, family.KernelScene(), surface);
  }
}

std::size_t RowsOf(const Scene& scene) {
  double rows = 0;
  for (const Triangle& t : scene.triangles) {
    const auto corners = Corners(scene, t);
    const auto row = [&](double y) {
      return std::clamp(std::ceil(y - 0.5), 0.0, static_cast<double>(scene.height));
    };
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    rows += row(bottom) - row(top);
  }
  return static_cast<std::size_t>(rows);
}

int Run(std::string_view name, std::string_view family_name) {
  const auto kinds = FamilyKinds();
  const auto kind = std::ranges::find(kinds, family_name, &FamilyKind::name);
  const reference::Method* const method = reference::FindMethod(name);
  const auto rival = library::rivals::FindRival(name);
  const bool is_vectors = rival || name == "kernel-exact";
  if ((method == nullptr && !is_vectors) || kind == kinds.end()) {
    std::fputs("count_instructions: give METHOD and FAMILY as rasterproof bench names them\n",
               stderr);
    return 2;
  }
  const FamilyInput family = MakeFamily(*kind, FamilySize::kQuick, 1);
  if (is_vectors) {
    if (!family.KernelsDrawIt()) return 4;
    library::kernels::Surface surface(library::kernels::Sink::kMask, family.scene.width,
                                      family.scene.height);
    Counted(family, rival, surface);
    std::printf("%zu %zu\n", family.scene.triangles.size(), RowsOf(family.scene));
    return 0;
  }
  if (!Takes(method->info, family.scene)) return 4;
  CoverageCounts counts(family.scene.width, family.scene.height);
  Counted(family.scene, *method, counts);
  const std::size_t rows = family.scene.clip_space ? 0 : RowsOf(family.scene);
  std::printf("%zu %zu\n", family.scene.triangles.size(), rows);
  return 0;
}

}  // namespace
}  // namespace rasterproof::bench

int main(int argc, char** argv) {
  if (argc != 3) return rasterproof::bench::Run("", "");
  return rasterproof::bench::Run(argv[1], argv[2]);
}
