// Is there one model among those that a profile allows which explains every triangle of a mesh?
#ifndef RASTERPROOF_PROPS_JUDGING_MODEL_SEARCH_H_
#define RASTERPROOF_PROPS_JUDGING_MODEL_SEARCH_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/case.h"
#include "core/coverage.h"
#include "core/tie_rule.h"
#include "core/vertex.h"

namespace rasterproof::props {

/// The eight consistent tie rules, or only the profile's own.
std::vector<TieRule> AllowedRules(const Profile& profile);

/// Searches the choices that the freedom of a profile leaves: one grid point for every vertex (by
/// position, for snapping is a function of it) and one tie rule for all.
class ModelSearch {
 public:
  /// Domain:     a window-space case of finite vertices; at most kMostTriangles of its triangles
  ///             may be observed.
  explicit ModelSearch(const Case& c);

  static constexpr std::size_t kMostTriangles = 32;

  /// Takes down what the subject drew for triangle `t` of the scene alone: which samples, not of
  /// which facing (some subjects do not tell, and then it is guessed from the canonical model).
  ///
  /// Cost:       two exact draws for each choice of its three grid points (at most 729).
  void Observe(std::size_t t, const CoverageCounts& alone);

  /// Returns whether one choice explains all of these observations (numbered as they came).
  bool Explains(const std::vector<std::size_t>& observations) const;

  /// The smallest set of observations that no choice explains, empty if one explains all: one or
  /// two observations if so few conflict, else a set that loses its conflict with any member.
  std::vector<std::size_t> Conflict() const;

  /// The grid points of vertex `corner` with which the observation is explained by itself.
  std::vector<Point2> PointsOf(std::size_t observation, std::size_t corner) const;

 private:
  // A choice of grid points for the three corners, as indices into the vertices' choices, and the
  // rules (a bit each) under which it draws what was seen.
  struct Choice {
    std::array<std::uint8_t, 3> point;
    std::uint8_t rules;
  };
  struct Observation {
    std::array<std::size_t, 3> vertex;
    std::vector<Choice> explained_by;
  };
  // For each vertex the grid points, a bit each, that are still possible.
  using Possible = std::vector<std::uint16_t>;

  std::uint8_t RulesThatDraw(const std::array<Point2, 3>& corners,
                             const std::vector<std::uint32_t>& seen) const;
  bool Propagate(const std::vector<std::size_t>& observations, unsigned rule,
                 Possible& possible) const;
  bool Search(const std::vector<std::size_t>& observations, unsigned rule, Possible possible) const;

  std::vector<Triangle> triangles_;
  Case one_;  ///< one triangle, placed by choice and not by the profile's snap
  std::vector<TieRule> rules_;
  std::vector<std::size_t> position_of_vertex_;   // by index in the scene
  std::vector<std::vector<Point2>> grid_points_;  // by position
  std::vector<Observation> observations_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MODEL_SEARCH_H_
