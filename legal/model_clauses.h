// The legal models of some triangles' samples, as clauses.
#ifndef RASTERPROOF_LEGAL_MODEL_CLAUSES_H_
#define RASTERPROOF_LEGAL_MODEL_CLAUSES_H_

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "legal/solver.h"
#include "legal/triangle_samples.h"

namespace rasterproof::legal {

/// Two triangles, one on each side of a common edge, and a sample that some choice puts on it.
struct CommonEdgeSample {
  const OpenSample* first = nullptr;
  const OpenSample* second = nullptr;
  std::size_t corner = 0;  ///< of `first`, where the edge begins
  /// The corner of `second` that is not on the edge, if some legal model has the two on one side of
  /// it, or one of them without area: then no owner is stated in that model.
  std::optional<std::size_t> opposite;
};

/// Variables for the places of vertices and for coverage, with the clauses that connect them.
class ModelClauses {
 public:
  explicit ModelClauses(const FamilyView& view) : view_(view) {}

  /// Returns the variable that states that the triangle covers the sample.
  ///
  /// Domain:     `open` outlives this.
  Literal Covers(const OpenSample& open);
  /// Adds that exactly one of the two has the sample under every choice that puts it on the edge,
  /// and the two on either side of it.
  void AddOwner(const CommonEdgeSample& edge);
  /// Adds that not all of these decisions hold together.
  ///
  /// Domain:     indices in `open`, which outlives this.
  void AddExclusion(const Exclusion& exclusion, std::span<const OpenSample> open);
  /// Returns a variable that, if true, makes at least `least` and at most `most` of them true.
  Literal Between(std::span<const Literal> literals, int least, int most);

  Solver& solver() { return solver_; }

 private:
  /// One corner's place in a choice.
  struct Place {
    std::size_t triangle;
    std::size_t corner;
    std::size_t place;
  };

  /// Adds that exactly one of the two literals holds where these places are chosen.
  void AddExactlyOne(std::span<const Place> chosen, Literal first, Literal second);
  /// Nothing (0) if the position has one place.
  Literal PlaceOf(std::size_t position, std::size_t place);

  const FamilyView& view_;
  Solver solver_;
  std::unordered_map<std::size_t, std::vector<Literal>> places_;  // by position
  std::unordered_map<const OpenSample*, Literal> covers_;
};

/// Whether the choice of places puts the sample strictly between the ends, on their line.
bool LiesOnEdge(Point2 a, Point2 b, Point2 p);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_MODEL_CLAUSES_H_
