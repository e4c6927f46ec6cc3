// The case as a claim sees it, and the way back to the case as it was given.
#ifndef RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_
#define RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/drawing.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/judging/gate.h"

namespace rasterproof::props {

/// The subject as it is, and what it states.
///
/// Domain:     a subject that outlives what is returned.
Description DescriptionOf(Subject& subject);

/// The subject as claims about the cases that it is given see it: behind a transform of its own, a
/// taker of window space without edge values and weights.
Description AsJudged(Description subject);

/// The places that a subject's own transform takes the vertices of a scene to.
class PlacesOfTransform {
 public:
  /// Domain:     the window-space scene that the transform makes of the clip-space one.
  PlacesOfTransform(const Scene& clip, const Scene& window);

  /// The scene with the vertices that the transform takes to where its own lie.
  ///
  /// Returns:    nothing if a vertex has no such place, or the target is another one: `why`.
  std::optional<Scene> InClipSpace(const Scene& window) const;
  /// Why InClipSpace gave nothing for the scene.
  std::string WhyNot(const Scene& window) const;

 private:
  // A place by its bits: NaN is a place as well, and -0 is not +0.
  using PlaceBits = std::array<std::uint64_t, 2>;
  static PlaceBits PlaceOf(const Vertex& v);
  bool IsOfTheTarget(const Scene& window) const;

  int width_;
  int height_;
  Precision precision_;
  std::map<PlaceBits, Vertex> clip_of_;
};

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

/// The verdict on the case as given: its witness names the triangle by its place there.
Verdict OnTheCaseAsGiven(const JudgedCase& judged, Verdict verdict);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_JUDGED_CASE_H_
