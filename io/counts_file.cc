#include "io/counts_file.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/quoted.h"
#include "io/image.h"
#include "io/output.h"

namespace rasterproof::io {
namespace {

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

CountsFile FromPicture(std::string_view bytes, const std::string& path, CoverageCounts shape,
                       const std::string& background) {
  const std::array<std::uint8_t, 3> paper = ColourFrom(background);
  if (shape.samples != 1) {
    throw InputError(
        path, "a picture has one sample a pixel, the target " + std::to_string(shape.samples),
        "give counts as text");
  }
  const Image image = DecodePng(bytes, path, shape.width, shape.height);
  for (std::size_t k = 0; k < shape.size(); ++k) {
    shape.front[k] = image.pixels[k] == paper ? 0 : 1;
  }
  return {std::move(shape), true};
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
      throw InputError(place, "is no list of counts", "write whole numbers, space-separated");
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

CountsFile FromText(std::string_view text, const std::string& path, CoverageCounts counts) {
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
  if (row == rows) return {std::move(counts), false};
  throw InputError(path, "has " + std::to_string(row) + " rows, the target " + std::to_string(rows),
                   "give one row of counts for each row of pixels");
}

}  // namespace

CountsFile ReadCounts(const std::string& path, int width, int height, int samples,
                      const std::string& background) {
  const std::string bytes = ReadFile(path);
  CoverageCounts shape(width, height, samples);
  constexpr std::string_view kPngBegins = "\x89PNG";
  if (bytes.starts_with(kPngBegins)) return FromPicture(bytes, path, std::move(shape), background);
  return FromText(bytes, path, std::move(shape));
}

}  // namespace rasterproof::io
