// Numbers as they are typed on a command line.
#ifndef RASTERPROOF_TOOL_TYPED_NUMBER_H_
#define RASTERPROOF_TOOL_TYPED_NUMBER_H_

#include <cstddef>
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

/// What the longest list of a request leaves to a mesh.
inline constexpr std::size_t kMostListLength = (std::size_t{1} << 26) - (std::size_t{1} << 20);
/// Memory that a triangle of a list takes in this program and a host of a library together, from
/// above: 48 bytes were measured here and as many in the host, 80 here where the oracle draws.
inline constexpr std::size_t kBytesOfATriangle = 160;

/// A number of triangles that fit in a request, in primitive ids and in this machine's memory.
///
/// Error:      InputError that names --list-length, the number and the limit.
std::size_t ParseListLength(const std::string& text);

/// "90", "90s", "10m", "1h": seconds, more than 0.
///
/// Error:      InputError that names the option.
double ParseSeconds(const std::string& option, const std::string& text);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_TYPED_NUMBER_H_
