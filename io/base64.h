// Bytes as text: base64 of RFC 4648, section 4.
#ifndef RASTERPROOF_IO_BASE64_H_
#define RASTERPROOF_IO_BASE64_H_

#include <optional>
#include <string>
#include <string_view>

namespace rasterproof::io {

/// With padding.
std::string ToBase64(std::string_view bytes);

/// The bytes; padding may be left out. Nothing if a character is none of base64.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_BASE64_H_
