#include "core/test_vector.h"

namespace rasterproof {

std::string HashText(std::string_view body) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char letter : body) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  }
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15U];
  return text;
}

}  // namespace rasterproof
