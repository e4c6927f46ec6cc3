#include "props/judging/mesh/planar_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "legal/owners.h"
#include "props/judging/as_shown.h"
#include "props/judging/mesh/mesh_freedom.h"
#include "props/judging/mesh/mesh_model.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// The mesh to judge, its open parts, its winding numbers and its shared ties.
struct JudgedMesh {
  PlacedCase c;
  OpenParts open;
  std::vector<std::int64_t> winding;
  SharedTies ties;
  std::uint64_t in_gaps;
};

// Samples outside that no path over neighbours outside joins to the target's border, neighbours of
// one position in the pixel being next to each other in a row or a column.
std::uint64_t SamplesInGaps(const PlacedCase& c, const std::vector<std::int64_t>& winding) {
  const CoverageCounts shape(c.scene.width, c.scene.height, c.profile.pattern.samples());
  std::vector<bool> reached(winding.size());
  std::vector<std::array<int, 3>> next;
  const auto reach = [&](int x, int row, int s) {
    if (x < 0 || row < 0 || x >= shape.width || row >= shape.height) return;
    const std::size_t k = shape.Index(x, row, s);
    if (winding[k] != 0 || reached[k]) return;
    reached[k] = true;
    next.push_back({x, row, s});
  };
  for (int s = 0; s < shape.samples; ++s) {
    for (int x = 0; x < shape.width; ++x) {
      reach(x, 0, s);
      reach(x, shape.height - 1, s);
    }
    for (int row = 0; row < shape.height; ++row) {
      reach(0, row, s);
      reach(shape.width - 1, row, s);
    }
  }
  while (!next.empty()) {
    const auto [x, row, s] = next.back();
    next.pop_back();
    reach(x - 1, row, s);
    reach(x + 1, row, s);
    reach(x, row - 1, s);
    reach(x, row + 1, s);
  }
  std::uint64_t gaps = 0;
  for (std::size_t k = 0; k < winding.size(); ++k) gaps += winding[k] == 0 && !reached[k] ? 1 : 0;
  return gaps;
}

class MeshJudge {
 public:
  explicit MeshJudge(const JudgedMesh& mesh) : mesh_(mesh) {}

  Verdict Of(const CoverageCounts& counts) {
    for (int row = 0; row < counts.height; ++row) {
      for (int x = 0; x < counts.width; ++x) {
        for (int s = 0; s < counts.samples; ++s) {
          const std::size_t k = counts.Index(x, row, s);
          if (counts.Count(k) == 0 && mesh_.winding[k] == 0) continue;  // outside and left alone
          const SamplePlace place = PlaceOf(mesh_.c, x, row, s);
          if (std::optional<Verdict> violated = Judge(counts.Count(k), k, place)) {
            return *std::move(violated);
          }
        }
      }
    }
    Verdict held = Verdict::Held(exercised_);
    held.not_judged = not_judged_;
    held.in_gaps = mesh_.in_gaps;
    return held;
  }

 private:
  std::optional<Verdict> Judge(std::uint32_t count, std::size_t k, const SamplePlace& place) {
    const auto least = static_cast<std::uint32_t>(std::abs(mesh_.winding[k]));
    const bool is_right = count == least || (count > least && mesh_.ties.Allow(count, k, place.at));
    if (is_right && least == 0) return std::nullopt;
    if (mesh_.open.IsBesideTheOutline(place.at)) return std::nullopt;
    if (mesh_.open.CanTurnAt(place.at) || mesh_.open.ClippingMayDecide(place.at)) {
      ++not_judged_;
      return std::nullopt;
    }
    ++exercised_;
    if (is_right) return std::nullopt;
    const bool at_least = count < least && legal::SharesTies(mesh_.c.profile);
    Witness witness = WitnessAt(-1, -1, place, {"covered ", count, " times"},
                                {least == 0 ? "outside: never"
                                 : at_least ? "at least once"
                                            : "exactly once"});
    Verdict verdict = Verdict::Violated(
        exercised_, count < least ? "a gap in the mesh" : "a sample covered too often", witness);
    verdict.not_judged = not_judged_;
    verdict.in_gaps = mesh_.in_gaps;
    return verdict;
  }

  const JudgedMesh& mesh_;
  std::uint64_t exercised_ = 0;
  std::uint64_t not_judged_ = 0;
};

}  // namespace

Checks CompareWithItsWinding(const PlacedCase& c, const Description& subject) {
  OpenParts open(c, /*spares_outline=*/false);
  if (open.IsFolded()) return NotExercised("the snapped mesh is folded");
  if (open.IsFlat()) return NotExercised("the mesh has triangles in a plane with the eye");
  std::vector<std::int64_t> winding = WindingOf(c);
  if (std::ranges::any_of(winding, [](std::int64_t w) { return std::abs(w) > 1; })) {
    return NotExercised("the mesh overlaps itself");
  }
  SharedTies ties(c);
  const std::uint64_t in_gaps = SamplesInGaps(c, winding);
  const bool as_shown = IsJudgedAsShown(subject.info, c.scene);
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, WholeTarget(c)));
  auto mesh = std::make_shared<const JudgedMesh>(
      JudgedMesh{c, std::move(open), std::move(winding), std::move(ties), in_gaps});
  return OneCheck(std::move(questions), [mesh = std::move(mesh), as_shown](const Answers& answers) {
    Verdict verdict = MeshJudge(*mesh).Of(answers.draws[0]->counts);
    return as_shown ? NeverHolds(std::move(verdict)) : verdict;
  });
}

}  // namespace rasterproof::props
