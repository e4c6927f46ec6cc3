// The results of a run: measured by props and tool, rendered by report.
#ifndef RASTERPROOF_CORE_RESULT_H_
#define RASTERPROOF_CORE_RESULT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/authority.h"
#include "core/case.h"
#include "core/counters.h"
#include "core/coverage.h"
#include "core/grids_left.h"
#include "core/verdict.h"

namespace rasterproof {

/// The cases drawn from one domain.
struct DomainCounts {
  std::uint64_t drawn = 0;
  NearEdgeCounts near_edge;
};

/// The kinds of places where rasterizers differ: the words complete "cases with ...".
inline constexpr std::size_t kKindsOfPlaces = 10;
inline constexpr std::array<std::string_view, kKindsOfPlaces> kCasePlaces{
    "a sample on a horizontal edge", "a sample on a vertical edge",
    "a sample on a slanted edge",    "a sample on a shared edge",
    "a vertex on a sample",          "a triangle of zero area",
    "a triangle off the target",     "a triangle of positive area",
    "a triangle of negative area",   "a clip-space vertex off the target or with w <= 0"};
using CountsOfPlaces = std::array<PlaceCounts, kKindsOfPlaces>;

/// The draws that put a property to the test: of scenes in each space as the subject is given them,
/// and the samples of their largest target.
struct DrawsJudged {
  std::uint64_t window = 0;
  std::uint64_t clip = 0;
  std::uint64_t largest_target = 0;

  DrawsJudged& operator+=(const DrawsJudged& more);
};
inline constexpr auto kDrawsJudged =
    std::to_array<Counter<DrawsJudged>>({{"window", &DrawsJudged::window},
                                         {"clip", &DrawsJudged::clip},
                                         {"largest_target", &DrawsJudged::largest_target}});

/// How the run of a property over its cases ended.
enum class End : std::uint8_t {
  kAllRun,         ///< with its last case
  kNotApplicable,  ///< before its first case
  kFailed,         ///< with a case that failed
  kInconclusive,   ///< with a case that could not be judged
  kTimeUp,         ///< sooner: its time was up
  kInterrupted     ///< sooner: it was stopped
};

/// A case that failed, shrunk, and what came of it when it was run once more.
struct Counterexample {
  Case value;
  Verdict verdict;  ///< violated; the first answer where there are two
  Outcome outcome = Outcome::kViolated;
  std::string message;
  std::uint64_t evaluations = 0;  ///< that shrinking took
  /// Name of the case before it was shrunk, "near-edge:17@1"; "" if it has none.
  std::string failing_case = {};
};

/// One property on one subject over a campaign of k cases of a seed, which reports call "tested".
///
/// Counters, end and counterexample are what a run, or one shard of it, saw; outcome and message
/// follow from them (props/run/conclude.h).
struct PropertyResult {
  std::string property;
  std::string subject;
  std::string clause;                             ///< the sentence it enforces, with its source
  Authority authority = Authority::kStatedModel;  ///< who requires it, by the subject's profile
  std::vector<std::string> required_by;           ///< ids of clauses, if clauses require it
  std::string tolerance;                          ///< the named bound, or "none: exact"
  std::string world;              ///< the small world that it ran over; empty: random cases
  std::uint64_t world_cases = 0;  ///< cases of the world
  /// Whether it says if one legal model explains the drawing of a real scene.
  bool is_of_a_scene = false;
  std::uint64_t seed = 0;

  std::uint64_t cases = 0;            ///< cases run, the one that it ended with included
  std::uint64_t cases_exercised = 0;  ///< cases that exercised the property
  std::uint64_t exercised = 0;        ///< times the property was exercised
  std::uint64_t cases_refused = 0;    ///< cases that the subject refused
  std::uint64_t not_judged = 0;       ///< samples that a legal choice of the subject's leaves open
  std::uint64_t in_gaps = 0;     ///< samples in none of a scene's triangles, and enclosed by them
  std::uint64_t indistinct = 0;  ///< numbers that would hold with exchanged corners, too
  double worst_ratio = 0;        ///< largest error / bound
  // Cases in which the subject showed the side of this area as the front, where either is legal.
  std::uint64_t positive_fronts = 0;
  std::uint64_t negative_fronts = 0;
  /// Where the profile leaves the grid open, and the property observes it.
  std::vector<GridsOnTarget> grids;
  std::vector<DomainCounts> domains;        ///< none of a world
  std::uint64_t not_applicable = 0;         ///< cases that the property did not apply to
  std::string why_not;                      ///< the first reason
  std::uint64_t refused_within_limits = 0;  ///< of cases_refused
  std::string why_refused;                  ///< the first of those refusals
  CountsOfPlaces places{};                  ///< of cases within the limits
  DrawsJudged draws;

