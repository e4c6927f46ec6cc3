// Names of drawn cases: "near-edge:17@1" is case 17 of the domain near-edge under seed 1.
#ifndef RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
#define RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterproof::props {

/// The name of a case. It determines the case together with the subject's input lattice and
/// profile; neither the property nor the other domains matter.
struct CaseName {
  std::string domain;
  std::uint64_t index = 0;
  std::uint64_t seed = 1;

  friend bool operator==(const CaseName&, const CaseName&) = default;
};

/// Returns "DOMAIN:INDEX@SEED".
std::string ToText(const CaseName& name);

/// Reads the texts of ToText and no others: one case has one name. It does not check that there is
/// such a domain.
///
/// Error:      InputError that states the fault in the name.
CaseName ParseCaseName(std::string_view text);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
