// The samples of a scene on which all legal models agree.
#ifndef RASTERPROOF_LEGAL_DECIDED_H_
#define RASTERPROOF_LEGAL_DECIDED_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/scene.h"
#include "core/vertex.h"
#include "model/target_profile.h"

namespace rasterproof::legal {

/// Counts saturate at this value.
inline constexpr int kMostCounted = 63;

/// A triangle and a sample that legal models decide differently.
struct OpenDecision {
  std::size_t triangle = 0;
  std::size_t sample = 0;  ///< index in counts of the target
  int edge = -1;           ///< the nearest one, opposite vertex `edge`
  double distance = 0;     ///< from the sample to it in the canonical model, in pixels
};

/// The coverage of one triangle alone in legal models.
struct TriangleDecided {
  std::vector<std::size_t> must;  ///< samples that every legal model covers, in rising order
  std::vector<std::size_t> may;   ///< samples that some cover and others do not, in rising order
  bool is_anything = false;       ///< some legal model may cover any samples: `may` is not listed
  /// +1 or -1: counter-clockwise or clockwise on screen in every legal model; 0: they differ, or it
  /// has no area.
  int facing = 0;
};

struct Decided {
  int width = 0;
  int height = 0;
  int samples = 1;
  /// By sample: bit k is set if some legal model covers the sample k times.
  ///
  /// Shape:      as CoverageCounts.
  std::vector<std::uint64_t> counts;
  std::vector<TriangleDecided> triangles;
  std::vector<OpenDecision> open;  ///< the reason for each sample in `may`, by triangle and sample
  /// Samples with known bounds only: too many decisions are open there to search.
  std::uint64_t bounded = 0;
  /// A step of the coarsest legal grid, in pixels: the unit of the freedom. 0: vertices stay.
  double step = 0;

  /// Whether every legal model covers the sample equally often.
  bool IsDecided(std::size_t sample) const { return (counts[sample] & (counts[sample] - 1)) == 0; }
  int Least(std::size_t sample) const;
  int Most(std::size_t sample) const;
  /// How many samples are open: two legal models of the whole scene count them differently.
  std::uint64_t NumberOpen() const;
};

/// Returns how often legal models of the profile cover each sample of the scene.
///
/// Domain:     as JudgeJointly.
/// Returns:    exactly the counts of legal models; for samples counted in `bounded`, all counts
///             between the least and the most. With `only` (shape as counts), just those samples.
/// Cost:       a scan of each triangle's box for every family, and the solver for each sample that
///             two open triangles share: many times what JudgeJointly takes for a legal drawing.
Decided DecidedSamples(const Scene& scene, const TargetProfile& profile,
                       const std::vector<bool>* only = nullptr);

/// Returns the samples at which legal models decide some triangle of the scene differently: all
/// samples if nothing is stated of a triangle.
///
/// Domain:     as JudgeJointly.
/// Shape:      as counts of the target.
/// Cost:       a scan of each triangle's box for every family.
std::vector<bool> OpenOfSomeTriangle(const Scene& scene, const TargetProfile& profile);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_DECIDED_H_
