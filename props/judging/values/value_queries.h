// The values that properties look at, and how far off each may be.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_QUERIES_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/channel.h"
#include "core/compared_numbers.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "core/witness.h"
#include "exact/values.h"
#include "props/judging/places.h"
#include "props/judging/values/centroid_queries.h"
#include "props/judging/values/value_estimates.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// The corners that a fragment's values may be of.
struct ValueOwners {
  /// One triple if the corners are known; else every combination of the ends of the rectangles in
  /// which legal models put them: a value is monotone in each coordinate of a corner as long as its
  /// denominator keeps its sign, so that its least and greatest are among theirs.
  std::vector<RayCorners> corners;
  /// The known corners as they are, without rounding.
  std::optional<exact::HomogeneousTriangle> known;
};

/// A covered sample with the triangle that it shows.
struct ValueFragment {
  std::size_t index = 0;  ///< of the sample in the drawing
  int triangle = 0;
  Triangle vertices{};
  SamplePlace place;
  double reach = 0;  ///< the farthest, on either axis, that the sample may lie from its place
  Point2 centre;     ///< of its pixel
  /// Where values at the centroid are evaluated; nothing: they are not judged.
  std::optional<CentroidRegion> centroid;
  /// Each that may be meant; values of all channels are of the same.
  std::vector<ValueOwners> readings;
};

/// Values that a subject shows of a case, and its statements about them.
struct ShownValues {
  const Drawing& drawing;
  const std::vector<Channel>& channels;
  const ValueRule& rule;
  Precision precision;
  bool is_y_up = false;
  bool is_clip_space = false;
  const Scene* scene = nullptr;  ///< as it was asked about

  /// The depths of the fragment's vertices, in clip space before the division.
  std::array<double, 3> DepthsOf(const ValueFragment& f) const {
    const std::array<Vertex, 3> v = Corners(*scene, f.vertices);
    return {v[0].z, v[1].z, v[2].z};
  }
  double Of(const ValueFragment& f, std::size_t channel) const {
    return drawing.values[f.index * channels.size() + channel];
  }
  const std::array<double, 2>& DerivativesOf(const ValueFragment& f, std::size_t channel) const {
    return drawing.derivatives[f.index * channels.size() + channel];
  }
};

/// What a value may be: from `low` to `high`, each within `margin`, and `tolerance` beyond.
struct ValueRange {
  double low = 0;
  double high = 0;
  double margin = 0;
  double tolerance = 0;

  /// Whether the number is surely allowed, or surely not.
  bool SurelyHolds(double x) const {
    const double unsure = Unsure();
    return x >= low - tolerance + unsure && x <= high + tolerance - unsure;
  }
  bool SurelyExcludes(double x) const {
    const double unsure = Unsure();
    return !(x >= low - tolerance - unsure && x <= high + tolerance + unsure);
  }

 private:
  // The margin, and what these sums round.
  double Unsure() const {
    return margin + 0x1p-50 * (std::fabs(low) + std::fabs(high) + tolerance + margin);
  }
};

/// The numbers of a channel at the fragment's vertices, in the triangle's order; ones for 1/w.
std::array<double, 3> NumbersAt(const ValueFragment& f, const Channel& channel);

/// Where the channel is evaluated; at the centroid, of a fragment that says where that is.
Point2 PlaceOfValue(const ValueFragment& f, const Channel& channel);

/// What the value may be by these owners. Nothing where it is not judged: the triangle has no area
/// or its horizon may lie on the sample; the subject states no error, and what the usual forms
/// compute may overflow, or the triangle reaches the plane of the eye or is far from it.
///
/// Domain:     an interpolation other than kFlat.
std::optional<ValueRange> RangeOf(const ShownValues& shown, const ValueFragment& f,
                                  const ValueOwners& owners, const Channel& channel,
                                  const std::array<double, 3>& numbers);

