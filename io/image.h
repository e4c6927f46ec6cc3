// Images of pixels.
#ifndef RASTERPROOF_IO_IMAGE_H_
#define RASTERPROOF_IO_IMAGE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterproof::io {

/// 8-bit RGB, row-major [height][width], top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  Image() = default;
  Image(int w, int h, std::array<std::uint8_t, 3> fill = {255, 255, 255})
      : width(w),
        height(h),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  std::array<std::uint8_t, 3>& At(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The image as the bytes of a PNG file (libpng).
std::string EncodePng(const Image& image);

/// An image of few colours as the bytes of a PNG file with a palette (libpng): an index into
/// `colours` for each pixel, row-major, top row first.
///
/// Domain:     1 to 256 colours; every index is one of them.
std::string EncodePalettePng(int width, int height, std::span<const std::uint8_t> indices,
                             std::span<const std::array<std::uint8_t, 3>> colours);

/// The picture in the bytes of a PNG file, alpha left out.
///
/// Domain:     the width and height that it must have, 65536 at most. The file's header is asked
///             for them before anything of its size is made.
/// Error:      InputError that names `place`.
Image DecodePng(std::string_view bytes, const std::string& place, int width, int height);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_IMAGE_H_
