// Pictures as Netpbm files: PGM of grey levels, PPM of colours.
#ifndef RASTERPROOF_IO_NETPBM_H_
#define RASTERPROOF_IO_NETPBM_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/image.h"

namespace rasterproof::io {

/// The numbers of a picture, as its file has them.
struct Levels {
  int channels = 1;            ///< 1: grey; 3: red, green, blue
  std::uint32_t greatest = 0;  ///< the level of white: 1 to 65535
  /// Shape:      row-major [height][width][channel], top row first.
  std::vector<std::uint16_t> values;
};

/// Whether the bytes begin as a Netpbm file does: P and a digit.
bool IsNetpbm(std::string_view bytes);

/// Reads a PGM or a PPM file, as text or as bytes (P2, P3, P5, P6), of 8 or 16 bits.
///
/// Domain:     the width and height that it must have, which its header is asked for before
///             anything of its size is made.
/// Error:      InputError that names `place`: another kind or size, a file that is cut off, a level
///             above the greatest.
/// Source:     netpbm.sourceforge.net/doc/pgm.html and ppm.html; 16 bits have the high byte first.
Levels DecodeNetpbm(std::string_view bytes, const std::string& place, int width, int height);

/// Grey levels as the bytes of a PGM file: of 8 bits, or of 16 if one needs them.
///
/// Domain:     width * height levels.
/// Error:      InputError that names `place` if a level is above 65535.
std::string EncodePgm(int width, int height, std::span<const std::uint32_t> levels,
                      const std::string& place);

/// The picture in the form that the path's ending names: .ppm; .pgm, if it has grey levels alone;
/// else PNG.
///
/// Error:      InputError if it has colours and the path ends in .pgm.
std::string EncodeFor(const std::string& path, const Image& image);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_NETPBM_H_
