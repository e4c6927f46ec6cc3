// The results of a run: measured by props and tool, rendered by report.
#ifndef RASTERPROOF_CORE_RESULT_H_
#define RASTERPROOF_CORE_RESULT_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/authority.h"
#include "core/case.h"
#include "core/coverage.h"
#include "core/verdict.h"

namespace rasterproof {

/// How near to edges the samples of a run lay, measured on the lattice in use.
struct NearEdgeCounts {
  std::uint64_t samples = 0;  ///< (edge, sample) pairs looked at
  std::uint64_t on_edge = 0;
  std::uint64_t within_1 = 0;  ///< not on the edge, within 1 ulp (or subpixel step) of it
  std::uint64_t within_16 = 0;
  std::uint64_t within_256 = 0;
};

/// Sums over the cases of one property.
struct Counts {
  std::uint64_t cases = 0;            ///< cases run
  std::uint64_t cases_exercised = 0;  ///< cases that exercised the property
  std::uint64_t exercised = 0;        ///< times the property was exercised
  std::uint64_t cases_refused = 0;    ///< cases that the subject refused
  std::uint64_t not_judged = 0;       ///< samples that a legal choice of the subject's leaves open
  double worst_ratio = 0;             ///< largest error / bound

  /// Adds a case with this verdict.
  void AddCase(const Verdict& verdict);
  /// Adds the counts of other cases.
  void Add(const Counts& more);
};

/// One property on one subject over a campaign of k cases of a seed, which reports call "tested".
struct PropertyResult : Counts {
  std::string property;
  std::string subject;
  std::string clause;                             ///< the sentence it enforces, with its source
  Authority authority = Authority::kStatedModel;  ///< who requires it, by the subject's profile
  std::vector<std::string> required_by;           ///< ids of clauses, if clauses require it
  std::string tolerance;                          ///< the named bound, or "none: exact"
  Outcome outcome = Outcome::kNotExercised;
  std::string world;              ///< the small world that it ran over; empty: random cases
  std::uint64_t world_cases = 0;  ///< cases of the world
  NearEdgeCounts near_edge;
  std::uint64_t seed = 0;
  double seconds = 0;
  std::string message;
  /// The first counterexample, shrunk, with its verdict.
  std::optional<Case> counterexample;
  std::optional<Verdict> verdict;
  /// The scene that was drawn for it, if the property changed the case's scene.
  std::shared_ptr<const DrawnScene> Drawn() const { return verdict ? verdict->drawn : nullptr; }
  /// Name of the case that failed first, before it was shrunk, "near-edge:17@1"; "" if it has none.
  std::string failing_case;
};

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