/// The most that a derivative may be off beside its ulps: of the plane at a point (both ends are
/// it), or a difference of the values at both. Nothing where it is not judged, as in RangeOf().
std::optional<double> DerivativeTolerance(const ShownValues& shown, const ValueFragment& f,
                                          const RayCorners& v, const Channel& channel, int axis,
                                          const std::array<Point2, 2>& ends);

/// What became of one shown number.
struct ValueCheck {
  bool is_judged = false;
  bool holds = true;
  double ratio = 0;  ///< of the distance to the tolerance
  /// Whether the number would not hold if two vertices' numbers were exchanged, or, in clip space,
  /// if the plane were that of the screen instead of the triangle's, or the other way round.
  bool tells = false;
  /// Whether only the width of the stated error keeps it from telling.
  bool is_too_wide = false;
  WitnessValue expected = {};
};

/// Holds a shown number to RangeOf(): exactly, where the owners are known.
ValueCheck CheckValue(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners,
                      const Channel& channel, const std::array<double, 3>& numbers, double x);

/// Whether the point where the channel is evaluated lies in the closed triangle by all owners.
bool IsInside(const ValueFragment& f, const ValueOwners& owners, const Channel& channel);

/// Judges one fragment by one of its readings.
using ValueJudge = Verdict (*)(const ShownValues& shown, const ValueFragment& f,
                               const ValueOwners& owners);

/// The outputs that a question about values wants.
inline constexpr Outputs kValuesAlone{.primitive_ids = true,
                                      .barycentrics = false,
                                      .depths = false,
                                      .centroids = false,
                                      .values = true};

/// Which covered samples are judged.
enum class FragmentChoice : std::uint8_t {
  kSome,            ///< a few, evenly spread
  kAtVertices,      ///< those at a known corner of the triangle that they show
  kOnTheFirstEdge,  ///< those on its edge from the first corner to the second, if known
  kInPartOfAPixel   ///< those of pixels with uncovered samples, if there are any
};

/// Some covered samples of a drawing of the case.
std::vector<ValueFragment> FragmentsOf(const PlacedCase& c, const SubjectInfo& info,
                                       const Drawing& drawing, FragmentChoice choice);

/// The case's scene with the channels that are asked for.
std::shared_ptr<const Scene> SceneWithChannels(const PlacedCase& c);

/// Asks for what `wants` says of SceneWithChannels(), and judges some covered samples: each holds
/// if it does by one of its readings. If a scene's transform to the window is the subject's own,
/// nothing is asked.
Checks AskValues(const PlacedCase& c, const Description& subject, const Outputs& wants,
                 ValueJudge judge, FragmentChoice choice = FragmentChoice::kSome);

/// Asks likewise for barycentrics or depths, of vertices at depths in [0, 1] that we choose. Their
/// stated error is that of the subject's fragments.
Checks AskFragmentValues(const PlacedCase& c, const Description& subject, const Outputs& wants,
                         ValueJudge judge);

/// The verdict on one fragment: of the first reading by which it is not violated, or else of the
/// first.
Verdict JudgeFragment(const ShownValues& shown, const ValueFragment& f, ValueJudge judge);

/// A covered sample of the drawing as a fragment of the case. `readings`: its triangle's, if known.
ValueFragment FragmentAt(const PlacedCase& c, const SubjectInfo& info, const Drawing& drawing,
                         std::size_t index, const std::vector<ValueOwners>* readings = nullptr);

/// A violation at a fragment. `what` completes "the value ...". `kind` says which number failed;
/// `to_the_bit`, that nothing is allowed.
Verdict ValueViolation(const ValueFragment& f, const Channel& channel, const std::string& what,
                       WitnessValue observed, WitnessValue expected,
                       NumberKind kind = NumberKind::kValue, bool to_the_bit = false);

/// A violation by a depth or a barycentric.
Verdict NumberViolation(NumberKind kind, const std::string& what, Witness witness);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_VALUE_QUERIES_H_
