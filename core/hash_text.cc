#include "core/hash_text.h"

namespace rasterproof {

std::string HashText(std::string_view text) {
  const std::uint64_t hash = Fnv1a(text);
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash >> shift & 15U];
  return digits;
}

}  // namespace rasterproof
