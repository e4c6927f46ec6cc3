// The keys of a profile that say what is left to the rasterizer.
#ifndef RASTERPROOF_IO_FREEDOM_JSON_H_
#define RASTERPROOF_IO_FREEDOM_JSON_H_

#include <string>

#include "core/freedom.h"
#include "io/json_document.h"

namespace rasterproof::io {

/// Reads the keys that are there; the others stay as they are.
///
/// Error:      InputError with place, reason and remedy.
void ReadFreedom(const JsonValue& profile, Freedom& freedom);

/// The keys of a freedom, each after `line`.
std::string FreedomToJson(const Freedom& freedom, const std::string& line);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_FREEDOM_JSON_H_
