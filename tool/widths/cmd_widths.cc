// rasterproof widths: how many bits the values of an integer edge function take.
#include "tool/widths/cmd_widths.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "core/snap.h"
#include "core/target_size.h"
#include "exact/edge_widths.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "tool/exit_status.h"
#include "tool/progress.h"

namespace rasterproof::tool {
namespace {

// Two numbers of digits alone with the mark between them, as 12.4 and 640x480.
std::optional<std::pair<int, int>> TwoNumbers(std::string_view text, char mark) {
  const auto number = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [at, error] = std::from_chars(digits.data(), end, value);
    const bool is_number = !digits.empty() && digits[0] != '-' && error == std::errc{} && at == end;
    return is_number ? std::optional(value) : std::nullopt;
  };
  const std::size_t place = text.find(mark);
  if (place == std::string_view::npos) return {};
  const std::optional<int> first = number(text.substr(0, place));
  const std::optional<int> second = number(text.substr(place + 1));
  if (!first || !second) return {};
  return std::pair(*first, *second);
}

// A name or a list, as the profile key sample_locations has it.
SamplePattern PatternOf(const std::string& samples) {
  const std::string value = samples.starts_with('[') ? samples : '"' + samples + '"';
  const std::string profile = R"({"name": "widths", "sample_locations": )" + value + "}";
  return io::ParseProfile(profile, "--samples").pattern;
}

exact::EdgeUnit UnitOf(const WidthsOptions& options) {
  exact::EdgeUnit unit;
  const auto format = TwoNumbers(options.fixed, '.');
  const bool is_format = format && format->first >= 1 && format->first <= kMaxIntegerBits &&
                         format->second >= 0 && format->second <= kMaxSubpixelBits;
  if (!is_format) {
    throw InputError("--fixed " + Quoted(options.fixed, 40), "it is not a coordinate format",
                     fmt::format("give the bits before and after the point, as 12.4: 1 to {} and "
                                 "0 to {}",
                                 kMaxIntegerBits, kMaxSubpixelBits));
  }
  unit.input = {format->first, format->second, options.is_signed, false};
  const auto target = TwoNumbers(options.target, 'x');
  const auto is_side = [](int side) { return side >= 1 && side <= kMaxTargetSide; };
  if (!target || !is_side(target->first) || !is_side(target->second)) {
    throw InputError("--target " + Quoted(options.target, 40), "it is not a target size",
                     fmt::format("give width and height, as 4096x4096: 1 to {}", kMaxTargetSide));
  }
  unit.width = target->first;
  unit.height = target->second;
  unit.tile = options.tile;
  unit.pattern = PatternOf(options.samples);
  return unit;
}

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

std::string ToTable(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths) {
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

void WritePoint(io::JsonWriter& json, std::string_view key, const exact::EdgeUnit& unit,
                std::int64_t x, std::int64_t y) {
  json.Key(key).BeginArrayLine();
  json.Shortest(PixelsOf(unit, x)).Shortest(PixelsOf(unit, y)).EndArray();
}

std::string ToJson(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths) {
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

Profile ProfileOf(const exact::EdgeUnit& unit) {
  Profile profile;
  profile.name = fmt::format("fixed {}.{}", unit.input.integer_bits, unit.input.fraction_bits);
  profile.fixed = unit.input;
  profile.pattern = unit.pattern;
  return profile;
}

// Whether the box of the scene's triangle has a pixel of the target in common, or part of two.
bool MeetsTheTarget(const Scene& scene) {
  const auto meets = [&](double Vertex::* axis, int side) {
    const auto [least, most] = std::ranges::minmax(scene.vertices, {}, axis);
    return least.*axis <= side - 1 && most.*axis >= 1;
  };
  return meets(&Vertex::x, scene.width) && meets(&Vertex::y, scene.height);
}

void SaveWitnesses(const std::string& folder, const exact::EdgeUnit& unit,
                   const std::vector<exact::EdgeWidth>& widths, bool only_seen) {
  io::MakeFolder(folder);
  for (const exact::EdgeWidth& width : widths) {
    io::CaseFile file;
    file.value.scene = WitnessScene(unit, width);
    file.value.profile = ProfileOf(unit);
    if (only_seen && !MeetsTheTarget(file.value.scene)) continue;  // nothing would be seen of it
    file.value.origin =
        fmt::format("widths: {} takes {}, which {} bits do not hold: {}", width.value,
                    Decimal(width.extreme), width.bits - 1, InputText(unit, width));
    // Of rasterproof's own subjects, the oracle draws the samples of any profile.
    file.subject = unit.pattern == SamplePattern{} ? "spans-exact" : "exact";
    file.property = "CoverageEqualsTheModel";
    const auto path = std::filesystem::path(folder) / (width.id + ".json");
    io::WriteFile(path.string(), io::CaseToJson(file));
  }
}

}  // namespace

int RunWidths(const WidthsOptions& options) {
  const exact::EdgeUnit unit = UnitOf(options);
  const std::vector<exact::EdgeWidth> widths = exact::EdgeWidths(unit);
  if (!options.save.empty()) {
    RequireTargetSize("--target " + options.target, unit.width, unit.height,
                      unit.pattern.samples());
    SaveWitnesses(options.save, unit, widths, /*only_seen=*/false);
    SaveWitnesses(options.save, unit, exact::InputsBeyondBits(unit), /*only_seen=*/true);
  }
  if (!options.json.empty()) io::WriteOutput(options.json, ToJson(unit, widths));
  if (options.json != "-") io::WriteStandardOutput(ToTable(unit, widths));
  return kExitHolds;
}

}  // namespace rasterproof::tool
