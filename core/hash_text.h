// A hash of text that is the same on every machine and in every version.
#ifndef RASTERPROOF_CORE_HASH_TEXT_H_
#define RASTERPROOF_CORE_HASH_TEXT_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterproof {

/// FNV-1a of 64 bits, of a text after that of `hash`.
///
/// Source:     http://www.isthe.com/chongo/tech/comp/fnv/
constexpr std::uint64_t Fnv1a(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325U) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

/// Its sixteen hexadecimal digits, as files state them.
std::string HashText(std::string_view text);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_HASH_TEXT_H_
