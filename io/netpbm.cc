#include "io/netpbm.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "core/sample_text.h"

namespace rasterproof::io {
namespace {

constexpr std::uint32_t kMostOf16Bits = 65535;
constexpr std::uint32_t kMostOf8Bits = 255;
constexpr std::string_view kBlanks = " \t\n\v\f\r";

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// Reads one file from its start to its end.
class NetpbmReader {
 public:
  NetpbmReader(std::string_view bytes, const std::string& place) : rest_(bytes), place_(place) {}

  Levels Read(int width, int height) {
    const char kind = rest_.size() > 1 ? rest_[1] : '0';
    if (kind != '2' && kind != '3' && kind != '5' && kind != '6') {
      throw InputError(place_, "the kind P" + std::string(1, kind) + " of Netpbm is not read",
                       "write PGM or PPM: P2, P3, P5 or P6");
    }
    rest_.remove_prefix(2);
    const std::uint32_t wide = HeaderNumber("width");
    const std::uint32_t high = HeaderNumber("height");
    if (wide != static_cast<std::uint32_t>(width) || high != static_cast<std::uint32_t>(height)) {
      throw InputError(place_,
                       "the picture has " + std::to_string(wide) + " x " + std::to_string(high) +
                           " pixels, the target " + std::to_string(width) + " x " +
                           std::to_string(height),
                       "give a picture of the scene's target");
    }
    Levels levels;
    levels.channels = kind == '3' || kind == '6' ? 3 : 1;
    levels.greatest = HeaderNumber("greatest level");
    if (levels.greatest == 0 || levels.greatest > kMostOf16Bits) {
      throw InputError(place_,
                       "the greatest level is " + std::to_string(levels.greatest) +
                           ", and the format has 1 to 65535",
                       "write 255 or 65535");
    }
    width_ = width;
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                             static_cast<std::size_t>(levels.channels);
    if (kind == '2' || kind == '3') {
      ReadAsText(size, levels);
    } else {
      ReadAsBytes(size, levels);
    }
    RequireEnd();
    return levels;
  }

