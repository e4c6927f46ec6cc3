// The sound base of rasterizers that show where they evaluate attributes at a fragment's centroid.
// No stage says it: a centroid is of all samples of a pixel, and stages see one at a time.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_CENTROIDS_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_CENTROIDS_H_

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "subjects/mutants/fixed_point.h"

namespace rasterproof::subjects::mutants {

/// A fragment whose centroid is asked for, in the profile's own axes.
struct CentroidQuestion {
  std::array<Point2, 3> v;      ///< the triangle as it is drawn, on the grid
  Point2 low;                   ///< the pixel's corner of least x and y
  std::vector<Point2> samples;  ///< in the order of their indices
  std::vector<bool> covered;    ///< of them, one at least
  int x = 0;                    ///< the pixel's column

  Point2 Centre() const { return {low.x + 0.5, low.y + 0.5}; }
  bool IsWhole() const;
};

/// Direct3D's: the centre if every sample is covered, else the covered one of least index.
Point2 CentroidOfDirect3D(const CentroidQuestion& q);
/// The corners of what pixel and triangle have in common, in double: none where that is a point.
std::vector<Point2> CommonPolygon(const CentroidQuestion& q);

/// A fragment on its way out.
struct ShownFragment {
  const Outputs& wants;  ///< what the call asks for
  Triangle indices{};    ///< of the triangle, as the call lists it
  std::array<Point2, 3> given{};
  std::array<Point2, 3> placed{};  ///< on the grid
  Point2 at{};                     ///< the sample
  std::array<double, 3> z{};
  // By the vertices that the subject states, in double.
  std::array<double, 3> barycentrics{};
  double depth = 0;
};

/// What the subject states and what it shows.
struct CentroidStages {
  /// The rasterizer that covers samples; its profile is what the subject states.
  FixedStages base = {};
  BarycentricsOf barycentrics_of = BarycentricsOf::kGiven;
  /// Where it evaluates; empty: by Direct3D's rule.
  std::function<Point2(const CentroidQuestion&)> centroid = {};
  /// What it shows at a sample, changed.
  std::function<void(ShownFragment&)> shown = {};
  bool shows_centroids = true;
};

/// A fixed-point rasterizer of eight subpixel bits that shows fragments, and their centroids where
/// it says so, computed in double. Who states `either` shows those of the given vertices.
///
/// Domain:     as Make() of FixedStages.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              CentroidStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_CENTROIDS_H_
