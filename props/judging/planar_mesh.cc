#include "props/judging/planar_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "model/snap_scene.h"
#include "props/judging/as_shown.h"
#include "props/judging/free_choices.h"
#include "props/judging/mesh_model.h"
#include "props/judging/outline.h"
#include "props/judging/redraw.h"
#include "props/judging/thin_triangles.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

bool SharesTies(const Profile& profile) { return profile.overdraw || profile.fill_rule.inclusive; }

// The samples that more than one triangle of a mesh may cover: those on its edges, where the
// profile lets every triangle have them. Where the edges may lie elsewhere: those near them.
class SharedTies {
 public:
  explicit SharedTies(const Case& c) {
    if (!SharesTies(c.profile)) return;
    if (LegalReach(c) != 0) {
      edges_ = Outline::OfAllEdges(c, LegalReach(c));
      return;
    }
    most_ = CoverageUnder(c, {.inclusive = true}, WholeTarget(c));
  }

  bool Allow(std::uint32_t count, std::size_t index, Point2 at) const {
    return most_.size() != 0 ? count <= most_.Count(index) : edges_.IsNear(at);
  }

 private:
  CoverageCounts most_;
  Outline edges_;
};

bool LiesAroundTheEye(const Scene& scene) {
  return scene.clip_space &&
         std::ranges::any_of(scene.vertices, [](const Vertex& v) { return !(v.w > 0); });
}

// What a legal choice leaves open of a mesh: where its outline lies, and what it can turn.
class OpenParts {
 public:
  OpenParts(const Case& c, const MeshView& view) {
    const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
    if (one_model || LiesAroundTheEye(c.scene)) {
      const MeshFacings facings = FacingsOf(c);
      is_folded_ = facings.folded;
      is_flat_ = !one_model && facings.degenerate != 0;
    }
    if (one_model) {
      if (view.spares_outline) outline_ = Outline(c);
      return;
    }
    double most_moved = LegalReach(c);
    if (LiesAroundTheEye(c.scene)) {
      thin_ = ThinTriangles(c, most_moved);
    } else {
      open_ = OpenTriangles(c);
      is_folded_ = open_.RestIsFolded();
      most_moved = open_.MostMoved();
    }
    outline_ = Outline::OfMoved(c, most_moved);
  }

  bool IsFolded() const { return is_folded_; }
  /// Around the eye: nothing is said of triangles in a plane with it.
  bool IsFlat() const { return is_flat_; }
  bool IsBesideTheOutline(Point2 p) const { return outline_.IsNear(p); }
  bool CanTurnAt(Point2 p) const { return open_.CanCover(p) || thin_.AreNear(p); }

 private:
  bool is_folded_ = false;
  bool is_flat_ = false;
  Outline outline_;
  OpenTriangles open_;
  ThinTriangles thin_;
};

// What is judged of a mesh, and what is expected there.
struct JudgedMesh {
  Case c;
  MeshView view;
  OpenParts open;
  std::vector<std::int64_t> winding;
  SharedTies ties;
};

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
    return held;
  }

 private:
  std::optional<Verdict> Judge(std::uint32_t count, std::size_t k, const SamplePlace& place) {
    const auto least = static_cast<std::uint32_t>(std::abs(mesh_.winding[k]));
    const bool is_right = count == least || (count > least && mesh_.ties.Allow(count, k, place.at));
    if (is_right && least == 0) return std::nullopt;
    if ((mesh_.view.looks_at && !mesh_.view.looks_at(place)) ||
        mesh_.open.IsBesideTheOutline(place.at)) {
      return std::nullopt;
    }
    if (mesh_.open.CanTurnAt(place.at)) {
      ++not_judged_;
      return std::nullopt;
    }
    ++exercised_;
    if (is_right) return std::nullopt;
    const bool at_least = count < least && SharesTies(mesh_.c.profile);
    Witness witness = WitnessAt(-1, -1, place, "covered " + std::to_string(count) + " times",
                                least == 0 ? "outside: never"
                                : at_least ? "at least once"
                                           : "exactly once");
    Verdict verdict = Verdict::Violated(
        exercised_, count < least ? "a gap in the mesh" : "a sample covered too often", witness);
    verdict.not_judged = not_judged_;
    return verdict;
  }

  const JudgedMesh& mesh_;
  std::uint64_t exercised_ = 0;
  std::uint64_t not_judged_ = 0;
};

}  // namespace

Asked CompareWithItsWinding(Case c, MeshView view, const Description& subject) {
  OpenParts open(c, view);
  if (open.IsFolded()) return NothingAsked("the snapped mesh is folded");
  if (open.IsFlat()) return NothingAsked("the mesh has triangles in a plane with the eye");
  std::vector<std::int64_t> winding = WindingOf(c);
  if (std::ranges::any_of(winding, [](std::int64_t w) { return std::abs(w) > 1; })) {
    return NothingAsked("the mesh overlaps itself");
  }
  SharedTies ties(c);
  const bool as_shown = IsJudgedAsShown(subject, c);
  Questions questions;
  questions.draws.push_back(CountsOf(c.scene, c.profile, WholeTarget(c)));
  auto mesh = std::make_shared<const JudgedMesh>(JudgedMesh{
      std::move(c), std::move(view), std::move(open), std::move(winding), std::move(ties)});
  return OneCheck(std::move(questions), [mesh = std::move(mesh), as_shown](const Answers& answers) {
    Verdict verdict = MeshJudge(*mesh).Of(answers.draws[0]->counts);
    if (!as_shown || verdict.outcome == Outcome::kViolated) return verdict;
    return Verdict{Outcome::kNotExercised, 0, 0, std::string(kJudgedAsShown), std::nullopt};
  });
}

}  // namespace rasterproof::props
