// On a target of more than 2^24 samples rectangles of whole pixels are covered once, and nothing
// else is: as on a small one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "model/snap_scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace large_target_is_covered_like_a_small_one {

// 2^24 + 2^13 + 1 samples: the last rows have numbers that no float32 holds, and there are 17 tiles
// of 256 pixels a side, 289 in all.
constexpr int kSide = 4097;

// Drawn cases of these numbers, of 1000 each, are drawn so: two of a run with the default number.
constexpr std::uint64_t kOneIn = 1000;
constexpr std::array<std::uint64_t, 2> kTurns{0, 500};

// Width or height is even and the other odd: no diagonal then passes through the middle of a pixel.
using Rectangles = std::array<PixelRect, 6>;
constexpr std::array<Rectangles, 2> kScenes{{
    // In the corners, in the last rows, and across lines between tiles of powers of two.
    {{{0, 0, 8, 5},
      {4080, 0, kSide, 16},
      {0, 4090, 20, kSide},
      {4034, 4034, kSide, 4096},
      {2040, 2041, 2056, 2056},
      {1000, 4096, 1330, kSide}}},
    // From end to end.
    {{{0, 4081, 4096, 4088},
      {4081, 0, 4088, 4080},
      {4096, 0, kSide, 4096},
      {0, 4096, 4096, kSide},
      {4090, 4089, 4095, 4095},
      {0, 0, 256, 257}}},
}};

// Which of the scenes this case stands for; none for most. A case that no domain drew, as one from
// a file, stands for all. Answers of another process cost twice as much as the others', and are
// asked for once.
std::vector<std::size_t> TurnsOf(const std::optional<CaseName>& name, bool is_outside) {
  if (!name) return {0, 1};
  for (std::size_t k = 0; k < kTurns.size(); ++k) {
    if (name->index % kOneIn == kTurns[k] && (k == 0 || !is_outside)) return {k};
  }
  return {};
}

// How far the borders of pixels are moved so that samples lie in the middle between them: 0 or 1/2.
std::optional<double> ShiftOf(double location) {
  for (const double shift : {0.0, 0.5}) {
    const double beyond = location - shift;
    if (beyond - std::floor(beyond) == 0.5) return shift;
  }
  return std::nullopt;
}

struct Shift {
  double x = 0;
  double y = 0;
};

// The reason why the profile or the subject leaves the rectangles' samples open, or is not asked.
std::string WhyNot(const PlacedCase& c, const SubjectInfo& info, Shift& shift) {
  const Profile& p = c.profile;
  if (info.list_length <= kListLengthOfPrograms) {
    return "a program on a pipe is not asked above 2^24 samples: each is a number of its answer; "
           "'certify --exhaustive large-target' asks it";
  }
  if (p.pattern.samples() != 1) return "the target would have more than one sample a pixel";
  if (!p.scanline_rounding.IsNone()) return "the profile rounds where edges cross rows";
  if (c.before) return "its own transform takes vertices of so large a target elsewhere";
  const Point2 location = p.pattern.locations.front();
  const std::optional<double> x = ShiftOf(location.x);
  const std::optional<double> y = ShiftOf(location.y);
  if (!x || !y) return "samples do not lie in the middle of half pixels";
  shift = {*x, *y};
  // What may move, moves by less than a step from a whole pixel, which is on every grid: nowhere.
  const bool may_move = p.freedom.MovesVertices() || !p.by_target_size.empty();
  if (may_move && (*x != 0 || *y != 0 || p.freedom.snap_tolerance >= 1)) {
    return "legal grid points may move whole pixels";
  }
  return "";
}

Scene SceneOf(const PlacedCase& c, const Rectangles& rectangles, const Shift& shift) {
  Scene scene;
  scene.name = "large-target";
  scene.width = kSide;
  scene.height = kSide;
  scene.precision = c.scene.precision;
  for (const PixelRect& r : rectangles) {
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    const double left = r.x0 - shift.x;
    const double top = r.y0 - shift.y;
    const double right = r.x1 - shift.x;
    const double bottom = r.y1 - shift.y;
    for (const Point2& at : {Point2{left, top}, {left, bottom}, {right, bottom}, {right, top}}) {
      scene.vertices.push_back({at.x, c.profile.y_axis == YAxis::kUp ? kSide - at.y : at.y});
    }
    scene.triangles.push_back({first, first + 1, first + 2});
    scene.triangles.push_back({first, first + 2, first + 3});
  }
  return scene;
}

