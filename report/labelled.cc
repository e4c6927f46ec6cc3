// A picture of pixels with their numbers along two sides and a legend below.
#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "report/letters.h"
#include "report/palette.h"
#include "report/picture.h"

namespace rasterproof::report {
namespace {

constexpr int kLetterGap = 4;
constexpr int kLetterAdvance = kLetterWidth + 1;
constexpr int kLine = kLetterHeight + kLetterGap;

int WidthOf(std::string_view text) { return static_cast<int>(text.size()) * kLetterAdvance; }

void Write(io::Image& image, std::string_view text, int left, int top) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    for (int row = 0; row < kLetterHeight; ++row) {
      for (int column = 0; column < kLetterWidth; ++column) {
        const int x = left + static_cast<int>(k) * kLetterAdvance + column;
        const int y = top + row;
        if (IsInk(text[k], column, row) && x < image.width && y < image.height)
          image.At(x, y) = kInk;
      }
    }
  }
}

// Every how manieth number leaves room between two.
int StepFor(int room, int scale) {
  int step = 1;
  for (const int factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    if (step * scale >= room) break;
    step = factor;
  }
  return step;
}

}  // namespace

io::Image Labelled(const io::Image& pixels, PixelRect view, int scale,
                   std::span<const LegendEntry> legend) {
  const int of_rows = WidthOf(std::to_string(view.y1 - 1)) + kLetterGap;
  int width = of_rows + pixels.width;
  for (const LegendEntry& entry : legend)
    width = std::max(width, kLetterGap + kLetterHeight + kLetterGap + WidthOf(entry.words));
  const int of_legend = static_cast<int>(legend.size()) * kLine + kLetterGap;
  io::Image image(width + kLetterGap, kLine + pixels.height + of_legend);
  std::ranges::fill(image.pixels, kPaper);
  for (int y = 0; y < pixels.height; ++y) {
    for (int x = 0; x < pixels.width; ++x)
      image.At(of_rows + x, kLine + y) =
          pixels.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
                        static_cast<std::size_t>(x)];
  }
  const int widest = WidthOf(std::to_string(view.x1 - 1));
  for (int x = view.x0; x < view.x1; ++x) {
    if (x % StepFor(widest + kLetterAdvance, scale) != 0) continue;
    const std::string number = std::to_string(x);
    const int middle = of_rows + (x - view.x0) * scale + scale / 2;
    Write(image, number, std::max(0, middle - WidthOf(number) / 2), kLetterGap / 2);
  }
  for (int y = view.y0; y < view.y1; ++y) {
    if (y % StepFor(kLine, scale) != 0) continue;
    const std::string number = std::to_string(y);
    const int middle = kLine + (y - view.y0) * scale + scale / 2;
    Write(image, number, of_rows - kLetterGap - WidthOf(number) + 1, middle - kLetterAscent / 2);
  }
  int top = kLine + pixels.height + kLetterGap;
  for (const LegendEntry& entry : legend) {
    for (int y = 0; y < kLetterHeight; ++y) {
      for (int x = 0; x < kLetterHeight; ++x) {
        const bool is_border = x == 0 || y == 0 || x + 1 == kLetterHeight || y + 1 == kLetterHeight;
        image.At(kLetterGap + x, top + y) = is_border ? kFaintInk : entry.colour;
      }
    }
    Write(image, entry.words, kLetterGap + kLetterHeight + kLetterGap, top + 1);
    top += kLine;
  }
  return image;
}

}  // namespace rasterproof::report
