// What was planted in each mutant, as a cause of docs/causes.md.
#ifndef RASTERPROOF_TOOL_SELFTEST_EXPECTED_CAUSES_H_
#define RASTERPROOF_TOOL_SELFTEST_EXPECTED_CAUSES_H_

#include <string_view>

namespace rasterproof::tool {

/// The names of the causes that are right for the mutant ("mutant:ties-inclusive"), with "|"
/// between them. Empty: no suspect is made for what was planted in it, and to name none is right.
std::string_view ExpectedCauses(std::string_view mutant);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SELFTEST_EXPECTED_CAUSES_H_
