// A property of rasterizers, as data: when it applies, what to ask, and how to judge the
// answers.
#ifndef RASTERPROOF_PROPS_PROPERTY_H_
#define RASTERPROOF_PROPS_PROPERTY_H_

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/question.h"
#include "core/verdict.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// One comparison. Its answers may go once it is judged.
struct Check {
  Questions questions;
  /// Pure. Owns what `ask` worked out for it; it may refer to the case and the description, which
  /// outlive it. Never called with answers that end early.
  std::function<Verdict(const Answers&)> judge;
  /// Draws of earlier checks that it reads, numbered from 0 over all draws of the case.
  std::vector<std::size_t> bases = {};
  /// Of its own draws, in a check of Company::kInOrderAlone, those that the subject may refuse or
  /// may not be given: the answer is a drawing without counts, and the draws after it are made.
  std::vector<std::size_t> may_be_refused = {};
};

/// What a property asks about a case.
struct Checks {
  std::vector<Check> checks;
  /// The verdict if there is no check.
  Verdict otherwise = {};
};

/// Nothing is asked: the case does not put the property to the test, and why.
inline Checks NotExercised(std::string why) { return {{}, Verdict::NotExercised(std::move(why))}; }

/// Nothing is asked: what the property asks the oracle about is not decided, and why.
inline Checks NotDecided(const std::string& why) { return {{}, Verdict::NotApplicable(why)}; }

/// Everything is asked and judged at once.
inline Checks OneCheck(Questions questions, std::function<Verdict(const Answers&)> judge) {
  Checks asked;
  asked.checks.push_back({std::move(questions), std::move(judge)});
  return asked;
}

/// A property: a row of a file of props/properties/.
struct Property {
  std::string_view name;  ///< the property: "SharedEdgeSamplesAreCoveredOnce"
  std::string_view
      group;  ///< "edge", "incremental", "barycentric", "values", "coverage", "square",
              ///< "wireframe", "extremes"
  std::string_view clause;  ///< what it enforces, with its source
  /// Clauses of core/clauses/ that require it, by their ids: see AuthorityOf.
  std::span<const std::string_view> required_by = {};
  /// Clauses about exact numbers, which state no error: they require the property of a subject that
  /// states its own.
  std::span<const std::string_view> required_with_error = {};
  /// Whether a profile's own words state it, of those that the gate lets through. nullptr: all do.
  bool (*stated_by)(const Profile&) = nullptr;
  std::string_view tolerance;  ///< the named, proven bound, or "none: exact"
  /// Names of the domains whose cases put this property to the test.
  std::span<const std::string_view> domains;
  /// True if the property is about calls that follow each other: no others may come in between.
  bool is_about_sequence = false;
  /// What it draws does not depend on the case's scene: a smaller one would show the same.
  bool draws_own_scenes = false;
  /// True if it takes as long as many others: where several run at once it is begun before them.
  bool takes_long = false;
  Gate gate = {};
  /// The checks of a case that the gate lets through, in the order in which they are judged, up to
  /// the first violated one. The case is as the property sees it: in window space after the
  /// subject's own transform if it has one, under the model of its target's size.
  Checks (*ask)(const PlacedCase&, const Description&) = nullptr;
  /// A second round: who is to blame for the violation. The first of its checks that is violated
  /// gives the witness; one that is refused is passed over. nullptr: the verdict says it.
  Checks (*blame)(const PlacedCase&, const Verdict&, const Description&) = nullptr;
};

/// Every property, in the order of the documentation.
std::span<const Property> Catalog();
/// nullptr if there is none of that name.
const Property* FindProperty(std::string_view name);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTY_H_
