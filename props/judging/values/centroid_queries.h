// The fragments whose centroids are judged, and where each may lie.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_QUERIES_H_

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "core/vertex.h"
#include "exact/half_planes.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/places.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

using PrimitivePlanes = std::shared_ptr<const std::vector<exact::HalfPlane>>;

/// Where a profile lets a fragment's centroid lie.
struct CentroidRegion {
  /// The one point; nothing: any point of the rectangle within the primitive.
  std::optional<Point2> at;
  Point2 low;
  Point2 high;
  /// Hull of the places that legal models give the triangle's corners.
  PrimitivePlanes primitive;
  std::string words;  ///< "the pixel's centre"
};

/// A subject's output at a fragment's centroid.
struct CentroidFragment {
  /// The vertices that the barycentrics belong to, and a covered sample that shows them.
  BarycentricQuery query;
  CentroidRegion region;
  std::array<double, 3> barycentrics{};
  /// NaN where nothing is stated. See BarycentricTolerances() and BarycentricTolerancesInPixel().
  std::array<double, 3> tolerances{};
};

/// The point that the profile states for the pixel of column x and row `row` of which these samples
/// are covered: the centre of one with one sample or, by Direct3D's rule, with all of them; by that
/// rule the covered sample of least index else. Nothing where the rule leaves a region.
///
/// Domain:     a profile that states centroids; some sample is covered.
std::optional<Point2> StatedCentroid(const PlacedCase& c, int x, int row,
                                     const std::vector<bool>& covered);

/// Which samples of an entry's pixel are covered.
std::vector<bool> CoveredInPixel(const Drawing& drawing, std::size_t index);

/// The hull of corners that each lie in their rectangle, grown by what a subject that computes the
/// point itself may round it by. It does not leave the closed pixel, whose sides have values of the
/// format; what states an error of its barycentrics states this with it.
PrimitivePlanes PrimitiveOf(const SubjectInfo& info, const Scene& target,
                            const std::array<LegalPlaces, 3>& places);

/// The region of a pixel of a primitive, of which these samples are covered.
CentroidRegion RegionOf(const PlacedCase& c, const PrimitivePlanes& primitive,
                        const SamplePlace& place, const std::vector<bool>& covered);

/// Returns whether some point of the region has the shown barycentrics within the tolerances,
/// decided exactly; for a stated point, also how far off they are.
///
/// Domain:     stated tolerances. Barycentrics that are not finite match no point.
Distance DistanceFromRegion(const CentroidFragment& fragment);

/// Returns whether any point is legal. None is if the triangle reaches the fragment in no legal
/// model; other properties then report that it is covered at all.
bool HasAPoint(const CentroidRegion& region);

/// Asks for the centroids of a few triangles, each drawn alone to show its coverage, and judges
/// some of their fragments, partly covered ones first.
Checks AskCentroids(const PlacedCase& c, const Description& subject,
                    Verdict (*judge)(const std::vector<CentroidFragment>&));

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_QUERIES_H_
