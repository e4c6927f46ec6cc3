// What a property needs before it may judge a subject on a case.
#ifndef RASTERPROOF_PROPS_JUDGING_PRECONDITION_H_
#define RASTERPROOF_PROPS_JUDGING_PRECONDITION_H_

#include <cstdint>
#include <optional>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

struct Need {
  Space space = Space::kWindow;
  /// True for what a watertight subject promises too; false for what only a sample-exact one does.
  /// A sample-exact subject that is free to choose its grid points or tie rule promises no more
  /// than a watertight one: what else it does is judged jointly (OneLegalModelExplainsTheMesh).
  bool watertight_suffices = false;
  /// True for what the contract `closed` promises as well.
  bool closed_suffices = false;
  /// True for what every model has, whichever one the subject chose among the legal ones.
  bool any_model_suffices = false;
  /// True for what every contract promises but `none`.
  bool any_contract_suffices = false;
  /// True if samples that the profile's overdraw leaves open are told from the others.
  bool judges_overdraw = false;
  /// True for what holds though clipping has moved the edges of triangles that leave the profile's
  /// no-clip rectangle.
  bool judges_clipped = false;
};

/// Returns the verdict to give instead of judging, or nothing if the coverage may be judged.
///
/// Not applicable: the subject never takes such scenes, or its contract does not promise the claim.
/// Not exercised:  as CannotDraw says, or a coordinate is beyond the profile's limit, or a triangle
///                 leaves its no-clip rectangle.
std::optional<Verdict> CannotJudgeCoverage(const Subject& subject, const Case& c, const Need& need);

/// The part of CannotJudgeCoverage that asks only whether the subject can be given the scene.
///
/// Not applicable: the subject never takes scenes of this space or precision.
/// Not exercised:  the case is of the other space; it culls or has a scissor, which the subject
///                 does not take; or it is of clip space, under a snapped profile, and not wholly
///                 in front of the eye; or the profile has keys that speak of window space alone.
std::optional<Verdict> CannotDraw(const Subject& subject, const Case& c, Space space);

/// Returns the verdict to give if the case is no window-space scene within the limits: what edge
/// values and weights are asked about. The contract, which is about coverage, plays no part.
std::optional<Verdict> CannotEvaluate(const Subject& subject, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_PRECONDITION_H_
