// What all legal models of a scene agree on, sample by sample.
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
  double distance = 0;     ///< of the sample from it, in pixels, where the canonical model puts it
};

/// What legal models say of one triangle alone.
struct TriangleDecided {
  std::vector<std::size_t> must;  ///< samples that every legal model covers, in rising order
  std::vector<std::size_t> may;   ///< those that some cover and others do not, in rising order
  bool is_anything = false;       ///< some legal model may cover any samples: `may` is not listed
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
  std::vector<OpenDecision>
      open;  ///< why each of a triangle's `may` is one, by triangle and sample
  /// Samples of which only bounds are known: more than was searched is open there.
  std::uint64_t bounded = 0;
  /// A step of the coarsest legal grid, in pixels: the unit of the freedom. 0: vertices stay.
  double step = 0;

  /// Whether every legal model covers the sample equally often.
  bool IsDecided(std::size_t sample) const { return (counts[sample] & (counts[sample] - 1)) == 0; }
  int Least(std::size_t sample) const;
  int Most(std::size_t sample) const;
  /// How many samples are open: two legal models of the whole scene cover them differently often.
  std::uint64_t NumberOpen() const;
};

/// Returns how often legal models of the profile cover each sample of the scene.
///
/// Domain:     as JudgeJointly.
/// Returns:    exactly the counts that some legal model has, where `bounded` does not count the
///             sample; there, all between the least and the most. Where `only` says which samples
///             (shape as counts), nothing of the others.
/// Cost:       a scan of each triangle's box for every family, and the solver for each sample that
///             two open triangles share: many times what JudgeJointly takes for a legal drawing.
Decided DecidedSamples(const Scene& scene, const TargetProfile& profile,
                       const std::vector<bool>* only = nullptr);

/// Returns at which samples legal models decide some triangle of the scene differently; everywhere
/// if nothing is stated of one.
///
/// Domain:     as JudgeJointly.
/// Shape:      as counts of the target.
/// Cost:       a scan of each triangle's box for every family.
std::vector<bool> OpenOfSomeTriangle(const Scene& scene, const TargetProfile& profile);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_DECIDED_H_