 private:
  // Blanks, and comments to the end of their line.
  void SkipBlanks() {
    while (!rest_.empty()) {
      if (rest_.front() == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (kBlanks.find(rest_.front()) != std::string_view::npos) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  // A number of decimal digits that ends at a blank, a comment or the end; 0 digits: false.
  bool ReadNumber(std::uint32_t& number) {
    SkipBlanks();
    if (rest_.empty() || !IsDigit(rest_.front())) return false;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return rest_.empty() || rest_.front() == '#' || kBlanks.find(rest_.front()) != kBlanks.npos;
  }

  std::uint32_t HeaderNumber(const std::string& what) {
    std::uint32_t number = 0;
    if (ReadNumber(number)) return number;
    throw InputError(place_, "its header has no " + what,
                     "begin it with P5, the width, the height and 255");
  }

  std::string PlaceOf(std::size_t k, int channels) const {
    return PixelText(k / static_cast<std::size_t>(channels), width_);
  }

  void Add(std::uint32_t level, Levels& levels) const {
    if (level > levels.greatest) {
      throw InputError(place_ + ": " + PlaceOf(levels.values.size(), levels.channels),
                       "the level " + std::to_string(level) + " is above the greatest, " +
                           std::to_string(levels.greatest),
                       "write the greatest level into the header");
    }
    levels.values.push_back(static_cast<std::uint16_t>(level));
  }

  void ReadAsText(std::size_t size, Levels& levels) {
    constexpr std::size_t kLeastLength = 2;  // of a level and what parts it from the next
    if (rest_.size() < kLeastLength * size) {
      throw InputError(place_, "it ends before its last row", "write the whole picture");
    }
    levels.values.reserve(size);
    while (levels.values.size() < size) {
      std::uint32_t level = 0;
      if (!ReadNumber(level)) {
        throw InputError(place_ + ": " + PlaceOf(levels.values.size(), levels.channels),
                         rest_.empty() ? "it ends there" : "there is no level",
                         "write whole numbers with blanks between them");
      }
      Add(level, levels);
    }
  }

  void ReadAsBytes(std::size_t size, Levels& levels) {
    if (rest_.empty() || kBlanks.find(rest_.front()) == std::string_view::npos) {
      throw InputError(place_, "no blank follows the header", "write one blank, then the pixels");
    }
    rest_.remove_prefix(1);
    const std::size_t width = levels.greatest > kMostOf8Bits ? 2 : 1;  // bytes of a level
    if (rest_.size() < size * width) {
      throw InputError(place_,
                       "it has " + std::to_string(rest_.size()) +
                           " bytes of pixels, and its size " + "takes " +
                           std::to_string(size * width),
                       "write the whole picture");
    }
    levels.values.reserve(size);
    for (std::size_t k = 0; k < size; ++k) {
      std::uint32_t level = 0;
      for (std::size_t b = 0; b < width; ++b)
        level = level << 8 | static_cast<std::uint8_t>(rest_[width * k + b]);
      Add(level, levels);
    }
    rest_.remove_prefix(size * width);
  }

  void RequireEnd() const {
    if (rest_.find_first_not_of(kBlanks) == std::string_view::npos) return;
    throw InputError(place_, "it continues after the last row",
                     "give a file of one picture whose header says its size");
  }

  std::string_view rest_;
  const std::string& place_;
  int width_ = 1;
};

std::string HeaderText(char kind, int width, int height, std::uint32_t greatest) {
  return std::string("P") + kind + "\n" + std::to_string(width) + " " + std::to_string(height) +
         "\n" + std::to_string(greatest) + "\n";
}

std::string EncodePpm(const Image& image) {
  std::string bytes = HeaderText('6', image.width, image.height, kMostOf8Bits);
  for (const auto& pixel : image.pixels) {
    for (const std::uint8_t channel : pixel) bytes += static_cast<char>(channel);
  }
  return bytes;
}

}  // namespace

bool IsNetpbm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && IsDigit(bytes[1]) &&
         (bytes[2] == '#' || kBlanks.find(bytes[2]) != std::string_view::npos);
}

Levels DecodeNetpbm(std::string_view bytes, const std::string& place, int width, int height) {
  return NetpbmReader(bytes, place).Read(width, height);
}

std::string EncodePgm(int width, int height, std::span<const std::uint32_t> levels,
                      const std::string& place) {
  const std::uint32_t most = levels.empty() ? 0 : *std::ranges::max_element(levels);
  if (most > kMostOf16Bits) {
    throw InputError(place, "a level is " + std::to_string(most) + ", and PGM has 16 bits",
                     "write rows of text");
  }
  const bool has_two_bytes = most > kMostOf8Bits;
  std::string bytes = HeaderText('5', width, height, has_two_bytes ? kMostOf16Bits : kMostOf8Bits);
  for (const std::uint32_t level : levels) {
    if (has_two_bytes) bytes += static_cast<char>(level >> 8);
    bytes += static_cast<char>(level & kMostOf8Bits);
  }
  return bytes;
}

std::string EncodeFor(const std::string& path, const Image& image) {
  if (path.ends_with(".ppm")) return EncodePpm(image);
  for (const char* other : {".jpg", ".jpeg", ".gif", ".bmp", ".tga", ".webp", ".svg"}) {
    if (path.ends_with(other)) {
      throw InputError(Quoted(path), "pictures are written as PNG or PPM", "name it .png or .ppm");
    }
  }
  if (!path.ends_with(".pgm")) return EncodePng(image);
  std::vector<std::uint32_t> levels;
  levels.reserve(image.pixels.size());
  for (const auto& pixel : image.pixels) {
    if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) {
      throw InputError(Quoted(path), "the picture has colours, and PGM has none",
                       "write it to .png or .ppm");
    }
    levels.push_back(pixel[0]);
  }
  return EncodePgm(image.width, image.height, levels, Quoted(path));
}

}  // namespace rasterproof::io
