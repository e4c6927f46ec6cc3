// What the parser targets share: any text is read, or refused by an InputError; what was read and
// written reads back the same.
#ifndef RASTERPROOF_FUZZ_FILES_PARSER_H_
#define RASTERPROOF_FUZZ_FILES_PARSER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "fuzz/fuzz_target.h"

namespace rasterproof::fuzz {

inline std::string_view TextOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// `read(text)`, or nothing if it refuses the text.
template <class Read>
auto IfRead(const Read& read, std::string_view text) {
  std::optional<decltype(read(text))> value;
  try {
    value = read(text);
  } catch (const InputError&) {
    value.reset();
  }
  return value;
}

/// Fails unless what `write` makes of what `read` makes of the text is a text that both keep.
/// Compared as texts: NaN is not equal to itself.
template <class Read, class Write>
int ReadsBack(std::string_view text, const Read& read, const Write& write) {
  const auto value = IfRead(read, text);
  if (!value) return kLookedAt;
  const std::string written = write(*value);
  const auto again = IfRead(read, written);
  if (!again) Fail("what was written is refused: " + written);
  if (write(*again) != written) Fail("what was written reads back differently: " + written);
  return kLookedAt;
}

}  // namespace rasterproof::fuzz

#endif  // RASTERPROOF_FUZZ_FILES_PARSER_H_
