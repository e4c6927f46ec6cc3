// What a library says of itself, checked.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_DESCRIBED_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_DESCRIBED_H_

#include <cstdint>
#include <string>

#include "kit/rasterproof_plugin.h"

namespace rasterproof::subjects {

inline constexpr const char* kPluginSymbol = "rasterproof_plugin_describe";

inline bool Has(const rasterproof_plugin& plugin, std::uint32_t bit) {
  return (plugin.takes & bit) != 0;
}

/// Returns the description in the size that this program knows: what an older library lacks is
/// zero.
///
/// Error:      InputError with the path if it contradicts itself, or is no description.
rasterproof_plugin Described(const rasterproof_plugin* plugin, const std::string& path);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_DESCRIBED_H_
