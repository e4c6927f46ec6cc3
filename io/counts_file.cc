#include "io/counts_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "core/quoted.h"
#include "core/sample_text.h"
#include "io/image.h"
#include "io/netpbm.h"
#include "io/output.h"

namespace rasterproof::io {
namespace {

constexpr std::string_view kPngBegins = "\x89PNG";

std::array<std::uint8_t, 3> ColourFrom(const std::string& text) {
  std::uint32_t rgb = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, rgb, 16);
  if (text.size() != 6 || error != std::errc() || read != end) {
    throw InputError("--background " + Quoted(text), "is no colour",
                     "write six hexadecimal digits: 000000 is black");
  }
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

std::size_t PixelsOf(const CountsFormat& format) {
  return CoverageCounts::Size(format.width, format.height, 1);
}

// Bytes alone, which are what their number says.
Levels FromRaw(std::string_view bytes, const std::string& path, const CountsFormat& format) {
  const std::size_t pixels = PixelsOf(format);
  Levels levels{1, 255, {}};
  if (bytes.size() == 3 * pixels || bytes.size() == 4 * pixels) {
    levels.channels = 3;
  } else if (bytes.size() != pixels) {
    throw InputError(path,
                     "has " + std::to_string(bytes.size()) + " bytes, the target " +
                         std::to_string(format.width) + " x " + std::to_string(format.height) +
                         " pixels",
                     "give 1, 3 or 4 bytes a pixel: " + std::to_string(pixels) + ", " +
                         std::to_string(3 * pixels) + " or " + std::to_string(4 * pixels));
  }
  const std::size_t stride = bytes.size() / pixels;
  for (std::size_t p = 0; p < pixels; ++p) {
    for (int c = 0; c < levels.channels; ++c) {
      levels.values.push_back(
          static_cast<std::uint8_t>(bytes[p * stride + static_cast<std::size_t>(c)]));
    }
  }
  return levels;
}

bool IsRaw(const std::string& path) { return path.ends_with(".raw"); }

// Whether a pixel of levels has the colour: a level of `greatest` is what 255 is of 8 bits.
bool HasColour(const Levels& levels, std::size_t pixel, const std::array<std::uint8_t, 3>& colour) {
  constexpr std::uint32_t kWhite = 255;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t at = levels.channels == 1 ? pixel : 3 * pixel + c;
    if (kWhite * levels.values[at] != colour[c] * levels.greatest) return false;
  }
  return true;
}

// A level of 8 bits that is this one, or nearest to it.
std::uint8_t EightBits(const Levels& levels, std::size_t at) {
  const std::uint64_t doubled = 2 * std::uint64_t{255} * levels.values[at];
  return static_cast<std::uint8_t>((doubled + levels.greatest) /
                                   (2 * std::uint64_t{levels.greatest}));
}

// `colour_at` gives the colour of a pixel by its index.
std::vector<std::string> CornersOf(const CountsFormat& format, const CoverageCounts& mask,
                                   const auto& colour_at) {
  const auto width = static_cast<std::size_t>(format.width);
  std::vector<std::string> corners;
  for (const std::size_t k : {std::size_t{0}, width - 1, mask.size() - width, mask.size() - 1}) {
    if (mask.front[k] == 0) continue;
    std::string text;
    for (const std::uint8_t level : std::array<std::uint8_t, 3>(colour_at(k))) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      text += {kDigits[level / 16U], kDigits[level % 16U]};
    }
    if (std::ranges::find(corners, text) == corners.end()) corners.push_back(text);
  }
  return corners;
}

CountsFile FromPicture(std::string_view bytes, const std::string& path,
                       const CountsFormat& format) {
  const std::array<std::uint8_t, 3> paper = ColourFrom(format.background);
  if (format.samples != 1) {
    throw InputError(
        path, "a picture has one sample a pixel, the target " + std::to_string(format.samples),
        "give counts, as text or with --counts");
  }
  CoverageCounts counts(format.width, format.height);
  std::vector<std::string> corners;
  if (!IsRaw(path) && bytes.starts_with(kPngBegins)) {
    const Image image = DecodePng(bytes, path, format.width, format.height);
    for (std::size_t k = 0; k < counts.size(); ++k)
      counts.front[k] = image.pixels[k] == paper ? 0 : 1;
    corners = CornersOf(format, counts, [&](std::size_t k) { return image.pixels[k]; });
  } else {
    const Levels levels = IsRaw(path) ? FromRaw(bytes, path, format)
                                      : DecodeNetpbm(bytes, path, format.width, format.height);
    for (std::size_t k = 0; k < counts.size(); ++k)
      counts.front[k] = HasColour(levels, k, paper) ? 0 : 1;
    corners = CornersOf(format, counts, [&](std::size_t k) {
      const std::size_t at = levels.channels == 1 ? k : 3 * k;
      const std::size_t step = levels.channels == 1 ? 0 : 1;
      return std::array{EightBits(levels, at), EightBits(levels, at + step),
                        EightBits(levels, at + 2 * step)};
    });
  }
  return {std::move(counts), true, {}, std::move(corners)};
}

