// Numbers as they are typed on a command line.
#ifndef RASTERPROOF_TOOL_TYPED_NUMBER_H_
#define RASTERPROOF_TOOL_TYPED_NUMBER_H_

#include <cstdint>
#include <string>

namespace rasterproof::tool {

inline constexpr int kMostInABatch = 4096;

/// Returns the number typed; for "random", one drawn here, which is printed.
///
/// Error:      InputError.
std::uint64_t ParseSeed(const std::string& text);

/// A number of 1 to `most` for the option.
///
/// Error:      InputError that names the option.
int ParseCount(const std::string& option, const std::string& text, int most);

/// "90", "90s", "10m", "1h": seconds, more than 0.
///
/// Error:      InputError that names the option.
double ParseSeconds(const std::string& option, const std::string& text);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_TYPED_NUMBER_H_
