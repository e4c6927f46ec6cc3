// rasterproof widths: how many bits the values of an integer edge function take.
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
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
#include "lab/widths/widths.h"
#include "tool/exit_status.h"
#include "tool/verb.h"

namespace rasterproof::tool {
namespace {

// How many bits the values of an integer edge function take.
struct WidthsOptions {
  std::string fixed;  ///< "12.4"
  bool is_signed = true;
  std::string target;                  ///< "4096x4096"
  std::string samples = "standard-1";  ///< or a list, as the profile key sample_locations
  int tile = 8;
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the inputs as cases; empty: none
};

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
  io::JsonWriter json;
  json.BeginObject(io::kOneLine).Key("name").Text("widths").Key("sample_locations");
  samples.starts_with('[') ? json.Value(samples) : json.Text(samples);
  return io::ParseProfile(json.EndObject().json(), "--samples").pattern;
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

void SaveWitnesses(const std::string& folder, const exact::EdgeUnit& unit,
                   const std::vector<exact::EdgeWidth>& widths, bool only_seen) {
  io::MakeFolder(folder);
  for (const exact::EdgeWidth& width : widths) {
    const io::CaseFile file = lab::WitnessCase(unit, width);
    if (only_seen && !lab::MeetsTheTarget(file.value.scene)) continue;  // nothing would be seen
    const auto path = std::filesystem::path(folder) / (width.id + ".json");
    io::WriteFile(path.string(), io::CaseToJson(file));
  }
}

int RunWidths(const WidthsOptions& options) {
  const exact::EdgeUnit unit = UnitOf(options);
  const std::vector<exact::EdgeWidth> widths = exact::EdgeWidths(unit);
  if (!options.save.empty()) {
    RequireTargetSize("--target " + options.target, unit.width, unit.height,
                      unit.pattern.samples());
    SaveWitnesses(options.save, unit, widths, /*only_seen=*/false);
    SaveWitnesses(options.save, unit, exact::InputsBeyondBits(unit), /*only_seen=*/true);
  }
  if (!options.json.empty()) io::WriteOutput(options.json, lab::WidthsJson(unit, widths));
  if (options.json != "-") io::WriteStandardOutput(lab::WidthsTable(unit, widths));
  return kExitHolds;
}

Run AddWidths(CLI::App* verb, const Invocation& /*call*/) {
  static WidthsOptions options;
  verb->add_option("--fixed", options.fixed,
                   "Bits of a coordinate before and after the point: 12.4; with --signed the first "
                   "is the sign")
      ->required();
  verb->add_flag("--signed,!--unsigned", options.is_signed, "Coordinates have a sign (default)");
  verb->add_option("--target", options.target, "Width and height of the largest target: 4096x4096")
      ->required();
  verb->add_option("--samples", options.samples,
                   "Sample locations: standard-1, -2, -4, -8, -16, or a list as in the profile key "
                   "sample_locations: '[[0, 0], [0.5, 0.5]]'")
      ->capture_default_str();
  verb->add_option("--tile", options.tile, "Side of a tile in pixels; also the larger step")
      ->check(CLI::Range(1, kMaxTargetSide))
      ->capture_default_str();
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save,
                   "Folder for one case per value: the input that needs its last bit");
  return [] { return RunWidths(options); };
}

}  // namespace

extern constinit const Verb kWidthsVerb{
    "widths", VerbGroup::kDevelopment, 30,
    "Fewest bits for every value of an integer edge function, with inputs that need them",
    AddWidths};

}  // namespace rasterproof::tool
