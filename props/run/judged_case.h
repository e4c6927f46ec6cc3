// The case as a property sees it, and the way back to the case as it was given.
#ifndef RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_
#define RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/property.h"
#include "props/run/own_transform.h"

namespace rasterproof::props {

/// The subject as it is, and what it states.
///
/// Domain:     a subject that outlives what is returned.
Description DescriptionOf(Subject& subject);

/// The description that properties see. A subject with its own transform appears as one that takes
/// window space and shows no edge values or barycentrics.
Description AsJudged(Description subject);

/// A case under the model of its target's size; in window space behind a transform of the
/// subject's own; without triangles of zero area where the profile leaves open what they cover.
struct JudgedCase {
  Case value;
  Description subject;
  /// The profile that the subject is judged by, on any target and before its transform.
  Profile stated;
  /// Triangle k of `value` is this one of the case as given. Nothing: all are there.
  std::optional<std::vector<std::size_t>> numbers;
  /// How its draws become the subject's. Nothing: as they are.
  std::optional<PlacesOfTransform> places;
  /// The verdict to give instead of judging it.
  std::optional<Verdict> instead;
};

/// Domain:     a description that outlives the result.
JudgedCase Judged(const Case& given, const Description& subject, bool judges_degenerates);

/// The verdict on the case as given: its witness names the triangle by its place there, or in
/// the scene that was drawn instead.
Verdict RenumberWitness(const JudgedCase& judged, Verdict verdict);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_
