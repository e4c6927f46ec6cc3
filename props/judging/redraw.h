// The two halves of most coverage properties: asking for draws of a case, and comparing their
// counts.
//
// CountsOf() and WholeCallOf() make one question each; Compare...() make all checks of a property
// of a common form. To compare primitive ids, see primitive_ids.h; to judge by what any legal
// model counts, legal_counts.h.
#ifndef RASTERPROOF_PROPS_JUDGING_REDRAW_H_
#define RASTERPROOF_PROPS_JUDGING_REDRAW_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/question.h"
#include "core/verdict.h"
#include "props/judging/gate.h"
#include "props/judging/open_by_call.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// Returns the question for the counts of a scene, by facing, on a target of zeros. Properties
/// compare its answer with the oracle's counts. A subject that shows less is asked for parts of the
/// scene, in several calls. To see what one call shows, use WholeCallOf().
DrawQuestion CountsOf(const Scene& scene, const Profile& profile, const DrawOptions& options);
/// Returns the same question about triangle t alone. Several questions can share the scene, so that
/// a large mesh is not copied for each of its triangles.
DrawQuestion CountsOfOne(const std::shared_ptr<const Scene>& scene, std::size_t t,
                         const Profile& profile, const DrawOptions& options);
/// Returns the question for the coverage and the primitive ids that one call with the whole scene
/// shows. Properties that compare draws with each other use it: if the answer were made of parts,
/// each part would be one triangle alone, whatever the order of the triangles.
DrawQuestion WholeCallOf(const Scene& scene, const Profile& profile, const DrawOptions& options);

/// Returns a check that asks for a draw and judges nothing. It must be the first check of the case:
/// its drawing is then number 0, which CheckAgainstBase() compares with.
Check BaseDraw(DrawQuestion question);
/// Returns a check that asks for a draw and judges its counts beside those of BaseDraw().
Check CheckAgainstBase(
    DrawQuestion question,
    std::function<Verdict(const CoverageCounts& observed, const CoverageCounts& base)> judge);

/// Another scene that must cover the same samples as the case, equally often.
struct Variation {
  Scene scene;
  std::string property;  ///< completes "coverage differs from ..."
};

/// Returns checks that each variation covers what the case covers. Each scene is drawn in one call,
/// without culling and scissor. At the samples of `open`, where two calls may differ, nothing is
/// compared. To compare another option of the same scene, use CompareOption().
///
/// Domain:     a case that outlives what is returned.
Checks CompareVariations(const PlacedCase& c, const std::vector<Variation>& variations,
                         const OpenByCall& open = {});

/// Returns whether the case can be drawn on a target of this size without changing its model: the
/// size is one that subjects are asked for, and the profile states the same model for it as for the
/// case's target. (A profile can state a model of its own for some sizes: `by_target_size`.)
bool HasTheModelOf(const PlacedCase& c, int width, int height);

/// Returns the number of inside-or-outside decisions that a draw of the case puts to the test. Each
/// finite triangle adds the samples of the target in its bounding box, grown by a step of the grid;
/// in clip space it adds every sample.
std::uint64_t DecisionsOf(const PlacedCase& c);

/// Returns the counts of the case's canonical model with its tie rule replaced by `rule`.
CoverageCounts CoverageUnder(const PlacedCase& c, const TieRule& rule, const DrawOptions& options);

/// Returns the counts within the rectangle, and zero elsewhere.
CoverageCounts CutTo(const PixelRect& rect, const CoverageCounts& whole);

/// Returns the verdict; if it is a violation, it names `draw` as the draw that failed.
Verdict OfDraw(std::size_t draw, Verdict verdict);

/// Of more samples than this a verdict keeps no pictures: of 2^28 each takes 2^31 bytes.
inline constexpr std::size_t kMostCompared = std::size_t{1} << 24;

/// Returns the verdict that the two counts are equal at every sample, front and back. A violation
/// names the first sample that differs. `property` completes the message "coverage differs from
/// ...".
Verdict SameCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                   std::uint64_t exercised, const std::string& property);

/// Returns checks that the case, drawn with its own options, has the counts of the profile's
/// canonical model.
///
/// What the profile leaves open of a sample (shared ties, triangles without area) legal::Allowed
/// says. If a mesh is judged as it is shown (as_shown.h), only whether a sample is covered is
/// compared, not how often.
///
/// Domain:     a case and a description that outlive what is returned.
Checks CompareWithTheModel(const PlacedCase& c, const Description& subject);

/// Returns checks that a drawing option changes no count. The case is drawn with the option at
/// `base`, then with each of the other values, always without culling and scissor. `whose`
/// completes the message "coverage differs from ...".
///
/// Domain:     a case that outlives what is returned.
template <class Option>
Checks CompareOption(const PlacedCase& c, Option DrawOptions::* option, Option base,
                     const std::vector<Option>& others, std::string (*whose)(Option value)) {
  DrawOptions options = WholeTarget(c);
  options.*option = base;
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  for (const Option value : others) {
    options.*option = value;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(c.scene, c.profile, options),
        [&c, value, whose](const CoverageCounts& observed, const CoverageCounts& drawn) {
          return SameCounts(observed, drawn, DecisionsOf(c), whose(value));
        }));
  }
  return asked;
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_REDRAW_H_
