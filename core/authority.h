// Who requires a property of a subject: a specification, the subject itself, or its users.
#ifndef RASTERPROOF_CORE_AUTHORITY_H_
#define RASTERPROOF_CORE_AUTHORITY_H_

#include <cstdint>
#include <string_view>

namespace rasterproof {

enum class Authority : std::uint8_t {
  kClause,       ///< a sentence of the specification that the profile is named after
  kStatedModel,  ///< the profile's own words, or the bounds that the subject states
  kQuality       ///< not required. Violations are reported; by default they do not fail a run
};

/// "clause", "stated model", "quality".
constexpr std::string_view AuthorityName(Authority authority) {
  if (authority == Authority::kClause) return "clause";
  return authority == Authority::kStatedModel ? "stated model" : "quality";
}

/// Which violations fail a run.
enum class FailOn : std::uint8_t {
  kStated,  ///< violations of a clause or of the stated model
  kQuality  ///< all violations
};

constexpr bool Fails(Authority authority, FailOn fail_on) {
  return authority != Authority::kQuality || fail_on == FailOn::kQuality;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_AUTHORITY_H_
