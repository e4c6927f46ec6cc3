#include "core/verdict.h"

#include <string_view>

namespace rasterproof {

std::string_view OutcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::kHolds:
      return "holds";
    case Outcome::kViolated:
      return "violated";
    case Outcome::kNotExercised:
      return "not exercised";
    case Outcome::kNotApplicable:
      return "not applicable";
    case Outcome::kRefused:
      return "refused";
    case Outcome::kInconclusive:
      return "inconclusive";
  }
  return "";
}

}  // namespace rasterproof
