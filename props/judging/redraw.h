// Drawing a case, or a variation of it, and comparing the counts.
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

/// Asks for the counts of a scene, from zero, by facing: what properties about counts compare with
/// an oracle.
DrawQuestion CountsOf(const Scene& scene, const Profile& profile, const DrawOptions& options);
/// The same of triangle t alone, of a scene that several draws share.
DrawQuestion CountsOfOne(const std::shared_ptr<const Scene>& scene, std::size_t t,
                         const Profile& profile, const DrawOptions& options);
/// Asks for the coverage and the ids that one call shows of a scene: what properties compare draws
/// by. Made of parts, a mesh would be the same triangles alone in whatever order.
DrawQuestion WholeCallOf(const Scene& scene, const Profile& profile, const DrawOptions& options);

/// A draw that later checks compare with: nothing is judged. Its drawing is number 0 of the case.
Check BaseDraw(DrawQuestion question);
/// Asks for a draw, and judges it against the base draw.
Check CheckAgainstBase(
    DrawQuestion question,
    std::function<Verdict(const CoverageCounts& observed, const CoverageCounts& base)> judge);

/// Another scene that should cover what the case covers.
struct Variation {
  Scene scene;
  std::string property;  ///< completes "coverage differs from ..."
};

/// Asks for the case and its variations, culling and scissor off, each in one call, and holds if
/// what they show is the same but where calls may differ.
///
/// Domain:     a case that outlives what is returned.
Checks CompareVariations(const PlacedCase& c, const std::vector<Variation>& variations,
                         const OpenByCall& open = {});

/// Whether a target of this size is one that subjects are asked for, and the profile places
/// vertices on it as on the case's own: a profile can state another model for other sizes.
bool HasTheModelOf(const PlacedCase& c, int width, int height);

/// How many samples of the target lie in the bounding boxes of the case's finite triangles, or a
/// step of its grid beside them: the number of inside-or-outside decisions that a draw puts to the
/// test. Clip space: every sample for each finite triangle.
std::uint64_t DecisionsOf(const PlacedCase& c);

/// What the canonical model of the case's profile counts under another tie rule.
CoverageCounts CoverageUnder(const PlacedCase& c, const TieRule& rule, const DrawOptions& options);

/// The counts within the rectangle, and zero elsewhere.
CoverageCounts CutTo(const PixelRect& rect, const CoverageCounts& whole);

/// The verdict, with the draw that failed, if one did.
Verdict OfDraw(std::size_t draw, Verdict verdict);

/// Holds if the counts are equal; else violated, with the first sample that differs.
///
/// `property` completes the sentence of the message: "coverage differs from ...".
Verdict SameCounts(const CoverageCounts& observed, const CoverageCounts& expected,
                   std::uint64_t exercised, const std::string& property);

/// Asks for the case as its options say. Holds if the counts are those of the profile's canonical
/// model, or what is left of them where the profile allows edge_samples; of a mesh that is judged
/// as it is shown, if what is covered is what the model covers.
///
/// Domain:     a case and a description that outlive what is returned.
Checks CompareWithTheModel(const PlacedCase& c, const Description& subject);

/// Asks for the case, culling and scissor off, with a drawing option at `base` and at each of the
/// others, and holds if the option leaves no trace. `whose` completes "coverage differs from ...".
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
