#include "report/bench_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/bench_decision.h"
#include "report/bench_layout.h"
#include "report/bench_page_parts.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Of panels, in user units.
constexpr double kLeft = 80;
constexpr double kTop = 56;
constexpr double kRight = 24;
constexpr int kColumns = 3;
constexpr std::size_t kMostNumbers = 4;

struct Look {
  bool is_large = false;
  double width = 400;
  double plot_height = 170;
  double lane = 27;
  double foot = 84;

  double right() const { return width - kRight; }
  double bottom() const { return kTop + plot_height; }
  double height() const { return bottom() + foot; }
};
constexpr Look kSmall{};
constexpr Look kLarge{.is_large = true, .width = 900, .plot_height = 390, .lane = 48, .foot = 62};

struct Kind {
  std::string_view name;
  std::string_view style;  // its class
  std::string_view shape;
};
constexpr std::array<Kind, 5> kKinds{
    {{"float32", "f32", "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z"},
     {"float64", "f64", "M0 5l5 -9h-10z"},
     {"fixed point", "fixed", "M-4 -4h8v8h-8z"},
     {"exact", "exact", "M0 -5l5 9h-10z"},
     {"yours", "yours", "M0 -7l7 7l-7 7l-7 -7z"}}};

// For programs that know no variables.
std::string PlainStyle() {
  std::string style(kBenchStyle);
  for (std::size_t at = 0; (at = style.find("var(")) != std::string::npos;) {
    style.erase(style.find(')', at), 1);
    style.erase(at, style.find(',', at) + 1 - at);
  }
  return style;
}

const Kind& PointKind(const BenchMethod& method) {
  const auto* const found = std::ranges::find(
      kKinds, method.is_users ? std::string_view("yours") : method.kind, &Kind::name);
  return found == kKinds.end() ? kKinds.front() : *found;
}

std::string PointName(const BenchMethod& method) {
  return FullName(method) + (method.is_users ? " (yours)" : "");
}

std::string Text(double x, double y, std::string_view anchor, std::string_view text,
                 std::string_view style = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n",
                     x, y, anchor, style, Escaped(text));
}

std::string Mark(const Kind& kind, bool is_hollow) {
  return fmt::format("<path class=\"mark {}{}\" d=\"{}\"/>", kind.style, is_hollow ? " hollow" : "",
                     kind.shape);
}

std::string ErrorText(double value, ErrorKind kind) {
  if (IsInPixels(kind)) return fmt::format("{:g} px", value);
  return value >= 9.99e-4 ? fmt::format("{:.3g} %", 100 * value)
                          : fmt::format("{:.3g} in 10⁶", 1e6 * value);
}

// Where an error lies that has no place on the axis.
struct Lane {
  std::string_view name;
  double top = 0;
};
constexpr std::string_view kLost = "lost";
constexpr std::string_view kOnTheEdge = "on the edge";
constexpr std::string_view kNoneOfN = "0 of N";
constexpr std::string_view kProved = "proved 0";

std::string_view LaneOf(const RowError& error) {
  switch (error.lane) {
    case ErrorLane::kProved:
      return kProved;
    case ErrorLane::kNone:
      return kNoneOfN;
    case ErrorLane::kLost:
      return kLost;
    case ErrorLane::kRate:
    case ErrorLane::kNotJudged:
      break;
  }
  return error.value > 0 ? "" : kOnTheEdge;
}

// A sentence at its last blank that leaves the first line short enough for a panel.
std::pair<std::string, std::string> InTwoLines(const std::string& sentence, const Look& look) {
  const std::size_t most = look.is_large ? 130 : 56;
  if (sentence.size() <= most) return {sentence, ""};
  const std::size_t blank = sentence.rfind(' ', most);
  if (blank == std::string::npos) return {sentence, ""};
  return {sentence.substr(0, blank), sentence.substr(blank + 1)};
}

