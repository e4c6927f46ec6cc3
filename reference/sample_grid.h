// Where a profile's samples lie, seen with y down.
#ifndef RASTERPROOF_REFERENCE_SAMPLE_GRID_H_
#define RASTERPROOF_REFERENCE_SAMPLE_GRID_H_

#include <cstddef>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::reference {

/// The samples of a target: sample s of column i and row r (from the top) lies at
/// (i + offset[s].x, r + offset[s].y) with y down.
///
/// With y up, row r is pixel row height - 1 - r, and its samples at y = height - 1 - r + l.y. The
/// only change made to a vertex is y -> -y; the samples follow: -y = r + (1 - height - l.y).
/// Everything is a multiple of 2^-8 below 2^17: exact.
struct SampleGrid {
  std::vector<Point2> offsets;
  bool y_up = false;

  SampleGrid(const Profile& profile, int height) : y_up(profile.y_axis == YAxis::kUp) {
    for (const Point2& l : profile.pattern.locations) {
      offsets.push_back({l.x, y_up ? 1 - height - l.y : l.y});
    }
  }
  int samples() const { return static_cast<int>(offsets.size()); }
  /// A vertex seen with y down.
  double Y(double y) const { return y_up ? -y : y; }
};

/// Throws InputError unless the counts have the scene's size and the grid's samples.
void RequireShape(const Scene& scene, const SampleGrid& grid, const CoverageCounts& counts);

/// Returns the smallest n in [low, high] with n + offset >= x (beyond: > x); high if there is none.
///
/// Domain:     any x, NaN included (returns low); |offset| < 2^17, a multiple of 2^-8.
/// Error:      none.
int FirstSampleFrom(double x, double offset, int low, int high);
int FirstSampleBeyond(double x, double offset, int low, int high);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_SAMPLE_GRID_H_
