// The legal models of small scenes, by the definition: every place of every vertex, one after the
// other.
#ifndef RASTERPROOF_TESTS_LEGAL_ALL_MODELS_H_
#define RASTERPROOF_TESTS_LEGAL_ALL_MODELS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "core/vertex.h"

namespace rasterproof::legal::testing {

/// The number of pixels on a side of the targets of AScene().
inline constexpr int kSide = 3;

/// The vertices of a scene, where one model has them.
using Model = std::vector<Point2>;
/// Drawings of each triangle alone: [triangle][sample].
using Drawn = std::vector<std::vector<bool>>;

/// Returns whether the model and the rule explain the drawing of each triangle alone.
bool ExplainsAlone(const Scene& scene, const Profile& profile, const TieRule& rule,
                   const Model& model, const Drawn& drawn);
/// Returns whether the model lets some set of triangles cover the sample, for some owners, that
/// `accepts`: bit t is set if triangle t does.
bool ExplainsSetAt(const Scene& scene, const Profile& profile, const TieRule& rule,
                   const Model& model, std::size_t s,
                   const std::function<bool(unsigned bits)>& accepts);
/// Returns whether the model lets `count` triangles cover the sample, for some owners.
bool ExplainsCountAt(const Scene& scene, const Profile& profile, const TieRule& rule,
                     const Model& model, std::size_t s, std::uint32_t count);
/// As ExplainsCountAt, for every sample.
bool ExplainsCounts(const Scene& scene, const Profile& profile, const TieRule& rule,
                    const Model& model, const CoverageCounts& counts);
/// Whether some legal grid, tie rule and model explain.
bool IsLegalBySearch(const Scene& scene, const Profile& profile,
                     const std::function<bool(const TieRule&, const Model&)>& explains);
/// Returns how many triangles legal models let cover the sample: bit n is set if n can.
std::uint64_t NumbersBySearch(const Scene& scene, const Profile& profile, std::size_t s);
/// Whether some model explains the counts at these samples.
bool ExplainsAt(const Scene& scene, const Profile& profile, const CoverageCounts& counts,
                const std::vector<std::size_t>& samples);

/// Counts of each triangle.
std::vector<CoverageCounts> AsCounts(const Scene& scene, const Drawn& drawn);

/// Whether the search says what the joint verdict says: no two vertices share a position, which the
/// search moves apart.
bool IsJudgedAlike(const Scene& scene);

/// Random scenes, profiles and legal drawings.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : bits_(seed) {}
  std::size_t Below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }

  /// Two or three triangles around shared edges, their coordinates on eighths of a pixel.
  Scene AScene();
  /// One triangle or two with a common edge, most of them flat or thinner than a step, on targets
  /// of 2 to 5 pixels a side; coordinates on eighths of a pixel.
  Scene AThinScene();
  Profile AProfile();
  /// What a random legal model draws, as a rule with random owners.
  Drawn ALegalDrawing(const Scene& scene, const Profile& profile);
  /// The sum of such drawings, a model for each column of samples.
  CoverageCounts AMixture(const Scene& scene, const Profile& profile);
  /// Counts of a legal drawing but for one or two samples.
  CoverageCounts ANearMiss(const Scene& scene, const Profile& profile);

 private:
  std::mt19937_64 bits_;
};

}  // namespace rasterproof::legal::testing

#endif  // RASTERPROOF_TESTS_LEGAL_ALL_MODELS_H_