// The title that a browser shows where the pointer rests.
std::string Title(const BenchResult& result, const BenchRow& row) {
  const std::string remark = RemarkText(result, row);
  return fmt::format(
      "{}: {} of the baseline's time, {} ns a triangle, {} ms a frame at 1080p; {} wrong{}{}",
      PointName(result.methods[row.method]), RatioText(row, 3),
      NumberText(NanosecondsATriangle(result, row)),
      NumberText(MillisecondsAFrame(result, row, kFramePixels[0])), WrongText(result, row),
      remark.empty() ? "" : "; ", remark);
}

class Panel {
 public:
  Panel(const BenchResult& result, std::uint32_t family, const Look& look);

  std::string Head() const;
  std::string ErrorAxis(ErrorKind kind) const;
  // Of a family and sink all that show the error, by their time.
  std::vector<Place> Places(std::string_view sink, ErrorKind kind) const;
  std::string FrontLine(const std::vector<Place>& places, std::string_view sink,
                        ErrorKind kind) const;
  std::string Point(const Place& place, std::string_view more = "") const;
  // Of the frontier, and the user's own.
  std::vector<Place> Named(const std::vector<Place>& places, std::string_view sink,
                           ErrorKind kind) const;
  // Names or numbers beside points, where they cover none; what finds no room is left out.
  std::string Labels(const std::vector<Place>& places, const std::vector<Place>& named) const;
  std::string NamesBelow(const std::vector<Place>& named) const;

 private:
  const BenchMethod& MethodOf(const Place& place) const {
    return result_.methods[place.row->method];
  }
  const BenchFamily& family() const { return result_.families[family_]; }
  Axis AxisOf(ErrorKind kind) const;
  std::vector<Lane> Lanes(ErrorKind kind) const;

  const BenchResult& result_;
  std::uint32_t family_;
  const Look& look_;
  Axis time_;
};

// Small panels have one axis, of the decades that hold every ratio, at least a tenth to ten.
Panel::Panel(const BenchResult& result, std::uint32_t family, const Look& look)
    : result_(result), family_(family), look_(look) {
  for (const BenchRow& row : result.rows) {
    if (look.is_large && row.family != family) continue;
    if (!look.is_large && result.methods[row.method].sink != kCommonSink) continue;
    for (const double ratio : {row.ratio.low, row.ratio.median, row.ratio.high}) time_.Take(ratio);
  }
  if (time_.high == 0) time_.Take(1);
  if (look.is_large) {
    time_.Widen(1.12);
  } else {
    time_.low = std::min(0.1, std::pow(10, std::floor(std::log10(time_.low))));
    time_.high = std::max(10.0, std::pow(10, std::ceil(std::log10(time_.high))));
  }
  time_.from = kLeft;
  time_.to = look.right();
}

std::vector<Lane> Panel::Lanes(ErrorKind kind) const {
  std::vector<Lane> lanes{{kNoneOfN, look_.bottom() - 2 * look_.lane},
                          {kProved, look_.bottom() - look_.lane}};
  if (kind == ErrorKind::kDisplacement) {
    lanes.insert(lanes.begin(), {{kLost, kTop}, {kOnTheEdge, look_.bottom() - 3 * look_.lane}});
  }
  return lanes;
}

// Small panels show shares alone, all from 1e-7 to 1.
Axis Panel::AxisOf(ErrorKind kind) const {
  Axis axis;
  for (const BenchRow& row : result_.rows) {
    const RowError error = ErrorOf(result_, row, kind);
    if (look_.is_large && row.family == family_ && error.lane == ErrorLane::kRate)
      axis.Take(error.value);
  }
  if (axis.high == 0) {
    axis.low = 1e-7;
    axis.high = 1;
  } else {
    axis.Widen(2);
  }
  const std::vector<Lane> lanes = Lanes(kind);
  axis.from = lanes[lanes.size() - (lanes.size() == 2 ? 2 : 3)].top;
  axis.to = kTop + (lanes.size() == 2 ? 0 : look_.lane);
  return axis;
}

std::string Panel::Head() const {
  std::string svg = Text(kLeft, 18, "start", family().name, "title");
  const auto [first, second] = InTwoLines(family().summary, look_);
  svg += Text(kLeft, 33, "start", first, "soft") + Text(kLeft, 46, "start", second, "soft");
  for (const double ratio : Ticks(time_, 46)) {
    const double x = time_.At(ratio);
    svg += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>\n", x, kTop, look_.bottom());
    svg += Text(x, look_.bottom() + 14, "middle", fmt::format("{:g}", ratio), "soft");
  }
  return svg;
}

