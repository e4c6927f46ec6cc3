// How often a subject's coverage depends on the floating-point mode of its caller.
#ifndef RASTERPROOF_PROPS_FLOAT_MODES_FLOAT_MODES_H_
#define RASTERPROOF_PROPS_FLOAT_MODES_FLOAT_MODES_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/float_mode.h"
#include "core/subject.h"

namespace rasterproof::props {

struct FloatModesPlan {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  ///< over the domains of EnvironmentKeepsCoverage, in turn
  /// Asked between cases: true ends the measurement. May be empty.
  std::function<bool()> stop = {};
};

/// A case, and what the subject drew of it in the usual mode; nothing where it drew nothing.
struct UsualDrawing {
  Case value;
  std::optional<CoverageCounts> counts;
};

/// What the subject draws of the plan's cases in the usual mode, the first half of them twice: a
/// subject that changes its mind by itself is not measured.
///
/// Error:      InputError if the subject draws the same case differently.
std::vector<UsualDrawing> DrawAsUsual(Subject& subject, const FloatModesPlan& plan);

/// What became of the same cases in another mode.
struct FloatModeResult {
  std::uint64_t cases = 0;    ///< drawn in the usual mode
  std::uint64_t touched = 0;  ///< of these, cases that the mode could change (CanTouch)
  std::uint64_t changed = 0;  ///< of these, cases whose coverage is another one
  /// Of the changed cases, those whose vertices a snap in the mode's direction explains.
  std::uint64_t by_snap = 0;
  std::uint64_t failed = 0;   ///< cases that broke the subject down: a trap, a mode left behind
  std::string why;            ///< of the first of these
  std::optional<Case> first;  ///< that changed or failed
};

/// Draws the cases again, by a subject that is in `mode`: because the draws ask for it as their
/// `option`, or because of how it was made.
///
/// Domain:     HasFloatMode(mode); a subject of the same kind as that of the usual drawings.
FloatModeResult CompareWithUsual(Subject& subject, const std::vector<UsualDrawing>& usual,
                                 FloatMode mode, FloatMode option,
                                 const std::function<bool()>& stop);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_FLOAT_MODES_FLOAT_MODES_H_
