// Draws one family once by one method: scripts/count_instructions counts its instructions.
//
//     count_instructions METHOD FAMILY
#include <algorithm>
#include <cstdio>
#include <string_view>

#include "bench/family.h"
#include "core/coverage.h"
#include "reference/method.h"
#include "reference/rasterize.h"

namespace rasterproof::bench {
namespace {

// Counted alone: a name that the tool finds.
__attribute__((noinline)) void Counted(const Scene& scene, const reference::Method& method,
                                       CoverageCounts& counts) {
  reference::Rasterize(scene, method, {}, counts);
}

int Run(std::string_view name, std::string_view family_name) {
  const auto kinds = FamilyKinds();
  const auto kind = std::ranges::find(kinds, family_name, &FamilyKind::name);
  const reference::Method* const method = reference::FindMethod(name);
  if (method == nullptr || kind == kinds.end()) {
    std::fputs("count_instructions: give METHOD and FAMILY as rasterproof bench names them\n",
               stderr);
    return 2;
  }
  const FamilyInput family = MakeFamily(*kind, FamilySize::kQuick, 1);
  if (!Takes(method->info, family.scene)) return 4;
  CoverageCounts counts(family.scene.width, family.scene.height);
  Counted(family.scene, *method, counts);
  std::printf("%zu\n", family.scene.triangles.size());
  return 0;
}

}  // namespace
}  // namespace rasterproof::bench

int main(int argc, char** argv) {
  if (argc != 3) return rasterproof::bench::Run("", "");
  return rasterproof::bench::Run(argv[1], argv[2]);
}