std::string Panel::ErrorAxis(ErrorKind kind) const {
  std::string svg;
  const Axis axis = AxisOf(kind);
  for (const double value : Ticks(axis, 26)) {
    const double y = axis.At(value);
    svg += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y, look_.right());
    svg += Text(kLeft - 6, y + 3.5, "end", ErrorText(value, kind), "soft");
  }
  for (const auto& [name, top] : Lanes(kind)) {
    svg += fmt::format("<path class=\"lane\" d=\"M{} {:.1f}H{}\"/>\n", kLeft,
                       name == kLost ? top + look_.lane : top, look_.right());
    svg += Text(kLeft - 6, top + look_.lane / 2 + 3.5, "end", name, "soft");
  }
  return svg;
}

std::vector<Place> Panel::Places(std::string_view sink, ErrorKind kind) const {
  const Axis axis = AxisOf(kind);
  std::vector<Place> places;
  for (const BenchRow& row : result_.rows) {
    if (row.family != family_ || result_.methods[row.method].sink != sink) continue;
    const RowError error = ErrorOf(result_, row, kind);
    if (error.lane == ErrorLane::kNotJudged || IsBaselineAgain(result_, row)) continue;
    places.push_back({&row, time_.At(row.ratio.median), axis.At(error.value)});
  }
  std::ranges::sort(places, {}, OrderOf);
  for (const Lane& lane : Lanes(kind)) {
    std::vector<Place*> here;
    for (Place& place : places) {
      if (LaneOf(ErrorOf(result_, *place.row, kind)) == lane.name) here.push_back(&place);
    }
    Spread(here, lane.top, look_.lane);
  }
  return places;
}

std::string Panel::FrontLine(const std::vector<Place>& places, std::string_view sink,
                             ErrorKind kind) const {
  std::vector<std::string> line;
  for (const BenchRow* row : Frontier(result_, family_, sink, kind)) {
    const auto place = std::ranges::find(places, row, &Place::row);
    line.push_back(fmt::format("{:.1f} {:.1f}", place->x, place->y));
  }
  if (line.size() < 2) return {};
  return fmt::format("<path class=\"front\" d=\"M{}\"/>\n", fmt::join(line, "L"));
}

std::string Panel::Point(const Place& place, std::string_view more) const {
  const BenchRow& row = *place.row;
  const std::string bar =
      HasInterval(row)
          ? fmt::format("<path class=\"bar\" d=\"M{:.1f} 0H{:.1f}\"/>",
                        time_.At(row.ratio.low) - place.x, time_.At(row.ratio.high) - place.x)
          : "";
  return fmt::format(
      "<g class=\"point\" transform=\"translate({:.1f} {:.1f})\"{}><title>{}</title>{}{}</g>\n",
      place.x, place.y, more, Escaped(Title(result_, row)), bar,
      Mark(PointKind(MethodOf(place)), !IsRival(result_, row)));
}

std::vector<Place> Panel::Named(const std::vector<Place>& places, std::string_view sink,
                                ErrorKind kind) const {
  std::vector<Place> front;
  for (const BenchRow* row : Frontier(result_, family_, sink, kind)) {
    front.push_back(*std::ranges::find(places, row, &Place::row));
  }
  std::vector<Place> own;
  for (const Place& place : places) {
    const bool is_new = std::ranges::find(front, place.row, &Place::row) == front.end();
    if (MethodOf(place).is_users && is_new) own.push_back(place);
  }
  if (!look_.is_large) {
    // The cheapest of the frontier, and its least wrong; the user's own in place of others.
    own.resize(std::min(own.size(), kMostNumbers - 1));
    const std::size_t room = kMostNumbers - own.size();
    if (front.size() > room) {
      front.erase(front.begin() + static_cast<std::ptrdiff_t>(room) - 1, front.end() - 1);
    }
  }
  front.insert(front.end(), own.begin(), own.end());
  return front;
}

