// Bugs that only lists of more than 2^16 triangles show: ids, counts and offsets of few bits.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
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
  return {.drops =
              [triangle, bits](const Scene& scene, std::size_t number) {
                const std::size_t offset = CutTo(number * sizeof(Triangle), bits);
                *triangle = Corners(scene, scene.triangles[offset / sizeof(Triangle)]);
                return false;
              },
          .vertices = [triangle](std::array<Vertex, 3>& v) { v = *triangle; }};
}

}  // namespace

std::vector<Mutant> ListMutants() {
  return {
      {"list-ids-of-16-bits", "primitive ids keep 16 bits", "",
       ShowsIdsBy([](std::size_t number) { return CutTo(number, kListBits); })},
      {"list-ids-in-a-float", "primitive ids are kept in a float of 16 significant bits", "",
       ShowsIdsBy([](std::size_t number) { return InAFloat(number, kListBits); })},
      {"list-ids-in-a-colour", "primitive ids and none share the 16 bits of a colour, 5, 6 and 5",
       "", ShowsIdsBy([](std::size_t number) { return CutTo(number + 1, kListBits) - 1; })},
      {"list-ids-by-batches", "of 1000 triangles a batch, the number of the batch keeps 6 bits", "",
       ShowsIdsBy([](std::size_t number) {
         return CutTo(number / kInAListBatch, 6) * kInAListBatch + number % kInAListBatch;
       })},
      {"list-count-of-16-bits", "the number of triangles of a call keeps 16 bits", "",
       FixedStages{.drops =
                       [](const Scene& scene, std::size_t number) {
                         return number >= CutTo(scene.triangles.size(), kListBits);
                       }}},
      {"list-offsets-of-19-bits", "byte offsets of indices keep 19 bits", "", IndicesByOffsets(19)},
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

}  // namespace rasterproof::subjects::mutants