// Numbers without a header, low byte first.
std::vector<std::uint32_t> NumbersFromRaw(std::string_view bytes, const std::string& path,
                                          const CountsFormat& format) {
  const std::size_t size = CoverageCounts::Size(format.width, format.height, format.samples);
  const std::size_t width = bytes.size() / size;
  if (bytes.size() % size != 0 || (width != 1 && width != 2 && width != 4)) {
    throw InputError(path,
                     "has " + std::to_string(bytes.size()) + " bytes, the target " +
                         std::to_string(size) + " samples",
                     "give 1, 2 or 4 bytes a sample, low byte first");
  }
  std::vector<std::uint32_t> numbers(size);
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t b = 0; b < width; ++b)
      numbers[k] |= std::uint32_t{static_cast<std::uint8_t>(bytes[k * width + b])} << (8 * b);
  }
  return numbers;
}

std::vector<std::uint32_t> NumbersFromPicture(std::string_view bytes, const std::string& path,
                                              const CountsFormat& format) {
  if (IsRaw(path)) return NumbersFromRaw(bytes, path, format);
  const std::string remedy = "give PGM, raw bytes or rows of text";
  if (!IsNetpbm(bytes)) throw InputError(path, "a PNG picture holds colours, not numbers", remedy);
  const Levels levels = DecodeNetpbm(bytes, path, format.width * format.samples, format.height);
  if (levels.channels != 1)
    throw InputError(path, "a PPM picture holds colours, not numbers", remedy);
  return {levels.values.begin(), levels.values.end()};
}

// 1 + the number of a triangle, or 0.
std::vector<std::int32_t> IdsFrom(const std::vector<std::uint32_t>& numbers,
                                  const std::string& path, const CountsFormat& format) {
  std::vector<std::int32_t> ids;
  ids.reserve(numbers.size());
  for (const std::uint32_t number : numbers) {
    if (number > format.triangles) {
      throw InputError(path + ": " + SampleText(ids.size(), format.width, format.samples),
                       "the id is " + std::to_string(number) + ", and the scene has " +
                           std::to_string(format.triangles) + " triangles",
                       "write 1 + the triangle's number, from 0, and 0 where there is none");
    }
    ids.push_back(number == 0 ? kNoPrimitive : static_cast<std::int32_t>(number - 1));
  }
  return ids;
}

// One row of numbers.
void ReadRow(std::string_view line, std::size_t number, const std::string& path,
             CoverageCounts& counts, std::size_t row_length) {
  const std::string place = path + ": line " + std::to_string(number + 1);
  std::size_t column = 0;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end) {
    if (*at == ' ' || *at == '\t' || *at == '\r') {
      ++at;
      continue;
    }
    std::uint32_t count = 0;
    const auto [next, error] = std::from_chars(at, end, count);
    if (error != std::errc()) {
      throw InputError(place, "is not a list of counts", "write whole numbers, space-separated");
    }
    if (column < row_length) counts.front[number * row_length + column] = count;
    ++column;
    at = next;
  }
  if (column != row_length) {
    throw InputError(place,
                     "has " + std::to_string(column) + " counts, the target " +
                         std::to_string(row_length) + " samples a row",
                     "give one count for each sample");
  }
}

CoverageCounts FromText(std::string_view text, const std::string& path,
                        const CountsFormat& format) {
  CoverageCounts counts(format.width, format.height, format.samples);
  const auto rows = static_cast<std::size_t>(counts.height);
  const std::size_t row_length =
      static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
  std::size_t row = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (row < rows) ReadRow(line, row, path, counts, row_length);
    ++row;
  }
  if (row == rows) return counts;
  throw InputError(path, "has " + std::to_string(row) + " rows, the target " + std::to_string(rows),
                   "give one row of counts for each row of pixels");
}

