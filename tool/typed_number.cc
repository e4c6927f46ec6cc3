#include "tool/typed_number.h"

#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <system_error>

#include "core/error.h"
#include "fmt/format.h"
#include "tool/progress.h"

namespace rasterproof::tool {

std::uint64_t ParseSeed(const std::string& text) {
  if (text == "random") {
    std::random_device device;
    const std::uint64_t seed = (std::uint64_t{device()} << 32) | device();
    Tell(fmt::format("seed {}\n", seed));
    return seed;
  }
  const InputError fault("--seed " + text, "not a seed",
                         "give an integer of 0 to 2^64 - 1, or 'random'");
  std::size_t used = 0;
  try {
    const std::uint64_t seed = std::stoull(text, &used, 0);
    if (used == text.size() && !text.starts_with('-')) return seed;
  } catch (const std::exception&) {
    throw fault;
  }
  throw fault;
}

int ParseCount(const std::string& option, const std::string& text, int most) {
  int count = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, count);
  if (error == std::errc() && at == end && count >= 1 && count <= most) return count;
  throw InputError(fmt::format("{} {}", option, text), "not a valid count",
                   fmt::format("give an integer of 1 to {}", most));
}

std::size_t ParseListLength(const std::string& text) {
  std::size_t length = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, length);
  const std::string place = fmt::format("--list-length {}", text);
  if (error == std::errc::invalid_argument || at != end || (error == std::errc() && length < 1)) {
    throw InputError(place, "not a valid count",
                     fmt::format("give an integer of 1 to {}", kMostListLength));
  }
  if (error != std::errc() || length > kMostListLength) {
    throw InputError(place,
                     "no longer list can be drawn: a request on a pipe holds 2^26 triangles, and "
                     "primitive ids number 2^31",
                     fmt::format("give an integer of 1 to {}", kMostListLength));
  }
  const auto memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                      static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  if (length > memory / kBytesOfATriangle) {
    throw InputError(place,
                     fmt::format("the list takes {} MiB, and this machine has {} MiB",
                                 length * kBytesOfATriangle >> 20, memory >> 20),
                     fmt::format("give at most {}", memory / kBytesOfATriangle));
  }
  return length;
}

double ParseSeconds(const std::string& option, const std::string& text) {
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const auto used = error == std::errc{} ? static_cast<std::size_t>(end - text.data()) : 0;
  const std::string unit = text.substr(used);
  const double factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (used == 0 || factor == 0 || !(seconds > 0) || seconds > 1e6) {
    throw InputError(option + " " + text, "it is not a time",
                     "give seconds or minutes, as 90s or 10m");
  }
  return seconds * factor;
}

}  // namespace rasterproof::tool
