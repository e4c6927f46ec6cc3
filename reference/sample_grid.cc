#include "reference/sample_grid.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace rasterproof::reference {
namespace {

/// The smallest n in [low, high] for which reached(n + offset), which grows with n; high if none.
template <class Reached>
int FirstSample(double x, double offset, int low, int high, const Reached& reached) {
  if (!(x > low + offset - 1)) return low;
  if (x >= high + offset) return high;
  // |x| is now below 2^18, so the difference is off by less than 1 and its floor by at most 1.
  int n = std::clamp(static_cast<int>(std::floor(x - offset)) - 1, low, high);
  while (n < high && !reached(n + offset)) ++n;
  return n;
}

}  // namespace

void RequireShape(const Scene& scene, const SampleGrid& grid, const CoverageCounts& counts) {
  if (counts.width == scene.width && counts.height == scene.height &&
      counts.samples == grid.samples()) {
    return;
  }
  throw InputError("scene " + scene.name, "the counts do not have the target's shape",
                   "make them of the scene's size and the profile's samples");
}

int FirstSampleFrom(double x, double offset, int low, int high) {
  return FirstSample(x, offset, low, high, [x](double at) { return at >= x; });
}

int FirstSampleBeyond(double x, double offset, int low, int high) {
  return FirstSample(x, offset, low, high, [x](double at) { return at > x; });
}

}  // namespace rasterproof::reference