// Levels of grey as shares of white: of `samples` how many.
std::uint32_t CoveredBy(std::uint32_t level, std::uint32_t white, int samples,
                        const std::string& place) {
  const auto all = static_cast<std::uint32_t>(samples);
  const std::uint32_t covered = (2 * level * all + white) / (2 * white);  // the nearest share
  const std::int64_t off = std::int64_t{level} * all - std::int64_t{white} * covered;
  // A level of 8 bits either way, whatever the picture's depth.
  const std::int64_t slack = std::max<std::int64_t>(white / 255, 1) * all;
  if (std::abs(off) <= slack) return covered;
  throw InputError(place,
                   "the level " + std::to_string(level) + " of " + std::to_string(white) +
                       " is not a share of " + std::to_string(samples) + " samples",
                   "draw white on black, without dithering, gamma or blending");
}

std::vector<std::uint32_t> CoveredInPicture(std::string_view bytes, const std::string& path,
                                            int width, int height, int samples) {
  Levels levels;
  if (bytes.starts_with(kPngBegins)) {
    levels.channels = 3;
    levels.greatest = 255;
    for (const auto& pixel : DecodePng(bytes, path, width, height).pixels)
      levels.values.insert(levels.values.end(), pixel.begin(), pixel.end());
  } else {
    levels = DecodeNetpbm(bytes, path, width, height);
  }
  std::vector<std::uint32_t> covered;
  const auto channels = static_cast<std::size_t>(levels.channels);
  for (std::size_t at = 0; at < levels.values.size(); at += channels) {
    const std::string place = path + ": " + PixelText(covered.size(), width);
    for (std::size_t c = 1; c < channels; ++c) {
      if (levels.values[at + c] == levels.values[at]) continue;
      throw InputError(place, "it has a colour", "draw white triangles on black");
    }
    covered.push_back(CoveredBy(levels.values[at], levels.greatest, samples, place));
  }
  return covered;
}

}  // namespace

std::vector<std::uint32_t> ReadCovered(const std::string& path, int width, int height,
                                       int samples) {
  const std::string bytes = ReadFile(path);
  if (bytes.starts_with(kPngBegins) || IsNetpbm(bytes))
    return CoveredInPicture(bytes, path, width, height, samples);
  const CountsFormat format{.width = width, .height = height};
  std::vector<std::uint32_t> covered = FromText(bytes, path, format).front;
  for (std::size_t k = 0; k < covered.size(); ++k) {
    if (covered[k] <= static_cast<std::uint32_t>(samples)) continue;
    throw InputError(path + ": " + PixelText(k, width),
                     std::to_string(covered[k]) + " samples are covered, and a pixel has " +
                         std::to_string(samples),
                     "give how many of a pixel's samples are covered, or leave out --resolved");
  }
  return covered;
}

CountsFile CountsFrom(std::vector<std::uint32_t> numbers, const std::string& place,
                      const CountsFormat& format) {
  CountsFile file;
  file.counts = CoverageCounts(format.width, format.height, format.samples);
  if (numbers.size() != file.counts.size()) {
    throw InputError(place,
                     "has " + std::to_string(numbers.size()) + " numbers, the target " +
                         std::to_string(file.counts.size()) + " samples",
                     "give one number for each sample");
  }
  file.is_mask = format.holds == FileHolds::kDrawing;
  if (file.is_mask) {
    for (std::uint32_t& number : numbers) number = number == 0 ? 0 : 1;
  }
  file.counts.front = std::move(numbers);
  if (format.holds == FileHolds::kIds)
    file.primitive_ids = IdsFrom(std::exchange(file.counts.front, {}), place, format);
  return file;
}

CountsFile ReadCounts(const std::string& path, const CountsFormat& format) {
  const std::string bytes = ReadFile(path);
  const bool is_picture = bytes.starts_with(kPngBegins) || IsNetpbm(bytes) || IsRaw(path);
  if (is_picture && format.holds == FileHolds::kDrawing) return FromPicture(bytes, path, format);
  CountsFormat numbers = format;
  if (!is_picture && format.holds == FileHolds::kDrawing) numbers.holds = FileHolds::kCounts;
  return CountsFrom(
      is_picture ? NumbersFromPicture(bytes, path, format) : FromText(bytes, path, format).front,
      path, numbers);
}

}  // namespace rasterproof::io
