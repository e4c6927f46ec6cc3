// The failing place as a figure: three panels with the exact triangles over the pixel grid.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/explanation_numbers.h"
#include "report/figure.h"
#include "report/overview.h"
#include "report/picture.h"
#include "report/pixel_state.h"
#include "report/text.h"
#include "report/view_geometry.h"

namespace rasterproof::report {
namespace {

constexpr int kMostDrawnPixels = 48;
constexpr std::size_t kMostLines = 24;  // of edge values
constexpr double kMargin = 24;
constexpr double kGap = 28;     // between panels
constexpr double kGutter = 30;  // for row numbers
constexpr double kText = 15;    // sizes whose dots are whole pixels at kImageScale
constexpr double kLabel = 10;
constexpr double kTitle = 20;
constexpr double kLeading = 1.5;  // line height over text size
constexpr double kImageScale = 2;
constexpr double kOverviewWidth = 352;
constexpr double kLeastWidth = 744;  // of the legend between its margins

// Breaks at blanks, and inside words that are longer than a line.
std::vector<std::string> Wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  while (text.size() > columns) {
    std::size_t cut = text.rfind(' ', columns);
    if (cut == std::string_view::npos || cut == 0) cut = columns;
    lines.emplace_back(text.substr(0, cut));
    text.remove_prefix(cut);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  lines.emplace_back(text);
  return lines;
}

class Layout {
 public:
  explicit Layout(const Explanation& explanation)
      : explanation_(explanation),
        titles_(PanelTitles(explanation)),
        view_(ReadableView(explanation, kMostDrawnPixels)) {
    if (HasNumbers(explanation)) scale_ = ScaleOf(*explanation.numbers);
    const int wide = view_.x1 - view_.x0;
    const int high = view_.y1 - view_.y0;
    cell_ = std::clamp(std::floor(352.0 / std::max({wide, high, 1})), 8.0, 56.0);
    panel_width_ = std::max(cell_ * wide, kAdvance * kText * 10);
    figure_.width = std::max(2 * kMargin + kGutter + 3 * panel_width_ + 2 * kGap, kLeastWidth);
    columns_ = static_cast<std::size_t>((figure_.width - 2 * kMargin) / (kAdvance * kText));
  }

  Figure Take() {
    y_ = kMargin;
    Paragraph(explanation_.headline, kInk, kTitle);
    if (!explanation_.headline.empty()) y_ += kText / 2;
    const double top = y_ + kLeading * kText + kLabel * kLeading;
    for (std::size_t panel = 0; panel < titles_.size(); ++panel) DrawPanel(panel, top);
    y_ = top + cell_ * (view_.y1 - view_.y0) + kText;
    DrawWhole();
    HasNumbers(explanation_) ? DrawNumberLegend() : DrawLegend();
    for (std::size_t k = 0; k < std::min(kMostLines, explanation_.edge_values.size()); ++k) {
      Paragraph(explanation_.edge_values[k], kInk, kText);
    }
    if (explanation_.edge_values.size() > kMostLines) {
      Paragraph(fmt::format("and {} more", explanation_.edge_values.size() - kMostLines), kFaintInk,
                kText);
    }
    if (!explanation_.replay.empty()) {
      y_ += kText / 2;
      Paragraph(explanation_.replay, kFaintInk, kText);
    }
    figure_.height = y_ + kMargin / 2;
    return std::move(figure_);
  }

 private:
  double PanelLeft(std::size_t panel) const {
    return kMargin + kGutter + static_cast<double>(panel) * (panel_width_ + kGap);
  }

  void Paragraph(const std::string& text, Colour colour, double size) {
    if (text.empty()) return;
    const auto columns = static_cast<std::size_t>(static_cast<double>(columns_) * kText / size);
    for (const std::string& line : Wrapped(CleanText(text), columns)) {
      figure_.Text({kMargin, y_ + size}, line, colour, size);
      y_ += kLeading * size;
    }
  }

