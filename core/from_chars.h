// std::from_chars of floating-point numbers, which libc++ has from version 20 on.
#ifndef RASTERPROOF_CORE_FROM_CHARS_H_
#define RASTERPROOF_CORE_FROM_CHARS_H_

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <version>

namespace rasterproof {

/// Domain:     text that begins with a digit or a minus; in hexadecimal without "0x".
/// Error:      as std::from_chars: half a unit in the last place.
template <class T>
std::from_chars_result FromChars(const char* first, const char* last, T& value,
                                 std::chars_format format = std::chars_format::general) {
#if defined(__cpp_lib_to_chars)
  return std::from_chars(first, last, value, format);
#else
  // wasi-libc's rounds to nearest, whatever the length.
  const std::size_t prefix = format == std::chars_format::hex ? 2 : 0;
  const std::string text = (prefix == 0 ? "" : "0x") + std::string(first, last);
  char* end = nullptr;
  errno = 0;
  T read = 0;
  if constexpr (std::is_same_v<T, float>) {
    read = std::strtof(text.c_str(), &end);
  } else {
    read = std::strtod(text.c_str(), &end);
  }
  const auto size = static_cast<std::size_t>(end - text.c_str());
  if (size <= prefix) return {first, std::errc::invalid_argument};
  const char* const stop = first + (size - prefix);
  const bool is_out = errno == ERANGE && (read == 0 || std::isinf(read));
  if (is_out) return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc{}};
#endif
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FROM_CHARS_H_
