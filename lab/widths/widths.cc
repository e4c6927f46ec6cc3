#include "lab/widths/widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "fmt/format.h"
#include "io/json_writer.h"

namespace rasterproof::lab {
namespace {

double PixelsOf(const exact::EdgeUnit& unit, std::int64_t n) {
  return std::ldexp(static_cast<double>(n), -unit.UnitBits());
}

std::string Decimal(exact::EdgeInteger value) {
  if (value == 0) return "0";
  std::string digits;
  for (exact::EdgeInteger rest = value; rest != 0; rest /= 10) {
    const int digit = static_cast<int>(rest % 10);
    digits += static_cast<char>('0' + (digit < 0 ? -digit : digit));
  }
  if (value < 0) digits += '-';
  std::ranges::reverse(digits);
  return digits;
}

std::string PointText(const exact::EdgeUnit& unit, std::string_view name, std::int64_t x,
                      std::int64_t y) {
  return fmt::format("{} ({}, {})", name, PixelsOf(unit, x), PixelsOf(unit, y));
}

std::string InputText(const exact::EdgeUnit& unit, const exact::EdgeWidth& width) {
  const exact::EdgeInput& e = width.witness;
  std::string text = PointText(unit, "a", e.ax, e.ay) + ' ' + PointText(unit, "b", e.bx, e.by);
  const char* const p = width.form == "area" ? "c" : "p";
  if (width.depends_on_p) text += ' ' + PointText(unit, p, e.px, e.py);
  return text;
}

std::string SamplesText(const SamplePattern& pattern) {
  if (pattern == SamplePattern{}) return "samples at the centres of pixels";
  std::string places;
  for (const Point2& l : pattern.locations) places += fmt::format(" ({}, {})", l.x, l.y);
  return "samples at" + places + " of each pixel";
}

void WritePoint(io::JsonWriter& json, std::string_view key, const exact::EdgeUnit& unit,
                std::int64_t x, std::int64_t y) {
  json.Key(key).BeginArrayLine();
  json.Shortest(PixelsOf(unit, x)).Shortest(PixelsOf(unit, y)).EndArray();
}

Profile ProfileOf(const exact::EdgeUnit& unit) {
  Profile profile;
  profile.name = fmt::format("fixed {}.{}", unit.input.integer_bits, unit.input.fraction_bits);
  profile.fixed = unit.input;
  profile.pattern = unit.pattern;
  return profile;
}

}  // namespace

std::string WidthsTable(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths) {
  const FixedInput& input = unit.input;
  std::string text = fmt::format(
      "vertices    {}.{} {}, {} bits: {} to {}\n"
      "target      {} x {}, tiles of {} x {}\n"
      "unit        2^-{} pixel; {}\n"
      "proved      each value is affine in each coordinate alone, so its ends are at the 64 "
      "corners\n"
      "            of the coordinates' ranges{}: all were computed, exactly\n\n",
      input.integer_bits, input.fraction_bits, input.is_signed ? "signed" : "unsigned",
      input.integer_bits + input.fraction_bits, input.Least(), input.Largest(), unit.width,
      unit.height, unit.tile, unit.tile, unit.UnitBits(), SamplesText(unit.pattern),
      unit.pattern.samples() == 1 ? "" : ", for each sample of a pixel");
  text += fmt::format("{:<8} {:<23} {:<22} {:>4}  {}\n", "form", "value", "p", "bits",
                      "input that needs the last bit");
  for (const exact::EdgeWidth& width : widths) {
    text +=
        fmt::format("{:<8} {:<23} {:<22} {:>4}  {}\n", width.form, width.value,
                    width.place.empty() ? "-" : width.place, width.bits, InputText(unit, width));
  }
  return text;
}

std::string WidthsJson(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths) {
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_widths").Integer(1);
  json.Key("fixed").BeginObjectLine();
  json.Key("integer_bits").Integer(unit.input.integer_bits);
  json.Key("fraction_bits").Integer(unit.input.fraction_bits);
  json.Key("signed").Bool(unit.input.is_signed).EndObject();
  json.Key("target").BeginArrayLine().Integer(unit.width).Integer(unit.height).EndArray();
  json.Key("tile").Integer(unit.tile).Key("unit_bits").Integer(unit.UnitBits());
  json.Key("samples").BeginArray();
  for (const Point2& l : unit.pattern.locations)
    json.BeginArrayLine().Shortest(l.x).Shortest(l.y).EndArray();
  json.EndArray();
  json.Key("widths").BeginArray();
  for (const exact::EdgeWidth& width : widths) {
    const exact::EdgeInput& e = width.witness;
    json.BeginObject().Key("id").Text(width.id).Key("form").Text(width.form);
    json.Key("value").Text(width.value);
    if (width.depends_on_p) json.Key("place").Text(width.place);
    json.Key("bits").Integer(width.bits);
    // As text: most readers of JSON keep 53 bits.
    json.Key("least").Text(Decimal(width.least)).Key("most").Text(Decimal(width.most));
    json.Key("witness").BeginObject().Key("value").Text(Decimal(width.extreme));
    WritePoint(json, "a", unit, e.ax, e.ay);
    WritePoint(json, "b", unit, e.bx, e.by);
    if (width.depends_on_p) WritePoint(json, "p", unit, e.px, e.py);
    json.EndObject().EndObject();
  }
  json.EndArray().EndObject();
  return json.Finish();
}

bool MeetsTheTarget(const Scene& scene) {
  const auto meets = [&](double Vertex::* axis, int side) {
    const auto [least, most] = std::ranges::minmax(scene.vertices, {}, axis);
    return least.*axis <= side - 1 && most.*axis >= 1;
  };
  return meets(&Vertex::x, scene.width) && meets(&Vertex::y, scene.height);
}

io::CaseFile WitnessCase(const exact::EdgeUnit& unit, const exact::EdgeWidth& width) {
  io::CaseFile file;
  file.value.scene = WitnessScene(unit, width);
  file.value.profile = ProfileOf(unit);
  file.value.origin = fmt::format("widths: {} takes {}, which {} bits do not hold: {}", width.value,
                                  Decimal(width.extreme), width.bits - 1, InputText(unit, width));
  // Of rasterproof's own subjects, the oracle draws the samples of any profile.
  file.subject = unit.pattern == SamplePattern{} ? "spans-exact" : "exact";
  file.property = "CoverageEqualsTheModel";
  return file;
}

}  // namespace rasterproof::lab
