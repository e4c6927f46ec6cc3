#include "props/domains/case_name.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.h"

namespace rasterproof::props {
namespace {

std::string Place(std::string_view text) { return "case '" + std::string(text) + "'"; }

// `what` is "index" or "seed".
std::uint64_t ParseNumber(std::string_view text, std::string_view what, std::string_view name) {
  const std::string digits(text);
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error == std::errc{} && stop == end && std::to_string(number) == digits) return number;
  throw InputError(Place(name), "'" + digits + "' is no " + std::string(what),
                   "give a whole number of 0 to 2^64 - 1, in digits and without leading zeros");
}

}  // namespace

std::string ToText(const CaseName& name) {
  return name.domain + ":" + std::to_string(name.index) + "@" + std::to_string(name.seed);
}

CaseName ParseCaseName(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::size_t at = text.find('@', colon == text.npos ? 0 : colon);
  if (colon == text.npos || at == text.npos || colon == 0) {
    throw InputError(Place(text), "it is not the name of a case",
                     "give DOMAIN:INDEX@SEED, such as near-edge:17@1; 'rasterproof list domains' "
                     "names the domains");
  }
  return {std::string(text.substr(0, colon)),
          ParseNumber(text.substr(colon + 1, at - colon - 1), "index", text),
          ParseNumber(text.substr(at + 1), "seed", text)};
}

}  // namespace rasterproof::props