// Rows of the target, one after the other: no second picture of it is made.
Verdict OnceInside(const Rectangles& rectangles, const CoverageCounts& observed) {
  std::vector<std::uint32_t> expected(static_cast<std::size_t>(observed.width));
  std::uint64_t wrong = 0;
  std::uint64_t judged = 0;
  std::optional<Witness> first;
  for (int row = 0; row < observed.height; ++row) {
    expected.assign(expected.size(), 0);
    for (const PixelRect& r : rectangles) {
      if (row < r.y0 || row >= r.y1) continue;
      for (int x = r.x0; x < r.x1; ++x) ++expected[static_cast<std::size_t>(x)];
      judged += static_cast<std::uint64_t>(r.x1 - r.x0);
    }
    const std::size_t at = observed.Index(0, row);
    for (std::size_t x = 0; x < expected.size(); ++x) {
      const std::uint32_t count = observed.Count(at + x);
      if (count == expected[x]) continue;
      ++wrong;
      if (first) continue;
      first = Witness{.x = static_cast<int>(x),
                      .y = row,
                      .observed = {"covered ", count, " times"},
                      .expected = {expected[x]}};
    }
  }
  if (!first) return Verdict::Held(judged);
  Verdict verdict = Verdict::Violated(
      judged,
      std::to_string(wrong) + " samples of a target of " + std::to_string(kSide) + " x " +
          std::to_string(kSide) + " are not covered as often as rectangles of whole pixels are",
      *first);
  verdict.failed_draw = 0;
  return verdict;
}

bool HoldsALargeTarget(const PlacedCase& c, const SubjectInfo& info, const Shift& shift) {
  return !c.profile.max_primitive_extent &&
         std::ranges::all_of(kScenes, [&](const Rectangles& rectangles) {
           const Scene scene = SceneOf(c, rectangles, shift);
           return Takes(info, scene) && WithinLimits(scene, c.profile) &&
                  IsUnwrapped(scene, c.profile) && IsUnclipped(scene, c.profile);
         });
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  Shift shift;
  if (const std::string why = WhyNot(c, subject.info, shift); !why.empty()) return NotDecided(why);
  if (!HoldsALargeTarget(c, subject.info, shift)) {
    return NotDecided("its limits do not hold a target of more than 2^24 samples");
  }
  Checks asked;
  for (const std::size_t turn : TurnsOf(c.name, subject.has_twin)) {
    const Scene scene = SceneOf(c, kScenes[turn], shift);
    Check& check = asked.checks.emplace_back();
    check.questions.draws.push_back(WholeCallOf(scene, c.profile, {}));
    check.judge = [turn](const Answers& answers) {
      return OnceInside(kScenes[turn], answers.draws[0]->counts);
    };
  }
  if (asked.checks.empty()) {
    return NotExercised("two cases of 1000, of a plugin one, are drawn on a target of 4097 x 4097");
  }
  return asked;
}

constexpr auto kSmallMeshes = std::to_array<std::string_view>({"grids"});
constexpr std::array kRules{kDrawsBothFacings};

}  // namespace large_target_is_covered_like_a_small_one

extern constinit const Property kLargeTargetIsCoveredLikeASmallOne{
    .name = "LargeTargetIsCoveredLikeASmallOne",
    .group = "coverage",
    .clause =
        "Rectangles of whole pixels are covered once, and nothing else is, on a target of more "
        "than 2^24 samples as well.",
    .required_by = kPlacedSampleClauses,
    .tolerance = kExact,
    .domains = large_target_is_covered_like_a_small_one::kSmallMeshes,
    .draws_own_scenes = true,
    .gate = {.any_model = true,
             .judges_shared_edge_samples = true,
             .judges_clipped = true,
             .rules = large_target_is_covered_like_a_small_one::kRules,
             .where = "one sample a pixel, and limits that hold 4097 x 4097 pixels"},
    .ask = large_target_is_covered_like_a_small_one::Ask,
};

}  // namespace rasterproof::props
