// The samples of all triangles of a scene: open or decided by the legal models of one family.
#ifndef RASTERPROOF_LEGAL_FAMILY_SAMPLES_H_
#define RASTERPROOF_LEGAL_FAMILY_SAMPLES_H_

#include <cstddef>
#include <vector>

#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"

namespace rasterproof::legal {

/// Domain:     must not be copied or moved, because `common_edges` points into `open`. With `only`
///             it holds just those samples.
struct FamilySamples {
  explicit FamilySamples(const FamilyView& view, const std::vector<bool>* only = nullptr);
  FamilySamples(const FamilySamples&) = delete;
  FamilySamples& operator=(const FamilySamples&) = delete;

  std::vector<OpenSample> open;                   ///< by triangle, then by sample
  std::vector<std::size_t> first_open;            ///< by triangle, and the end
  std::vector<std::vector<std::size_t>> covered;  ///< by triangle: in every legal model
  std::vector<int> facing;                        ///< by triangle, as TriangleSamples::facing
  std::vector<bool> covers_anything;              ///< by triangle
  std::vector<Exclusion> exclusions;              ///< by indices in `open`
  /// Filled if the profile states owners by edge.
  std::vector<CommonEdgeSample> common_edges;

  /// Indices in `open`, by sample of the target.
  std::vector<std::vector<std::size_t>> OpenBySample(std::size_t samples) const;
  /// How many triangles cover each sample in every legal model.
  std::vector<int> CoveredTimes(std::size_t samples) const;
  /// The number of triangles that may cover anything.
  int Anything() const;
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_FAMILY_SAMPLES_H_
