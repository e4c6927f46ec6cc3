// A property: a claim about a rasterizer, as a plain function, with what it needs to be put to the
// test.
#ifndef RASTERPROOF_PROPS_PROPERTY_H_
#define RASTERPROOF_PROPS_PROPERTY_H_

#include <span>
#include <string_view>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

/// A claim. One per file of props/catalog/.
struct Property {
  std::string_view name;  ///< the claim: "SharedEdgeSamplesAreCoveredOnce"
  std::string_view
      group;  ///< "edge", "incremental", "barycentric", "coverage", "wireframe", "extremes"
  std::string_view clause;        ///< what it enforces, with its source
  std::string_view precondition;  ///< when it applies, in words; the function checks it
  std::string_view tolerance;     ///< the named, proven bound, or "none: exact"
  /// Names of the domains whose cases put this claim to the test.
  std::span<const std::string_view> domains;
  /// Never throws for a legal subject; says kNotApplicable or kNotExercised rather than passing
  /// vacuously.
  Verdict (*check)(Subject&, const Case&);
  /// True if the claim is about calls that follow each other: no others may come in between.
  bool is_about_sequence = false;
};

/// Every property, in the order of the documentation.
std::span<const Property> Catalog();
/// nullptr if there is none of that name.
const Property* FindProperty(std::string_view name);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTY_H_