  void DrawPanel(std::size_t panel, double top) {
    const double left = PanelLeft(panel);
    figure_.Text({left, top - kLeading * kLabel - kText / 2}, titles_[panel], kInk, kText);
    DrawLabels(panel, left, top);
    for (int y = view_.y0; y < view_.y1; ++y) {
      for (int x = view_.x0; x < view_.x1; ++x) {
        DrawPixel(panel, x, y, left + cell_ * (x - view_.x0), top + cell_ * (y - view_.y0));
      }
    }
    DrawGrid(left, top);
    for (const int triangle : explanation_.triangles) DrawTriangle(triangle, left, top);
    // The frame would hide dots of numbers, and lies over those of coverage.
    if (HasNumbers(explanation_)) DrawFocus(left, top);
    DrawSamples(panel, left, top);
    if (!HasNumbers(explanation_)) DrawFocus(left, top);
  }

  // Numbers of every column and row, or of as many as have room.
  void DrawLabels(std::size_t panel, double left, double top) {
    const double digits = static_cast<double>(fmt::format("{}", view_.x1).size());
    const int every_x = static_cast<int>(std::ceil((digits + 1) * kAdvance * kLabel / cell_));
    for (int x = view_.x0; x < view_.x1; x += every_x) {
      figure_.CentredText({left + cell_ * (x - view_.x0 + 0.5), top - kLabel * 0.8},
                          std::to_string(x), kFaintInk, kLabel);
    }
    if (panel != 0) return;
    const int every_y = static_cast<int>(std::ceil(1.2 * kLabel / cell_));
    for (int y = view_.y0; y < view_.y1; y += every_y) {
      const std::string label = std::to_string(y);
      const double wide = kAdvance * kLabel * static_cast<double>(label.size());
      figure_.Text({left - wide - 6, top + cell_ * (y - view_.y0 + 0.5) + 0.35 * kLabel}, label,
                   kFaintInk, kLabel);
    }
  }

  // The number as a colour; how far off it is, in words too.
  void DrawNumberPixel(std::size_t panel, int x, int y, double left, double top) {
    const ComparedNumber* const number = NumberAt(explanation_, x, y);
    const bool is_whole = panel == 2 || explanation_.expected.samples == 1;
    const Colour colour = number == nullptr || !is_whole ? kUncovered : ColourOf(*number, panel);
    figure_.Rectangle(left, top, left + cell_, top + cell_, colour);
    if (number == nullptr || !is_whole) return;
    const double shown = panel == 0 ? number->expected : number->observed;
    const char beside = NumberCharacter(scale_, shown);
    const bool is_off = panel == 2 && !(std::fabs(number->off) <= 1);
    const std::string text = is_off                                         ? OffText(number->off)
                             : panel != 2 && (beside < '0' || beside > '9') ? std::string(1, beside)
                                                                            : "";
    const double size = std::min(kText, cell_ / (kAdvance * static_cast<double>(text.size() + 1)));
    if (text.empty() || size < 7) return;
    const bool is_dark = panel == 2 ? number->off < -40 : beside == '<';
    figure_.CentredText({left + cell_ / 2, top + cell_ / 2}, text, is_dark ? kPaper : kInk, size);
  }

  Colour ColourOf(const ComparedNumber& number, std::size_t panel) const {
    if (panel == 2) return OffColour(number.off);
    return NumberColour(scale_, panel == 0 ? number.expected : number.observed);
  }

  void DrawPixel(std::size_t panel, int x, int y, double left, double top) {
    if (HasNumbers(explanation_)) return DrawNumberPixel(panel, x, y, left, top);
    const Pixel pixel = PixelAt(explanation_.observed, explanation_.expected, x, y);
    const std::uint64_t count = panel == 0 ? pixel.expected : pixel.observed;
    // Several samples covered once each make a pixel that is covered once.
    const auto samples = static_cast<std::uint64_t>(explanation_.expected.samples);
    const std::uint64_t level = (count + samples - 1) / samples;
    const Colour colour =
        panel == 2 ? StateColour(pixel.state, pixel.expected) : CountColour(level);
    figure_.Rectangle(left, top, left + cell_, top + cell_, colour);
    if (cell_ < 16) return;
    // The samples' dots keep the middle; the pixel's text is in its corner.
    const double size = std::min(kText, cell_ / 1.8);
    const Point2 corner{left + 0.26 * cell_, top + 0.28 * cell_};
    if (panel == 2 && pixel.state != SampleState::kRight) {
      const char* mark = pixel.state == SampleState::kMissing      ? "-"
                         : pixel.state == SampleState::kUnexpected ? "+"
                                                                   : "!";
      figure_.CentredText(corner, mark, kPaper, size);
    } else if (panel != 2 && level > 1) {
      figure_.CentredText(corner, count <= 9 ? std::to_string(count) : "#",
                          level > 2 ? kPaper : kInk, size);
    }
  }

