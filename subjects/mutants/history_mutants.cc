// Bugs in what is left of a scene when the next one comes, under the legal sets of APIs.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/scene.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::size_t kMany = 100;

bool IsAllFinite(const Scene& scene) { return std::ranges::all_of(scene.vertices, IsFinite); }

bool HasFlatTriangle(const Scene& scene) {
  return std::ranges::any_of(scene.triangles, [&](const Triangle& t) {
    const auto v = Corners(scene, t);
    return (v[2].x - v[0].x) * (v[1].y - v[0].y) == (v[2].y - v[0].y) * (v[1].x - v[0].x);
  });
}

bool LiesFarOff(const Scene& scene) {
  return IsAllFinite(scene) && std::ranges::any_of(scene.vertices, [](const Vertex& v) {
           return std::fabs(v.x) > 0x1p30 || std::fabs(v.y) > 0x1p30;
         });
}

// After a scene that leaves a trace, the next one loses its first triangle.
FixedStages LosingTheFirstAfter(std::string_view preset,
                                std::function<bool(const Scene&)> leaves_a_trace) {
  FixedStages stages = StagesOfPreset(preset);
  stages.drops = [leaves_a_trace = std::move(leaves_a_trace), trace = false](
                     const Scene& scene, std::size_t number) mutable {
    return number == 0 && std::exchange(trace, leaves_a_trace(scene));
  };
  return stages;
}

// Refuses scenes that are not finite; with a trace, the one after them loses its first triangle.
FixedStages Refusing(std::string_view preset, bool leaves_a_trace) {
  FixedStages stages = StagesOfPreset(preset);
  stages.drops = [leaves_a_trace, trace = false](const Scene& scene, std::size_t number) mutable {
    if (number != 0) return false;
    const bool is_lost = std::exchange(trace, leaves_a_trace && !IsAllFinite(scene));
    if (!IsAllFinite(scene)) throw SubjectStop(Stop::kRefused, "a vertex is not finite");
    return is_lost;
  };
  return stages;
}

// Images are kept, and found again by the size, the indices and the first triangle.
FixedStages KeepingByTheFirst(std::string_view preset) {
  FixedStages stages = StagesOfPreset(preset);
  stages.kept_by = [](const Scene& scene) {
    std::vector<std::int64_t> key;
    const auto word = [](double x) {
      return std::isnan(x) ? 0 : static_cast<std::int64_t>(std::clamp(x, -0x1p30, 0x1p30) * 0x1p30);
    };
    for (const Triangle& t : scene.triangles) key.insert(key.end(), t.begin(), t.end());
    if (scene.triangles.empty()) return key;
    for (const Vertex& v : Corners(scene, scene.triangles.front())) {
      key.insert(key.end(), {word(v.x), word(v.y)});
    }
    return key;
  };
  return stages;
}

std::vector<Mutant> HistoryVariants() {
  return {
      {"vulkan-refuses-non-finite", "scenes with a NaN or an infinity are refused", "",
       Refusing("vulkan", false)},
      {"gl-refuses-non-finite", "scenes with a NaN or an infinity are refused", "",
       Refusing("gl", false)},
  };
}

std::vector<Mutant> HistoryMutants() {
  return {
      {"vulkan-trace-of-non-finite", "the scene after one that is not finite loses a triangle", "",
       LosingTheFirstAfter("vulkan", [](const Scene& s) { return !IsAllFinite(s); }), "",
       "PredecessorsKeepCoverage"},
      {"gl-trace-of-refusal", "the scene after one that was refused loses a triangle", "",
       Refusing("gl", true), "", "PredecessorsKeepCoverage"},
      {"vulkan-trace-of-flat", "the scene after one with a flat triangle loses a triangle", "",
       LosingTheFirstAfter("vulkan", HasFlatTriangle), "", "PredecessorsKeepCoverage"},
      {"d3d11-trace-of-far", "the scene after one with coordinates over 2^30 loses a triangle", "",
       LosingTheFirstAfter("d3d11", LiesFarOff), "", "PredecessorsKeepCoverage"},
      {"gl-trace-of-many", "the scene after one of 100 triangles loses a triangle", "",
       LosingTheFirstAfter("gl", [](const Scene& s) { return s.triangles.size() >= kMany; }), "",
       "PredecessorsKeepCoverage"},
      {"vulkan-kept-by-first", "images are found again by size, indices and the first triangle", "",
       KeepingByTheFirst("vulkan"), "earlier-draws",
       "NewVerticesGiveNewCoverage|EarlierScenesLeaveNoTrace"},
      {"gl-kept-by-first", "images are found again by size, indices and the first triangle", "",
       KeepingByTheFirst("gl"), "earlier-draws", "NewVerticesGiveNewCoverage"},
  };
}

}  // namespace

extern constinit const MutantTable kHistoryVariants{MutantKind::kLegal, 12, HistoryVariants};
extern constinit const MutantTable kHistoryMutants{MutantKind::kPlanted, 20, HistoryMutants};

}  // namespace rasterproof::subjects::mutants
