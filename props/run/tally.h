// What a run adds up to, case by case, whatever engine the cases come from.
#ifndef RASTERPROOF_PROPS_RUN_TALLY_H_
#define RASTERPROOF_PROPS_RUN_TALLY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/result.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/case_places.h"
#include "props/run/counterexample.h"

namespace rasterproof::props {

/// Of the cases that would have put the property to the test, at most so many may be refused:
/// beyond that, what holds was hardly asked. Scenes beyond the profile's limits don't count: who
/// states a limit may refuse what lies beyond it.
inline constexpr double kMostRefusedShare = 0.5;

/// Sums over cases. Adding the sums of two consecutive runs gives the sums of one run over both.
struct Sums : Counts {
  // Cases in which the subject showed the side of this area as the front, where either is legal.
  std::uint64_t positive_fronts = 0;
  std::uint64_t negative_fronts = 0;
  std::vector<std::uint64_t> drawn;       ///< cases of each domain; none of a world
  std::vector<NearEdgeCounts> near_edge;  ///< of each domain
  std::uint64_t not_applicable = 0;       ///< cases that the property did not apply to
  std::string why_not;                    ///< the first reason
  std::uint64_t refused_within_limits = 0;
  std::string why_refused;  ///< the first of those refusals
  CountsOfPlaces places{};  ///< of cases within the limits

  /// Adds the sums of the cases that follow.
  ///
  /// Domain:     sums over the same domains, or none at all.
  void Add(const Sums& next);
};

/// Counts cases, how often they put the property to the test, and how near to edges they came.
class Tally {
 public:
  /// Starts with the property's words and nothing run. Results name the domains that are left
  /// out, last. Of a world no samples near edges are counted: it has them by construction.
  Tally(const Subject& subject, const Property& property, std::uint64_t seed,
        const World* world = nullptr);

  /// The domains that cases are drawn from. Empty if the subject takes none of the property's, and
  /// for a world.
  const std::vector<const Domain*>& domains() const { return domains_; }
  std::uint64_t cases() const { return sums_.cases; }
  const Sums& sums() const { return sums_; }

  /// Adds case `number` of the run, which is one of domains()[number % domains().size()], or of
  /// the world.
  void AddCase(std::uint64_t number, const Case& c, const Verdict& verdict);

  /// Adds the sums of the cases that follow.
  void AddSums(const Sums& next) { sums_.Add(next); }

  /// The result of a run in which nothing was violated. Not a pass if nothing was exercised, if a
  /// near-edge domain gave nothing near an edge, if the subject refused too much, or if it took
  /// one side for the front in some cases and the other side in others.
  PropertyResult Concluded() const;
  /// The result of a run that does not begin.
  PropertyResult NotApplicable(const std::string& why) const;
  /// The result of a run that ended with a case that could not be judged.
  PropertyResult Inconclusive(const std::string& why) const;
  /// The result of a run that was stopped before anything was violated.
  PropertyResult Interrupted() const;
  /// The result of a run that ended with a case that failed; `failing_case` is its name, if any.
  PropertyResult Failed(Counterexample found, std::string failing_case) const;

 private:
  void CountPlacesOf(const CasePlaces& places, bool is_refused);
  std::string SoFar() const;
  std::string DeadDomains() const;
  /// Which side is the front, where that is left to the subject; else empty.
  std::string FrontText() const;

  PropertyResult Counted() const;

  PropertyResult words_;  ///< what is known before any case
  std::string left_out_;  ///< names the domains that are not drawn
  std::vector<const Domain*> domains_;
  Sums sums_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_TALLY_H_
