#include "exact/edge.h"

#include <stdexcept>
#include <string_view>

#include "core/tie_rule.h"
#include "core/vertex.h"
#include "exact/deciders.h"
#include "exact/environment.h"
#include "exact/rational.h"
#include "exact/signs.h"
#include "exact/tie.h"

namespace rasterproof::exact {

std::string_view DeciderName(Decider decider) {
  switch (decider) {
    case Decider::kFast:
      return "fast";
    case Decider::kIntegers:
      return "integers";
    case Decider::kCgal:
      return "cgal";
  }
  return "";
}

TierScope::TierScope() : start_(ThreadTiers()) {}

TierCounts TierScope::Counts() const {
  const TierCounts& now = ThreadTiers();
  return {now.filter - start_.filter, now.stable - start_.stable, now.exact - start_.exact,
          now.symbolic - start_.symbolic};
}

void CreditTiers(const TierCounts& kept) { ThreadTiers() += kept; }

int EdgeSign(Point2 a, Point2 b, Point2 p, Decider decider) {
  if (decider == Decider::kIntegers) return IntegerEdgeSign(a, b, p);
  if (decider == Decider::kCgal) return CgalEdgeSign(a, b, p);
  const TieredSign decided = FastEdgeSign(a, b, p);
  ++(ThreadTiers().*decided.tier);
  return decided.sign;
}

int ShiftedEdgeSign(Point2 a, Point2 b, Point2 p, const TieRule& rule, Decider decider) {
  // dE/dx = b.y - a.y and dE/dy = -(b.x - a.x); comparing gives their signs without rounding.
  const auto tie = [&] {
    return TieSign((b.y > a.y) - (b.y < a.y), (a.x > b.x) - (a.x < b.x), rule);
  };
  if (decider != Decider::kFast) {
    const int sign = EdgeSign(a, b, p, decider);
    return sign != 0 ? sign : tie();
  }
  const TieredSign decided = FastEdgeSign(a, b, p);
  ++(ThreadTiers().*(decided.sign != 0 ? decided.tier : &TierCounts::symbolic));
  return decided.sign != 0 ? decided.sign : tie();
}

Rational EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (Rational(p.x) - a.x) * (Rational(b.y) - a.y) -
         (Rational(p.y) - a.y) * (Rational(b.x) - a.x);
}

void RequireHonestEnvironment() {
  const Environment environment = InspectEnvironment();
  if (!environment.Honest()) throw std::logic_error(environment.Complaint());
}

}  // namespace rasterproof::exact
