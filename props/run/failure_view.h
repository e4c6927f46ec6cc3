// What a failing verdict shows of its drawing: counts around the place, and triangles there.
#ifndef RASTERPROOF_PROPS_RUN_FAILURE_VIEW_H_
#define RASTERPROOF_PROPS_RUN_FAILURE_VIEW_H_

#include <array>
#include <optional>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The case with the scene and the options that were drawn, if the verdict is of others than its
/// own.
Case AsDrawn(const Case& c, const Verdict& verdict);

/// Whether the verdict has a place to show. A breakdown has none.
bool HasPlace(const Verdict& verdict);

CoverageCounts BlankTarget(const PlacedCase& c);

/// Whether the verdict holds what the subject drew on such a target.
bool HoldsDrawing(const Verdict& verdict, const CoverageCounts& target);

struct FailureView {
  CoverageCounts expected;
  CoverageCounts observed;  ///< blank if the verdict does not hold it
  Scene scene;              ///< where the model places it; in clip space if that is not snapped
  int focus_x = -1;         ///< the witness, or the first pixel that differs; -1: there is none
  int focus_y = -1;
  PixelRect view;                ///< at most `side` pixels a side, around the focus
  std::optional<Point2> sample;  ///< nothing: there is no focus
  /// The witness's, then those that hold the sample, in them or on an edge, then those whose edges
  /// pass nearest.
  std::vector<int> triangles;
};

/// Domain:     what was drawn: a placed AsDrawn().
/// Error:      InputError if the oracle does not decide the scene, and the verdict holds no
///             expected counts.
FailureView ViewOf(const SubjectInfo& subject, const PlacedCase& c, const Verdict& verdict,
                   int side);

/// The exact value of the edge function, of a FailureView's scene.
exact::Rational EdgeAt(const Scene& scene, const Vertex& a, const Vertex& b, Point2 p);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_FAILURE_VIEW_H_
