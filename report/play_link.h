// Links to a case in the playground of the browser's page (web/page/scene.mjs reads them).
#ifndef RASTERPROOF_REPORT_PLAY_LINK_H_
#define RASTERPROOF_REPORT_PLAY_LINK_H_

#include <string>

#include "core/case.h"

namespace rasterproof::report {

/// The fragment of an address, "#scene=...", that opens the case's scene: the case file as JSON in
/// base64 for addresses, after its FNV-1a hash of 32 bits, by which the page knows a damaged one.
///
/// Returns:    "" if the playground does not take the scene: more than 256 triangles, or than 2^22
///             pixels.
std::string PlayFragment(const Case& c, const std::string& subject);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PLAY_LINK_H_