  /// Decisions of the oracle over all cases; none if it ended with a case or sooner: how often then
  /// depends on which cases shared calls with that one.
  TierCounts tiers;

  End end = End::kAllRun;
  std::string why;                               ///< of kNotApplicable and kInconclusive
  std::optional<Counterexample> counterexample;  ///< of kFailed: the first
  double seconds = 0;

  Outcome outcome = Outcome::kNotExercised;
  std::string message;
  bool message_counts_refused = false;  ///< the message says how many cases were refused

  /// Adds what the verdict of a case says to the counters; the case itself props/run/conclude.h
  /// looks at.
  void AddCase(const Verdict& verdict);
  /// Adds the result over the cases that follow. The sum is the result over both, if what the
  /// subject draws depends on nothing but the scene, and no limit of time was met. To one that did
  /// not end with its last case only seconds are added. Outcome and message stay: conclude again.
  ///
  /// Domain:     of the same property, subject, world and domains; or this one has no domains yet.
  PropertyResult& operator+=(const PropertyResult& next);
  /// Of all domains.
  NearEdgeCounts NearEdge() const;
};

/// The counters of its cases that just add up.
inline constexpr auto kCaseCounters = std::to_array<Counter<PropertyResult>>(
    {{"cases", &PropertyResult::cases},
     {"cases_exercised", &PropertyResult::cases_exercised},
     {"exercised", &PropertyResult::exercised},
     {"cases_refused", &PropertyResult::cases_refused},
     {"not_judged", &PropertyResult::not_judged},
     {"in_gaps", &PropertyResult::in_gaps},
     {"indistinct", &PropertyResult::indistinct},
     {"positive_fronts", &PropertyResult::positive_fronts},
     {"negative_fronts", &PropertyResult::negative_fronts},
     {"not_applicable", &PropertyResult::not_applicable},
     {"refused_within_limits", &PropertyResult::refused_within_limits}});

/// Returns the property and its world, if any: "CoverageEqualsTheModel on triangles-7x7".
inline std::string NameOf(const PropertyResult& result) {
  return result.world.empty() ? result.property : result.property + " on " + result.world;
}
/// Returns whether it holds in every case of a world, which reports call "exhausted": no case was
/// refused, and no sample was left open.
inline bool IsExhausted(const PropertyResult& result) {
  return result.outcome == Outcome::kHolds && !result.world.empty() &&
         result.cases == result.world_cases && result.cases_refused == 0 && result.not_judged == 0;
}

/// Returns whether the stated error lets most numbers of exchanged corners pass.
inline bool HasWideError(const PropertyResult& result) {
  return result.indistinct > result.exercised;
}

/// Returns whether it is a violation that fails the run.
inline bool IsFailure(const PropertyResult& result, FailOn fail_on) {
  return result.outcome == Outcome::kViolated && Fails(result.authority, fail_on);
}
/// Returns whether it is a violation that does not fail the run: no specification requires it.
inline bool IsLackOfQuality(const PropertyResult& result, FailOn fail_on) {
  return result.outcome == Outcome::kViolated && !Fails(result.authority, fail_on);
}

/// One subject on one real scene.
struct SceneResult {
  std::string scene;
  std::string subject;
  std::string profile;
  std::uint64_t triangles = 0;
  CoverageDifference difference;
  /// True if the comparison was of masks, not of counts: the subject shows no counts, and the scene
  /// is too large to be drawn triangle by triangle.
  bool as_shown = false;
  bool applicable = true;
  std::string message;
  double seconds = 0;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_RESULT_H_
