// A mesh after a long list of triangles that cover nothing is drawn as it is drawn alone, with
// primitive ids that are as much larger as the list is long.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "props/judging/open_by_call.h"
#include "props/judging/primitive_ids.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace long_list_draws_like_its_end {

constexpr std::array<std::size_t, 3> kShortLengths{1, 255, 256};
// One in so many drawn cases is drawn after the longest list, in every domain another one.
constexpr std::uint64_t kOneLongIn = 32;
// So many pixels beyond the target nothing reaches it, wherever a vertex may be put.
constexpr double kAway = 8;

// Whether this case is one of the few. A case that no domain drew is.
bool IsLong(const std::optional<CaseName>& name) {
  if (!name) return true;
  std::uint64_t turn = 0;
  for (const char letter : name->domain) turn += static_cast<unsigned char>(letter);
  return name->index % kOneLongIn == turn % kOneLongIn;
}

// The numbers of triangles before the mesh. The longest is odd: a float that can't hold its odd
// numbers then shows it on a mesh of one triangle.
std::vector<std::size_t> LengthsFor(const PlacedCase& c, const SubjectInfo& info) {
  std::vector<std::size_t> lengths;
  for (const std::size_t length : kShortLengths) {
    if (length < info.list_length) lengths.push_back(length);
  }
  if (IsLong(c.name)) lengths.push_back(info.list_length | 1);
  return lengths;
}

// Adds the vertices, and the triangle that they are three by three, if the subject can be given
// them within its limits.
void AddIfTaken(const PlacedCase& c, const std::vector<Point2>& corners, Scene& scene,
                std::vector<Triangle>& idle) {
  Scene more = scene;
  for (const Point2& at : corners) more.vertices.push_back({at.x, at.y});
  if (!CanBeGiven(more, c.profile) || !IsUnwrapped(more, c.profile)) return;
  for (auto k = static_cast<std::int32_t>(scene.vertices.size());
       k < static_cast<std::int32_t>(more.vertices.size()); k += 3) {
    idle.push_back({k, k + 1, k + 2});
  }
  scene = std::move(more);
}

// Corners of two triangles to the right of the target or, where that is too far, to the left.
std::vector<Point2> Outside(const PlacedCase& c) {
  const double right = c.scene.width + kAway;
  const double x = right + kAway <= c.profile.coordinate_limit ? right : -2 * kAway;
  return {{x, 1}, {x, 3}, {x + 4, 2}, {x + 1, 2}, {x + 5, 1}, {x + 2, 4}};
}

// Whether a triangle in the corner of a pixel, a quarter of it wide, lies between the samples.
bool HasFreeCorners(const PlacedCase& c) {
  const Profile& p = c.profile;
  const bool is_placed = p.freedom.IsNone() && !p.squares && !p.transform &&
                         p.sample_positions == SamplePositions::kStated &&
                         (p.snap.IsNone() || p.snap.bits >= 4);
  return is_placed && !c.scene.clip_space &&
         std::ranges::all_of(p.pattern.locations,
                             [](const Point2& at) { return at.x + at.y > 0.375; });
}

// Triangles of every kind that covers nothing under the profile: beyond the target, flat, between
// its samples. Their vertices go to the end of the scene's. Empty if there are none.
std::vector<Triangle> IdleTriangles(const PlacedCase& c, Scene& scene) {
  std::vector<Triangle> idle;
  if (c.profile.degenerate_triangles == DegenerateTriangles::kNothing && !c.profile.squares) {
    const Triangle& t = scene.triangles.front();
    idle = {{t[0], t[0], t[1]}, {t[1], t[2], t[2]}, {t[2], t[0], t[2]}};
  }
  if (c.before) return idle;  // its own transform takes no other vertices to their places
  AddIfTaken(c, Outside(c), scene, idle);
  if (HasFreeCorners(c)) AddIfTaken(c, {{0, 0}, {0, 0.25}, {0.25, 0}}, scene, idle);
  return idle;
}

Verdict LikeItsEnd(const PlacedCase& c, const Drawing& drawn, const Drawing& alone,
                   const OpenByCall& open, std::size_t length) {
  const std::string after = " (after " + std::to_string(length) + " that cover nothing)";
  const std::uint64_t decisions = open.Judged(DecisionsOf(c));
  Verdict verdict = SameCounts(drawn.counts, open.Expected(drawn.counts, alone.counts), decisions,
                               "that of the mesh alone");
  if (verdict.outcome != Outcome::kViolated && !alone.primitive_ids.empty()) {
    std::vector<std::int32_t> later = alone.primitive_ids;
    for (std::int32_t& id : later) {
      if (id != kNoPrimitive) id += static_cast<std::int32_t>(length);
    }
    const std::vector<std::int32_t> expected = open.Expected(drawn.primitive_ids, later);
    verdict = SamePrimitiveIds(drawn, expected, c.scene.triangles.size(), decisions,
                               "of the mesh alone, numbered on");
    if (Witness* const seen = verdict.witness ? &*verdict.witness : nullptr) {
      seen->triangle = alone.primitive_ids[drawn.counts.Index(seen->x, seen->y, seen->sample)];
    }
  }
  if (verdict.outcome == Outcome::kViolated) verdict.message += after;
  return verdict;
}

Check BehindAList(const PlacedCase& c, DrawQuestion question, const std::vector<Triangle>& idle,
                  std::size_t length, const OpenByCall& open) {
  std::vector<Triangle>& list = question.job.triangles.emplace();
  list.reserve(length + c.scene.triangles.size());
  for (std::size_t k = 0; k < length; ++k) list.push_back(idle[k % idle.size()]);
  list.insert(list.end(), c.scene.triangles.begin(), c.scene.triangles.end());
  Check check;
  check.questions.draws.push_back(std::move(question));
  check.bases = {0};
  check.judge = [&c, open, length](const Answers& answers) {
    return LikeItsEnd(c, *answers.draws[1], *answers.draws[0], open, length);
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.scene.triangles.empty()) return NotExercised("the scene has no triangles");
  const auto open = WhereCallsMayDiffer(c, c.profile.freedom.ties == TieOwnership::kOpen);
  if (!open) return NotExercised(kPlacesNotKnown);
  Scene longer = c.scene;
  const std::vector<Triangle> idle = IdleTriangles(c, longer);
  if (idle.empty()) return NotExercised("no triangle is known to cover nothing");
  const DrawQuestion question = WholeCallOf(longer, c.profile, c.options);
  Checks asked;
  asked.checks.push_back(BaseDraw(question));
  for (const std::size_t length : LengthsFor(c, subject.info)) {
    asked.checks.push_back(BehindAList(c, question, idle, length, *open));
  }
  return asked;
}

}  // namespace long_list_draws_like_its_end

extern constinit const Property kLongListDrawsLikeItsEnd{
    .name = "LongListDrawsLikeItsEnd",
    .group = "coverage",
    .clause =
        "Triangles that cover nothing change nothing but the numbers of those after them, "
        "however many they are.",
    .required_by = kIndependentClauses,
    .tolerance = kExact,
    .domains = kLists,
    .takes_long = true,
    .gate = {.space = Space::kEither, .any_model = true, .judges_clipped = true},
    .ask = long_list_draws_like_its_end::Ask,
};

}  // namespace rasterproof::props