std::string Panel::Labels(const std::vector<Place>& places, const std::vector<Place>& named) const {
  constexpr double kLetter = 7.8;  // a letter's width, of wide fonts
  const Box limits{kLeft + 2, kTop, look_.right() - kLeft - 4, look_.plot_height};
  std::vector<Box> taken;
  for (const Place& place : places) taken.push_back({place.x - 6, place.y - 6, 12, 12});
  std::string svg;
  for (std::size_t k = 0; k < named.size(); ++k) {
    const Place& place = named[k];
    const std::string name = look_.is_large ? PointName(MethodOf(place)) : std::to_string(k + 1);
    const double width = kLetter * static_cast<double>(name.size()) + 4;
    const Box* const box = FindRoom(place, width, limits, taken);
    if (box == nullptr) continue;
    const double x = std::clamp(place.x, box->x, box->x + box->width);
    const double y = std::clamp(place.y, box->y, box->y + box->height);
    svg += fmt::format("<g data-row=\"{}\">", place.row - result_.rows.data());
    if (std::hypot(x - place.x, y - place.y) > 10) {
      svg += fmt::format("<path class=\"lead\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", place.x,
                         place.y, x, y);
    }
    const bool is_left = box->x + box->width <= place.x;
    svg += Text(is_left ? box->x + box->width - 2 : box->x + 2, box->y + 11.5,
                is_left ? "end" : "start", name, "named") +
           "</g>";
  }
  return svg;
}

std::string Panel::NamesBelow(const std::vector<Place>& named) const {
  std::string svg;
  double y = look_.bottom() + 32;
  for (std::size_t k = 0; k < named.size(); ++k) {
    svg += Text(kLeft - 14, y, "start",
                fmt::format("{} {}: {:.3g} x, {} ns/triangle", k + 1, FullName(MethodOf(named[k])),
                            named[k].row->ratio.median,
                            NumberText(NanosecondsATriangle(result_, *named[k].row))));
    y += 13;
  }
  return svg;
}

std::string Legend(double y) {
  std::string svg;
  double x = kLeft;
  for (const Kind& kind : kKinds) {
    svg += fmt::format("<g transform=\"translate({} {})\">{}</g>", x, y - 4, Mark(kind, false));
    svg += Text(x + 9, y, "start", kind.name);
    x += 95;
  }
  return svg +
         Text(x, y, "start", "hollow: 1 % wrong or more, or past its limit. Line: the frontier");
}

// By real geometry, of the sink that all methods have.
std::string SmallPanel(const BenchResult& result, std::uint32_t family, bool is_front_alone) {
  const Panel panel(result, family, kSmall);
  std::vector<Place> places = panel.Places(kCommonSink, ErrorKind::kReal);
  std::string svg = panel.Head() + panel.ErrorAxis(ErrorKind::kReal) +
                    panel.FrontLine(places, kCommonSink, ErrorKind::kReal);
  const std::vector<Place> named = panel.Named(places, kCommonSink, ErrorKind::kReal);
  if (is_front_alone) {
    const std::vector<const BenchRow*> front =
        Frontier(result, family, kCommonSink, ErrorKind::kReal);
    std::erase_if(places, [&](const Place& place) {
      return std::ranges::find(front, place.row) == front.end();
    });
  }
  for (const Place& place : places) svg += panel.Point(place);
  return svg + panel.Labels(places, named) + panel.NamesBelow(named);
}

std::string SvgElement(const BenchResult& result, std::uint32_t family, const Look& look,
                       std::string_view role, const std::string& content) {
  return fmt::format(
      "<svg class=\"plot panel bench\" role=\"{}\" aria-label=\"Error against run time: {}\" "
      "viewBox=\"0 0 {} {}\">{}</svg>\n",
      role, Escaped(result.families[family].name), look.width, look.height(), content);
}

std::vector<std::string_view> SinksOf(const BenchResult& result) {
  std::vector<std::string_view> sinks;
  for (const BenchMethod& method : result.methods) {
    if (std::ranges::find(sinks, method.sink) == sinks.end()) sinks.push_back(method.sink);
  }
  return sinks;
}