  void DrawGrid(double left, double top) {
    const double right = left + cell_ * (view_.x1 - view_.x0);
    const double bottom = top + cell_ * (view_.y1 - view_.y0);
    for (int x = view_.x0; x <= view_.x1; ++x) {
      const double at = left + cell_ * (x - view_.x0);
      figure_.Line({at, top}, {at, bottom}, kGrid, 1);
    }
    for (int y = view_.y0; y <= view_.y1; ++y) {
      const double at = top + cell_ * (y - view_.y0);
      figure_.Line({left, at}, {right, at}, kGrid, 1);
    }
  }

  bool IsUp() const { return explanation_.y_axis == YAxis::kUp; }

  // The view in the axes of the window; rows are counted from the top.
  ViewBox WindowView() const {
    const int height = explanation_.expected.height;
    ViewBox box{static_cast<double>(view_.x0), static_cast<double>(view_.y0),
                static_cast<double>(view_.x1), static_cast<double>(view_.y1)};
    if (IsUp()) {
      box.y0 = height - view_.y1;
      box.y1 = height - view_.y0;
    }
    return box;
  }

  Point2 OnPaper(Point2 p, double left, double top) const {
    const double row = IsUp() ? explanation_.expected.height - p.y : p.y;
    return {left + cell_ * (p.x - view_.x0), top + cell_ * (row - view_.y0)};
  }

  void DrawTriangle(int triangle, double left, double top) {
    const std::size_t known = explanation_.scene.triangles.size();
    if (triangle < 0 || static_cast<std::size_t>(triangle) >= known) return;
    const auto corners = WindowCorners(explanation_.scene, triangle);
    if (!corners) return;
    const ViewBox box = WindowView();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = ClipSegment((*corners)[k], (*corners)[(k + 1) % 3], box);
      if (!edge) continue;
      figure_.Line(OnPaper((*edge)[0], left, top), OnPaper((*edge)[1], left, top), kInk, 1.5, 0.9);
    }
    for (const Point2& p : *corners) {
      if (p.x < box.x0 || p.x > box.x1 || p.y < box.y0 || p.y > box.y1) continue;
      figure_.Dot(OnPaper(p, left, top), 3, kInk);
    }
  }

  // A dot on each sample: dark where the panel's counts cover it, loud where it is wrong.
  void DrawSamples(std::size_t panel, double left, double top) {
    const SamplePattern& pattern = explanation_.pattern;
    if (pattern.samples() != explanation_.expected.samples || cell_ < 8) return;
    const double radius =
        std::min(2.6, 0.12 * cell_) / std::sqrt(std::sqrt(static_cast<double>(pattern.samples())));
    for (int y = view_.y0; y < view_.y1; ++y) {
      for (int x = view_.x0; x < view_.x1; ++x) {
        for (int s = 0; s < pattern.samples(); ++s) {
          const int row = IsUp() ? explanation_.expected.height - 1 - y : y;
          const Point2 at = OnPaper(pattern.At(x, row, s), left, top);
          if (HasNumbers(explanation_)) {
            DrawNumberSample(panel, NumberAt(explanation_, x, y, s), at, radius);
            continue;
          }
          DrawSample(panel, explanation_.expected.Index(x, y, s), at, radius);
        }
      }
    }
  }

  // Of several samples each shows its own number as a dot; how far off they are, the worst says.
  void DrawNumberSample(std::size_t panel, const ComparedNumber* number, Point2 at, double radius) {
    if (number == nullptr) return figure_.Dot(at, 0.7 * radius, Mix(kGrid, kInk, 0.2));
    if (explanation_.expected.samples == 1 || panel == 2) return;
    const double size = std::max(2 * radius, 3.0);
    if (number == &explanation_.numbers->list.front()) figure_.Dot(at, size + 2.5, kInk);
    figure_.Dot(at, size + 1, kPaper);
    figure_.Dot(at, size, ColourOf(*number, panel));
  }

