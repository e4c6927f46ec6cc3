// The failing place in characters, for a terminal.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "report/explanation_numbers.h"
#include "report/overview.h"
#include "report/picture.h"
#include "report/pixel_state.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Three panels of 40 pixels, two characters each, fill a wide terminal.
constexpr int kMostTextPixels = 40;
constexpr std::size_t kWidestTitle = 10;  // "difference"

// Select-graphic-rendition codes of the 256-colour palette, nearest to the pictures' colours.
constexpr std::string_view kPlain = "\x1b[0m";
constexpr std::string_view kDim = "\x1b[2m";
constexpr std::string_view kMissingColour = "\x1b[1;38;5;202m";
constexpr std::string_view kUnexpectedColour = "\x1b[1;38;5;33m";
constexpr std::string_view kFacingColour = "\x1b[1;38;5;176m";

char CountCharacter(std::uint64_t count) {
  if (count == 0) return '.';
  return count <= 9 ? static_cast<char>('0' + count) : '#';
}

char StateCharacter(SampleState state) {
  switch (state) {
    case SampleState::kRight:
      return '.';
    case SampleState::kMissing:
      return '-';
    case SampleState::kUnexpected:
      return '+';
    case SampleState::kFacing:
      return '!';
  }
  return '?';
}

std::string_view StateCode(SampleState state) {
  switch (state) {
    case SampleState::kRight:
      return kDim;
    case SampleState::kMissing:
      return kMissingColour;
    case SampleState::kUnexpected:
      return kUnexpectedColour;
    case SampleState::kFacing:
      return kFacingColour;
  }
  return kPlain;
}

std::string Coloured(char c, std::string_view code) {
  return fmt::format("{}{}{}", code, c, kPlain);
}

// One pixel in one of the panels.
std::string PixelCell(const Pixel& pixel, std::size_t panel, bool colour) {
  if (panel == 2) {
    const char c = StateCharacter(pixel.state);
    return colour ? Coloured(c, StateCode(pixel.state)) : std::string(1, c);
  }
  const char c = CountCharacter(panel == 0 ? pixel.expected : pixel.observed);
  const bool loud = panel == 1 && pixel.state != SampleState::kRight;
  if (!colour || (c != '.' && !loud)) return std::string(1, c);
  return Coloured(c, loud ? StateCode(pixel.state) : kDim);
}

// One pixel of numbers: of several samples the one that is farthest off.
std::string NumberCell(const ComparedNumber* number, const NumberScale& scale, std::size_t panel,
                       bool colour) {
  if (number == nullptr) return colour ? Coloured(' ', kPlain) : " ";
  const char c = panel == 2
                     ? OffCharacter(number->off)
                     : NumberCharacter(scale, panel == 0 ? number->expected : number->observed);
  if (!colour || panel == 0 || std::fabs(number->off) <= 1) return std::string(1, c);
  return Coloured(c, number->off < 0 ? kUnexpectedColour : kMissingColour);
}

// Returns one row of one panel: for each pixel a cell and the character before it, and one
// character more.
std::string Row(const Explanation& explanation, const PixelRect& view, int y, std::size_t panel,
                bool colour) {
  std::string row;
  for (int x = view.x0; x <= view.x1; ++x) {
    const bool here = y == explanation.focus_y;
    const bool opens = here && x == explanation.focus_x && x < view.x1;
    const bool closes = here && x == explanation.focus_x + 1 && x > view.x0;
    row += opens ? '[' : closes ? ']' : ' ';
    if (x == view.x1) break;
    if (HasNumbers(explanation)) {
      row += NumberCell(NumberAt(explanation, x, y), ScaleOf(*explanation.numbers), panel, colour);
      continue;
    }
    row += PixelCell(PixelAt(explanation.observed, explanation.expected, x, y), panel, colour);
  }
  return row;
}

std::string LegendOfNumbers(const Explanation& explanation) {
  const NumberScale scale = ScaleOf(*explanation.numbers);
  return fmt::format(
      "numbers: 0 to 9 from {} to {}, < below, > above, ? none   difference: . within what is "
      "allowed  - below  + above   [ ] the pixel in question",
      ShortNumber(scale.low), ShortNumber(scale.high));
}

std::string Legend(const Explanation& explanation) {
  if (HasNumbers(explanation)) return LegendOfNumbers(explanation);
  std::string legend = "counts: . none, 1 to 9, # more";
  if (explanation.expected.samples > 1) {
    legend += fmt::format(" (over {} samples)", explanation.expected.samples);
  }
  if (PanelTitles(explanation).size() == 3) {
    legend += "   difference: . right  - missing  + unexpected  ! facing";
  }
  if (explanation.focus_x >= 0) legend += "   [ ] the pixel in question";
  return legend;
}

}  // namespace

std::string ExplanationToText(const Explanation& explanation, bool colour) {
  const PixelRect view = ReadableView(explanation, kMostTextPixels);
  const std::size_t gutter = fmt::format("{}", std::max(view.y1 - 1, 0)).size() + 1;
  const auto panel_width = 2 * static_cast<std::size_t>(view.x1 - view.x0) + 1;
  const std::size_t column = std::max(panel_width, kWidestTitle + 2) + 3;
  std::string text;
  if (!explanation.headline.empty()) text += CleanText(explanation.headline) + "\n";
  text += fmt::format("{:>{}} columns {} to {}, rows {} to {}\n", "", gutter, view.x0, view.x1 - 1,
                      view.y0, view.y1 - 1);
  if (const auto overview = OverviewOf(explanation, view)) text += OverviewText(*overview) + "\n";
  std::string titles = std::string(gutter, ' ');
  const std::span<const std::string_view> panels = PanelTitles(explanation);
  for (const std::string_view panel : panels) titles += fmt::format(" {:<{}}", panel, column - 1);
  titles.erase(titles.find_last_not_of(' ') + 1);
  text += titles + "\n";
  for (int y = view.y0; y < view.y1; ++y) {
    text += fmt::format("{:>{}}", y, gutter);
    for (std::size_t panel = 0; panel < panels.size(); ++panel) {
      text += Row(explanation, view, y, panel, colour);
      if (panel + 1 < panels.size()) text += std::string(column - panel_width, ' ');
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  text += Legend(explanation) + "\n";
  for (const std::string& line : explanation.edge_values) text += CleanText(line) + "\n";
  if (!explanation.replay.empty()) text += "replay: " + CleanText(explanation.replay) + "\n";
  return text;
}

}  // namespace rasterproof::report
