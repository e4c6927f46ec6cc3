// Profiles as JSON values.
#ifndef RASTERPROOF_IO_PROFILE_JSON_H_
#define RASTERPROOF_IO_PROFILE_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "io/json_document.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// Returns the profile of a preset's name or of an object. An object may have a preset's name only
/// if it equals the preset, so that comparing names is safe.
///
/// Error:      InputError with place, reason and remedy.
Profile ProfileFromJson(const JsonValue& value);

/// As ProfileToJson().
void WriteProfile(JsonWriter& json, const Profile& profile);
/// The profile on one line as an object, presets too: for readers that do not know them.
std::string WholeProfileLine(const Profile& profile);

std::vector<std::string_view> PresetNames();

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_PROFILE_JSON_H_
