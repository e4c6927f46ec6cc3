// What a channel may hold at a fragment's centroid.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_VALUES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_VALUES_H_

#include "core/channel.h"
#include "core/subject_info.h"
#include "props/judging/values/centroid_queries.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Where the centroid of a triangle's fragment may lie. Its primitive is null where it is not
/// known: in clip space on a grid.
///
/// Domain:     the drawing is of that triangle alone; a profile that states centroids.
CentroidRegion CentroidOf(const PlacedCase& c, const SubjectInfo& info, const Drawing& drawing,
                          const ValueFragment& f);

/// Holds a number to what the channel is at the stated centroid, or at some point of its region.
///
/// The value is a quotient of affine functions. Where the denominator keeps its sign, as it does in
/// all of a pixel that is judged, its least and greatest are at the pixel's corners, and the points
/// where it is within given bounds are those of two half planes. With known owners it is decided
/// whether these, the primitive and the pixel meet; with others, whether the pixel alone has such a
/// value. `tells`: the values in the pixel are farther apart than the tolerance.
///
/// Domain:     `f.centroid` is there; an interpolation other than kFlat. Not judged in a region:
///             kInverseW, and corners that are not all in front of the eye.
/// Error:      the tolerance in a region is of the largest number in the pixel, whose condition is
///             largest at a corner, too.
ValueCheck CheckCentroidValue(const ShownValues& shown, const ValueFragment& f,
                              const ValueOwners& owners, const Channel& channel, double x);

/// Whether some point of the region has the numbers that all channels at the centroid show there.
///
/// Domain:     `f.centroid` is there; each of the numbers holds by CheckCentroidValue().
/// Returns:    true also where owners are not known, and of channels that are not judged.
bool AreOfOnePoint(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_CENTROID_VALUES_H_
