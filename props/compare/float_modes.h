// How often a subject's coverage depends on the floating-point mode of its caller.
#ifndef RASTERPROOF_PROPS_COMPARE_FLOAT_MODES_H_
#define RASTERPROOF_PROPS_COMPARE_FLOAT_MODES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/case.h"
#include "core/drawing.h"
#include "core/float_mode.h"
#include "core/subject.h"
#include "props/compare/compare.h"

namespace rasterproof::props {

/// A case, and what the subject drew of it in the usual mode.
struct UsualDrawing {
  Case value;
  std::shared_ptr<const Drawing> drawing;
};

/// What the subject draws in the usual mode, of the first `cases` of EnvironmentKeepsCoverage;
/// without those that it does not draw. The first half is drawn twice: a subject that changes its
/// mind by itself is not compared.
///
/// Error:      InputError if the subject draws the same case differently.
std::vector<UsualDrawing> DrawAsUsual(Subject& subject, std::uint64_t seed, std::uint64_t cases,
                                      const std::function<bool()>& stop);

/// These cases, drawn already; they outlive the row.
Row RowOf(const std::vector<UsualDrawing>& usual);

/// The subject itself in another floating-point mode: because the draws ask for it as their
/// `option`, or because of how the subject was made. Excuses cases that the mode can't touch
/// (CanTouch). By the snap alone differ cases whose vertices a snap in the mode's direction moves
/// so.
///
/// Domain:     HasFloatMode(mode); a subject of the same kind as that of the usual drawings, which
///             outlives the yardstick.
Yardstick ItselfInMode(Subject& subject, FloatMode mode, FloatMode option);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_FLOAT_MODES_H_