// The points of a sink, each once, with its height of each error.
std::string PointsOf(const BenchResult& result, const Panel& panel,
                     const std::array<std::vector<Place>, kErrorKinds.size()>& by_error,
                     bool is_on) {
  std::map<const BenchRow*, std::array<std::string, kErrorKinds.size()>> heights;
  std::vector<Place> all;
  for (std::size_t error = 0; error < kErrorKinds.size(); ++error) {
    for (const Place& place : by_error[error]) {
      const auto [at, is_new] = heights.try_emplace(place.row);
      if (is_new) all.push_back(place);
      at->second[error] = fmt::format("{:.1f}", place.y);
    }
  }
  std::ranges::sort(all, {}, OrderOf);
  std::string svg;
  for (const Place& place : all) {
    const auto& own = heights[place.row];
    std::string point = panel.Point(
        place, fmt::format(" tabindex=\"-1\" role=\"img\" aria-label=\"{}\" data-row=\"{}\" "
                           "data-y=\"{}\"",
                           Escaped(PointName(result.methods[place.row->method])),
                           place.row - result.rows.data(), fmt::join(own, ",")));
    if (!is_on || own[0].empty()) point.replace(point.find("point"), 5, "point off");
    svg += point;
  }
  return svg;
}

}  // namespace

std::string FrontierPanel(const BenchResult& result, std::uint32_t family) {
  return SvgElement(result, family, kSmall, "img", SmallPanel(result, family, true));
}

std::string LargePanel(const BenchResult& result, std::uint32_t family) {
  const Panel panel(result, family, kLarge);
  const auto part = [](std::size_t error, const std::string& sink, bool is_on,
                       const std::string& content) {
    return fmt::format("<g data-error=\"{}\"{}{}>{}</g>", error, sink,
                       is_on ? "" : " class=\"off\"", content);
  };
  std::string svg = panel.Head();
  std::string points;
  for (std::size_t k = 0; k < kErrorKinds.size(); ++k)
    svg += part(k, "", k == 0, panel.ErrorAxis(kErrorKinds[k]));
  for (const std::string_view sink : SinksOf(result)) {
    std::array<std::vector<Place>, kErrorKinds.size()> by_error;
    const bool is_common = sink == kCommonSink;
    for (std::size_t k = 0; k < kErrorKinds.size(); ++k) {
      const ErrorKind kind = kErrorKinds[k];
      by_error[k] = panel.Places(sink, kind);
      svg += part(k, fmt::format(" data-sink=\"{}\"", Escaped(sink)), is_common && k == 0,
                  panel.FrontLine(by_error[k], sink, kind) +
                      panel.Labels(by_error[k], panel.Named(by_error[k], sink, kind)));
    }
    points += PointsOf(result, panel, by_error, is_common);
  }
  svg += points + Legend(kLarge.height() - 8) +
         Text(kLeft, kLarge.bottom() + 32, "start",
              fmt::format("time over that of {}, less is faster; bars: 95 % intervals",
                          result.methods[result.families[family].baseline].name),
              "soft");
  return SvgElement(result, family, kLarge, "group", svg);
}

std::string BenchToSvg(const BenchResult& result) {
  const auto panels = static_cast<int>(result.families.size());
  const int rows = (panels + kColumns - 1) / kColumns;
  const double width = kColumns * kSmall.width;
  const double height = rows * kSmall.height() + 56;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"bench\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\">\n<style>{2}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      width, height, PlainStyle());
  for (int k = 0; k < panels; ++k) {
    const int row = k / kColumns;
    svg += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n",
                       (k % kColumns) * kSmall.width, row * kSmall.height(),
                       SmallPanel(result, static_cast<std::uint32_t>(k), false));
  }
  svg += Legend(height - 34);
  const std::string baseline = result.families.empty() || result.methods.empty()
                                   ? ""
                                   : result.methods[result.families.front().baseline].name;
  svg +=
      Text(kLeft, height - 14, "start",
           fmt::format("Across: processor time over that of {} (bars: 95 % intervals). Up: wrong "
                       "pairs (triangle, sample) of those at most a pixel from an edge. {}",
                       baseline, result.setting.processor),
           "soft");
  return svg + "</svg>\n";
}

}  // namespace rasterproof::report