  void DrawSample(std::size_t panel, std::size_t index, Point2 at, double radius) {
    const CoverageCounts& expected = explanation_.expected;
    const CoverageCounts& observed = explanation_.observed;
    const SampleState state = StateOf(observed, expected, index);
    const bool covered = (panel == 0 ? expected : observed).Count(index) != 0;
    if (state != SampleState::kRight && panel != 0) {
      figure_.Dot(at, radius + 1.2, kPaper);
      figure_.Dot(at, radius, StateColour(state, 0));
    } else {
      figure_.Dot(at, covered ? radius : 0.7 * radius, covered ? kInk : Mix(kGrid, kInk, 0.2));
    }
  }

  void DrawFocus(double left, double top) {
    const int x = explanation_.focus_x;
    const int y = explanation_.focus_y;
    if (x < view_.x0 || x >= view_.x1 || y < view_.y0 || y >= view_.y1) return;
    const double x0 = left + cell_ * (x - view_.x0);
    const double y0 = top + cell_ * (y - view_.y0);
    figure_.Frame(x0, y0, x0 + cell_, y0 + cell_, kInk, 4);
    figure_.Frame(x0, y0, x0 + cell_, y0 + cell_, kYellow, 2);
  }

  // The triangle of which the panels show a small part.
  void DrawWhole() {
    const auto overview = OverviewOf(explanation_, view_);
    if (!overview) return;
    Paragraph(OverviewText(*overview), kInk, kText);
    y_ += kText / 2;
    y_ += DrawOverview(*overview, {kMargin + kGutter, y_}, kOverviewWidth, figure_);
  }

  // The scale with its ends, and what the third panel's colours mean.
  void DrawNumberLegend() {
    constexpr int kSteps = 48;
    constexpr double kWide = 4;
    const double low = y_ + 0.85 * kText;
    double x = kMargin;
    const auto write = [&](const std::string& text) {
      figure_.Text({x, low}, text, kFaintInk, kText);
      x += kAdvance * kText * static_cast<double>(text.size() + 1);
    };
    const auto square = [&](Colour colour, double wide) {
      figure_.Rectangle(x, y_ + 1, x + wide, y_ + 1 + 0.9 * kText, colour);
      x += wide;
    };
    write(ShortNumber(scale_.low));
    for (int k = 0; k < kSteps; ++k) {
      const double part = (k + 0.5) / kSteps;
      square(NumberColour(scale_, scale_.low + part * (scale_.high - scale_.low)), kWide);
    }
    x += kAdvance * kText;
    write(ShortNumber(scale_.high));
    for (const auto& [off, text] :
         {std::pair(0.0, "within"), std::pair(-2.0, "below"), std::pair(2.0, "above")}) {
      x += kText;
      square(OffColour(1e4 * off), 0.9 * kText);
      x += 0.5 * kText;
      write(text);
    }
    y_ += 1.5 * kText;
    Paragraph(explanation_.numbers->is_in_ulps
                  ? "difference: in ulps, where none is allowed; < and >: off the scale"
                  : "difference: in units of the error that is allowed; < and >: off the scale",
              kFaintInk, kText);
    y_ += 0.7 * kText;
  }

  void DrawLegend() {
    struct Entry {
      Colour colour;
      std::string_view text;
    };
    constexpr std::array<Entry, 6> kEntries{{{kCovered, "covered once"},
                                             {kCoveredTwice, "twice"},
                                             {kCoveredMore, "more often"},
                                             {kVermilion, "missing"},
                                             {kBlue, "unexpected"},
                                             {kPurple, "facing"}}};
    double x = kMargin;
    for (const Entry& entry : kEntries) {
      figure_.Rectangle(x, y_ + 1, x + 0.9 * kText, y_ + 1 + 0.9 * kText, entry.colour);
      x += 1.4 * kText;
      figure_.Text({x, y_ + 0.85 * kText}, entry.text, kFaintInk, kText);
      x += kAdvance * kText * static_cast<double>(entry.text.size()) + 1.6 * kText;
    }
    y_ += 2.2 * kText;
  }

  const Explanation& explanation_;
  std::span<const std::string_view> titles_;
  PixelRect view_;
  Figure figure_;
  double cell_ = 8;
  double panel_width_ = 0;
  std::size_t columns_ = 0;
  double y_ = 0;
  NumberScale scale_;
};

}  // namespace

std::string ExplanationToSvg(const Explanation& explanation) {
  return FigureToSvg(Layout(explanation).Take());
}

io::Image ExplanationToImage(const Explanation& explanation) {
  return FigureToImage(Layout(explanation).Take(), kImageScale);
}

}  // namespace rasterproof::report
