// The verdict of a property on one case.
#ifndef RASTERPROOF_CORE_VERDICT_H_
#define RASTERPROOF_CORE_VERDICT_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/case.h"
#include "core/compared_numbers.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/grids_left.h"
#include "core/witness.h"

namespace rasterproof {

enum class Outcome : std::uint8_t {
  kHolds,
  kViolated,
  kNotExercised,   ///< the case meets the precondition nowhere: neither good nor bad
  kNotApplicable,  ///< the subject or the profile does not state this at all
  kRefused,        ///< the subject refused the scene: the outcome of a case, never of a run
  kInconclusive    ///< it could not be judged: too slow, not deterministic, too much refused
};

/// Two drawings that a property says are equal, of one shape.
struct ComparedCounts {
  CoverageCounts observed;
  CoverageCounts expected;
};

struct Verdict {
  Outcome outcome = Outcome::kNotExercised;
  /// How many times the property was exercised (samples, edges, steps).
  std::uint64_t exercised = 0;
  /// Largest observed error / bound, for properties with a bound; 0 otherwise.
  double worst_ratio = 0;
  /// Why it does not apply, or what failed, in one line.
  std::string message;
  std::optional<Witness> witness;
  /// The two drawings, if the property compares whole drawings. The case's own need not be one.
  std::shared_ptr<const ComparedCounts> compared = nullptr;
  /// The numbers around the failing sample, if the property compares such as each sample shows.
  std::shared_ptr<const ComparedNumbers> numbers = nullptr;
  /// Index of the check's draw that failed, counting its `bases` first; nothing: the case's own.
  std::optional<std::size_t> failed_draw = std::nullopt;
  /// The failing scene as it was drawn, if the property changed the case's scene: the witness then
  /// refers to this scene.
  std::shared_ptr<const DrawnScene> drawn = nullptr;
  /// What the subject drew of the failing scene, `drawn` or the case's own, with counts by facing;
  /// nullptr if the property did not ask for that.
  std::shared_ptr<const Drawing> seen = nullptr;
  /// Violated because the subject broke down over the case: nothing is known to be drawn wrong.
  bool broke_down = false;
  /// Samples that the property covers but does not judge, because the subject could legally choose
  /// to turn, flatten or fold a triangle there.
  std::uint64_t not_judged = 0;
  /// Samples in none of the scene's triangles, and enclosed by them: a crack or a hole that the
  /// scene itself has, if the property looks for gaps.
  std::uint64_t in_gaps = 0;
  /// Numbers beside `exercised` that hold, and would if corners were exchanged or the other plane
  /// were meant, though these give another number: the stated error is that wide.
  std::uint64_t indistinct = 0;
  /// The sign of the area of the side that the subject shows as its front, if the profile leaves
  /// that open and the property observes it.
  std::optional<int> front_sign = std::nullopt;
  /// The grids that explain what the subject drew, if the profile leaves the grid open and the
  /// property observes it.
  std::optional<GridsLeft> grids = std::nullopt;

  static Verdict NotApplicable(std::string why) {
    return {Outcome::kNotApplicable, 0, 0, std::move(why), std::nullopt};
  }
  static Verdict NotExercised(std::string why) {
    return {Outcome::kNotExercised, 0, 0, std::move(why), std::nullopt};
  }
  static Verdict Refused(std::string why) {
    return {Outcome::kRefused, 0, 0, std::move(why), std::nullopt};
  }
  static Verdict Inconclusive(std::string why) {
    return {Outcome::kInconclusive, 0, 0, std::move(why), std::nullopt};
  }
  /// Holds if exercised at least once.
  static Verdict Held(std::uint64_t exercised, double worst_ratio = 0) {
    return {exercised != 0 ? Outcome::kHolds : Outcome::kNotExercised,
            exercised,
            worst_ratio,
            {},
            std::nullopt};
  }
  static Verdict Violated(std::uint64_t exercised, std::string message, Witness witness) {
    return {Outcome::kViolated, exercised, 0, std::move(message), std::move(witness)};
  }
};

/// "holds", "violated", "not exercised", "not applicable", "refused", "inconclusive".
std::string_view OutcomeName(Outcome outcome);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_VERDICT_H_
