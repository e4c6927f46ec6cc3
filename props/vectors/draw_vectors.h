// Drawn cases as test vectors: a scene with the samples that legal drawings agree on.
#ifndef RASTERPROOF_PROPS_VECTORS_DRAW_VECTORS_H_
#define RASTERPROOF_PROPS_VECTORS_DRAW_VECTORS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/test_vector.h"

namespace rasterproof::props {

/// The longest side of a vector's target, in pixels, and its most triangles and vertices.
inline constexpr int kMostVectorSide = 64;
inline constexpr std::size_t kMostVectorTriangles = 16;
inline constexpr std::size_t kMostVectorVertices = 64;

struct VectorChoice {
  std::uint64_t seed = 1;
  std::uint64_t cases = 500;
  /// Only cases with vertices in units of the lattice.
  bool only_on_lattice = false;
  /// With values: for profiles of one model.
  bool with_values = false;
};

/// Throws InputError if no vectors can be made for the profile: single samples are not what it
/// states, or it does not state where they lie.
void RequireStatesSamples(const Profile& profile);

/// The bits of the lattice that vertices are written in: those of the profile's grid, and at least
/// 8 where it has none or lies off the origin.
int LatticeBitsOf(const Profile& profile);

/// The ids of the clauses that require what vectors of the profile state: of single triangles, or
/// of several at one sample. Empty if the profile is no specification's: its own words require it.
std::vector<std::string> SampleClausesOf(const Profile& profile);
std::vector<std::string> JointClausesOf(const Profile& profile);

/// The case as a vector, drawn without culling and without a scissor. Nothing if it is none: it is
/// larger than the constants above, in clip space, beyond the profile's limits, or nothing is
/// stated of any of its triangles.
///
/// Returns:    triangles as legal::DecideAlone() decides them; where several models are legal, also
///             what they share.
std::optional<TestVector> VectorOf(const Case& c, const VectorChoice& choice);

/// Draws vectors from every domain in turn and hands each to `take`, until there are as many as
/// chosen, no domain has more, or `take` says false. A domain has no more after 256 cases in
/// succession that are none. The same choice gives the same vectors in the same order.
///
/// Returns:    how many were taken.
std::uint64_t DrawVectors(const Profile& profile, const VectorChoice& choice,
                          const std::function<bool(const TestVector&)>& take);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_VECTORS_DRAW_VECTORS_H_
