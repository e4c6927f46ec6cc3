#include "io/image.h"

#include <png.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.h"

namespace rasterproof::io {

namespace {

png_image HeaderOf(int width, int height, png_uint_32 format) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = format;
  return header;
}

std::string Encoded(png_image header, const void* pixels, const void* colours) {
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, pixels, 0, colours) == 0) {
    throw std::runtime_error(std::string("libpng: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string EncodePng(const Image& image) {
  return Encoded(HeaderOf(image.width, image.height, PNG_FORMAT_RGB), image.pixels.data(), nullptr);
}

std::string EncodePalettePng(int width, int height, std::span<const std::uint8_t> indices,
                             std::span<const std::array<std::uint8_t, 3>> colours) {
  png_image header = HeaderOf(width, height, PNG_FORMAT_RGB_COLORMAP);
  header.colormap_entries = static_cast<png_uint_32>(colours.size());
  return Encoded(header, indices.data(), colours.data());
}

Image DecodePng(std::string_view bytes, const std::string& place, int width, int height) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const auto refuse = [&]() -> InputError {
    return {place, std::string("can't be read as a PNG picture: ") + header.message,
            "give a picture that other programs open"};
  };
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) throw refuse();
  if (header.width != static_cast<png_uint_32>(width) ||
      header.height != static_cast<png_uint_32>(height)) {
    png_image_free(&header);
    throw InputError(place,
                     "the picture has " + std::to_string(header.width) + " x " +
                         std::to_string(header.height) + " pixels, the target " +
                         std::to_string(width) + " x " + std::to_string(height),
                     "give a picture of the scene's target");
  }
  header.format = PNG_FORMAT_RGB;
  Image image(width, height);
  const png_color black{0, 0, 0};  // under what is transparent
  if (png_image_finish_read(&header, &black, image.pixels.data(), 0, nullptr) == 0) throw refuse();
  return image;
}

}  // namespace rasterproof::io
