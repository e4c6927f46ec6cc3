// Bugs of numbers of few bits: ids, counts and offsets, which lists of more than 2^16 triangles
// show, and indices.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "subjects/mutants/list_numbers.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr int kListBits = 16;
constexpr std::size_t kInAListBatch = 1000;

// The last triangle of a sample, with the id that the function makes of its number.
FreeStages ShowsIdsBy(std::size_t (*id)(std::size_t number)) {
  return {.profile = FixedPointProfile(),
          .coverage = CoverageKind::kPrimitiveIds,
          .id = [id](std::size_t number, std::size_t) { return id(number); }};
}

// Triangles whose indices lie at byte offsets of few bits.
FixedStages IndicesByOffsets(int bits) {
  const auto triangle = std::make_shared<std::array<Vertex, 3>>();
  return {{.drops =
               [triangle, bits](const Scene& scene, std::size_t number) {
                 const std::size_t offset = CutTo(number * sizeof(Triangle), bits);
                 *triangle = Corners(scene, scene.triangles[offset / sizeof(Triangle)]);
                 return false;
               },
           .vertices = [triangle](std::array<Vertex, 3>& v) { v = *triangle; }}};
}

// The triangle that is drawn. It is thread-local because the stages of all subjects made of one row
// are copies.
thread_local std::array<Vertex, 3> found_triangle;

// Vertices that are found again by these bits of their index, and by x where `by_x` says so.
FixedStages FindingVerticesBy(std::string_view preset, int bits, bool by_x) {
  FixedStages stages = StagesOfPreset(preset);
  using Key = std::pair<std::size_t, double>;
  stages.drops = [bits, by_x, kept = std::map<Key, Vertex>()](const Scene& scene,
                                                              std::size_t number) mutable {
    if (number == 0) kept.clear();
    found_triangle = Corners(scene, scene.triangles[number]);
    if (!std::ranges::all_of(found_triangle, IsFinite)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = static_cast<std::size_t>(scene.triangles[number][k]);
      Vertex& v = found_triangle[k];
      v = kept.try_emplace(Key{CutTo(index, bits), by_x ? v.x : 0}, v).first->second;
    }
    return false;
  };
  stages.vertices = [](std::array<Vertex, 3>& v) { v = found_triangle; };
  return stages;
}

std::vector<Mutant> ListMutants() {
  return {
      {"list-ids-of-16-bits", "primitive ids keep 16 bits", "",
       ShowsIdsBy([](std::size_t number) { return CutTo(number, kListBits); }), "list",
       "LongListDrawsLikeItsEnd"},
      {"list-ids-in-a-float", "primitive ids are kept in a float of 16 significant bits", "",
       ShowsIdsBy([](std::size_t number) { return InAFloat(number, kListBits); }), "list",
       "LongListDrawsLikeItsEnd"},
      {"list-ids-in-a-colour", "primitive ids and none share the 16 bits of a colour, 5, 6 and 5",
       "", ShowsIdsBy([](std::size_t number) { return CutTo(number + 1, kListBits) - 1; }), "list",
       "LongListDrawsLikeItsEnd"},
      {"list-ids-by-batches", "of 1000 triangles a batch, the number of the batch keeps 6 bits", "",
       ShowsIdsBy([](std::size_t number) {
         return CutTo(number / kInAListBatch, 6) * kInAListBatch + number % kInAListBatch;
       }),
       "list", "LongListDrawsLikeItsEnd"},
      {"list-count-of-16-bits", "the number of triangles of a call keeps 16 bits", "",
       FixedStages{{.drops =
                        [](const Scene& scene, std::size_t number) {
                          return number >= CutTo(scene.triangles.size(), kListBits);
                        }}},
       "list", "LongListDrawsLikeItsEnd"},
      {"list-offsets-of-19-bits", "byte offsets of indices keep 19 bits", "", IndicesByOffsets(19),
       "list", "LongListDrawsLikeItsEnd"},
      {"vulkan-vertices-by-16-bits", "vertices are found again by 16 bits of their index", "",
       FindingVerticesBy("vulkan", 16, false), "", "OneLegalModelExplainsTheMesh"},
      {"gl-vertices-by-8-bits-and-x", "vertices are found again by 8 bits of their index and x", "",
       FindingVerticesBy("gl", 8, true), "", "OneLegalModelExplainsTheMesh"},
  };
}

std::vector<Mutant> ListVariants() {
  return {
      {"list-ids-by-batches", "primitive ids by batches of 1000 triangles, numbered on", "",
       ShowsIdsBy([](std::size_t number) {
         return number / kInAListBatch * kInAListBatch + number % kInAListBatch;
       })},
  };
}

}  // namespace

extern constinit const MutantTable kListMutants{MutantKind::kPlanted, 26, ListMutants};
extern constinit const MutantTable kListVariants{MutantKind::kLegal, 17, ListVariants};

}  // namespace rasterproof::subjects::mutants
