// The certificate of a page that judged a GPU: its verdict, derived again from its answers.
#ifndef RASTERPROOF_TOOL_CERTIFY_PASSPORT_H_
#define RASTERPROOF_TOOL_CERTIFY_PASSPORT_H_

#include <string>

namespace rasterproof::tool {

/// Draws the cases again that the certificate names by seed and version, judges them by the answers
/// recorded in it, and prints the verdict. That the device gave these answers is taken on trust.
///
/// Returns:    the status of the verdict; kExitInconclusive where there is none.
/// Error:      InputError with the place: it is no certificate, its cases are not those of its seed
///             and of this version, or its verdict does not follow.
int RunPassport(const std::string& path);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_PASSPORT_H_
