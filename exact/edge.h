// Exact signs of edge functions: the oracle's root.
#ifndef RASTERPROOF_EXACT_EDGE_H_
#define RASTERPROOF_EXACT_EDGE_H_

#include <cstdint>
#include <string_view>

#include "core/counters.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::exact {

/// Three deciders, independent of each other.
enum class Decider : std::uint8_t {
  kFast,      ///< filter, stable, wide integers: the daily work
  kIntegers,  ///< Boost.Multiprecision checked fixed-width integers; no floating point in it
  kCgal       ///< CGAL's kernels
};
std::string_view DeciderName(Decider decider);

/// Counts the decisions of the fast path in this thread while the scope lives. Scopes may nest: an
/// outer scope counts the decisions in its inner scopes too.
class TierScope {
 public:
  TierScope();
  TierScope(const TierScope&) = delete;
  TierScope& operator=(const TierScope&) = delete;

  TierCounts Counts() const;

 private:
  TierCounts start_;
};

/// Adds decisions to every scope that lives in this thread. A caller that reuses a result of an
/// earlier call adds the decisions that the result took.
void CreditTiers(const TierCounts& kept);

/// Returns the sign of E(a, b; p) = (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x).
///
/// Domain:     every finite double, subnormals and the largest included.
/// Returns:    +1 if a, b, p turn counter-clockwise on screen (y down), -1 if clockwise, 0 if
///             collinear.
/// Error:      none.
/// Properties: EdgeSign(b, a, p) == -EdgeSign(a, b, p) == EdgeSign(a, p, b).
int EdgeSign(Point2 a, Point2 b, Point2 p, Decider decider = Decider::kFast);

/// The sign of E(a, b; p) at p shifted as the tie rule says. 0 only if a == b (or E == 0
/// and the rule is inclusive or exclusive).
int ShiftedEdgeSign(Point2 a, Point2 b, Point2 p, const TieRule& rule,
                    Decider decider = Decider::kFast);

/// E(a, b; p) itself.
Rational EdgeValue(Point2 a, Point2 b, Point2 p);

/// Throws std::logic_error naming the reason if rounding mode, FTZ/DAZ, contraction or valgrind
/// would make the oracle wrong. The library does not call it: programs that use the oracle without
/// the command should, before their first verdict. Cheap.
void RequireHonestEnvironment();

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_EDGE_H_
