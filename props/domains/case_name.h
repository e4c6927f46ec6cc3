// Names of drawn cases: "near-edge:17@1" is case 17 of the domain near-edge under seed 1.
#ifndef RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
#define RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterproof::props {

/// What a case is drawn from, with the input lattice and the profile of the subject that it is
/// drawn for. Neither the property nor the other domains have a part in it.
struct CaseName {
  std::string domain;
  std::uint64_t index = 0;
  std::uint64_t seed = 1;

  friend bool operator==(const CaseName&, const CaseName&) = default;
};

/// Returns "DOMAIN:INDEX@SEED".
std::string ToText(const CaseName& name);

/// Reads what ToText writes, and nothing else: one case has one name. Whether there is such a
/// domain is not looked at.
///
/// Error:      InputError that says what is wrong with the name.
CaseName ParseCaseName(std::string_view text);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
