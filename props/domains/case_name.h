// Names of drawn cases as text.
#ifndef RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
#define RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_

#include <string>
#include <string_view>

#include "core/case.h"

namespace rasterproof::props {

/// Returns "DOMAIN:INDEX@SEED".
std::string ToText(const CaseName& name);

/// Reads the texts of ToText and no others: one case has one name. It does not check that there is
/// such a domain.
///
/// Error:      InputError that states the fault in the name.
CaseName ParseCaseName(std::string_view text);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_CASE_NAME_H_
