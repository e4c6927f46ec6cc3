#include "io/case_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/json_document.h"
#include "io/number_text.h"
#include "io/output.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr int kVersion = 1;
constexpr int kMaxTile = kMaxTargetSide;
constexpr int kMaxThreads = 4096;

constexpr std::array<std::string_view, 7> kCaseKeys{
    "rasterproof_case", "scene", "profile", "options", "subject", "property", "origin"};
constexpr std::array<std::string_view, 12> kProfileKeys{
    "name",      "subpixel_bits",  "snap_rule",
    "snap_form", "snap_origin",    "sample_locations",
    "y_axis",    "fill_rule",      "coordinate_limit",
    "contract",  "snap_tolerance", "any_tie_rule"};
constexpr std::array<std::string_view, 4> kOptionKeys{"cull", "scissor", "tile", "threads"};

// An enumeration's values and their names in files.
template <class E>
using Names = std::span<const std::pair<E, std::string_view>>;

constexpr std::array<std::pair<YAxis, std::string_view>, 2> kYAxes{
    {{YAxis::kDown, "down"}, {YAxis::kUp, "up"}}};
constexpr std::array<std::pair<Contract, std::string_view>, 6> kContracts{
    {{Contract::kSampleExact, "sample-exact"},
     {Contract::kWatertight, "watertight"},
     {Contract::kClosed, "closed"},
     {Contract::kConservativeOver, "conservative-over"},
     {Contract::kConservativeUnder, "conservative-under"},
     {Contract::kNone, "none"}}};
constexpr std::array<std::pair<Cull, std::string_view>, 3> kCulls{
    {{Cull::kNone, "none"}, {Cull::kFront, "front"}, {Cull::kBack, "back"}}};

template <class E>
std::string_view NameOf(E value, Names<E> names) {
  return std::ranges::find(names, value, &std::pair<E, std::string_view>::first)->second;
}

template <class E>
E FromName(const JsonValue& value, Names<E> names) {
  const std::string_view text = value.RequireString();
  std::string remedy = "known here are";
  for (const auto& [known, name] : names) {
    if (name == text) return known;
    remedy += " \"" + std::string(name) + "\"";
  }
  throw value.Error(Quoted(text) + " is unknown", remedy);
}

// The member `key`, turned by `read`, if the object has it.
template <class T, class Read>
void ReadIfThere(const JsonValue& object, std::string_view key, T& into, Read read) {
  if (const std::optional<JsonValue> value = object.Find(key)) into = read(*value);
}

int Integer(const JsonValue& value, int least, int greatest) {
  return static_cast<int>(value.RequireInteger(least, greatest));
}

bool Boolean(const JsonValue& value) {
  if (value.kind() != JsonKind::kBoolean) {
    throw value.Error("is neither true nor false", "write true or false");
  }
  return value.text() == "true";
}

std::string PresetNames() {
  std::string names;
  for (const std::string_view name : kPresetProfiles) names += " " + std::string(name);
  return names;
}

int SubpixelBits(const JsonValue& value) {
  return value.kind() == JsonKind::kNull ? Snap::kNone : Integer(value, 0, kMaxSubpixelBits);
}

SnapRule SnapRuleFromJson(const JsonValue& value) {
  const std::optional<SnapRule> rule = SnapRuleFromName(value.RequireString());
  if (rule) return *rule;
  throw value.Error(Quoted(value.text()) + " is no snap rule",
                    "write nearest-even, nearest-away, half-up, floor or truncate");
}

SnapForm SnapFormFromJson(const JsonValue& value) {
  const std::optional<SnapForm> form = SnapFormFromName(value.RequireString());
  if (form) return *form;
  throw value.Error(Quoted(value.text()) + " is no snap form",
                    "write coordinate, float32-difference or exact-difference");
}

FillRule FillRuleFromJson(const JsonValue& value) {
  const std::optional<FillRule> rule = FillRuleFromName(value.RequireString());
  if (rule) return *rule;
  throw value.Error(Quoted(value.text()) + " is no fill rule",
                    "write top-left, top-right, bottom-left, bottom-right, one of them with -y "
                    "(y moves first), or inclusive");
}

// A place within a pixel. On multiples of 2^-8, pixel + place is exact.
double PlaceInPixel(const JsonValue& value, const std::string& what) {
  const double x = CoordinateFromJson(value, Precision::kFloat64);
  if (!(x >= 0 && x < 1) || x * 256 != std::floor(x * 256)) {
    throw value.Error("is not " + what, "write a multiple of 1/256 from 0 up to, not including, 1");
  }
  return x;
}

double LocationCoordinate(const JsonValue& value) {
  return PlaceInPixel(value, "a sample location");
}

double SnapOrigin(const JsonValue& value) { return PlaceInPixel(value, "a snap origin"); }

double SnapTolerance(const JsonValue& value) {
  const double steps = CoordinateFromJson(value, Precision::kFloat64);
  if (steps >= 0 && steps <= kMaxSnapTolerance) return steps;
  throw value.Error("is not a snap tolerance", "write a number of grid steps from 0 to 1");
}

SampleLattice LatticeFromJson(const JsonValue& list) {
  std::vector<Point2> locations;
  const JsonValue::Items items = list.RequireArray();
  const std::size_t size = items.size();
  if (size < 1 || size > std::size_t{kMaxSamplesPerPixel}) {
    throw list.Error("has " + std::to_string(size) + " sample locations",
                     "write from 1 to " + std::to_string(kMaxSamplesPerPixel));
  }
  for (const JsonValue item : items) {
    const JsonValue::Items pair = item.RequireArray();
    if (pair.size() != 2) {
      throw item.Error("has " + std::to_string(pair.size()) + " coordinates", "write [x, y]");
    }
    JsonValue::Iterator coordinate = pair.begin();
    const double x = LocationCoordinate(*coordinate);
    locations.push_back({x, LocationCoordinate(*++coordinate)});
  }
  return {std::move(locations)};
}

double LimitFromJson(const JsonValue& value) {
  const double limit = CoordinateFromJson(value, Precision::kFloat64);
  if (limit > 0 && std::isfinite(limit)) return limit;
  throw value.Error("is not a limit", "write a positive finite number");
}

Profile ProfileFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kString) {
    if (const std::optional<Profile> preset = PresetProfile(value.text())) return *preset;
    throw value.Error("the profile " + Quoted(value.text()) + " is unknown",
                      "write an object, or one of the presets" + PresetNames());
  }
  value.RequireObject(kProfileKeys);
  Profile profile;
  profile.name = value.Get("name").RequireString();
  ReadIfThere(value, "subpixel_bits", profile.snap.bits, SubpixelBits);
  ReadIfThere(value, "snap_rule", profile.snap.rule, SnapRuleFromJson);
  ReadIfThere(value, "snap_form", profile.snap.form, SnapFormFromJson);
  ReadIfThere(value, "snap_origin", profile.snap.origin, SnapOrigin);
  ReadIfThere(value, "sample_locations", profile.lattice, LatticeFromJson);
  ReadIfThere(value, "y_axis", profile.y_axis,
              [](const JsonValue& v) { return FromName(v, Names<YAxis>(kYAxes)); });
  ReadIfThere(value, "fill_rule", profile.fill_rule, FillRuleFromJson);
  ReadIfThere(value, "contract", profile.contract,
              [](const JsonValue& v) { return FromName(v, Names<Contract>(kContracts)); });
  ReadIfThere(value, "snap_tolerance", profile.freedom.snap_tolerance, SnapTolerance);
  ReadIfThere(value, "any_tie_rule", profile.freedom.any_tie_rule, Boolean);
  ReadIfThere(value, "coordinate_limit", profile.coordinate_limit, LimitFromJson);
  return profile;
}

std::optional<PixelRect> ScissorFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const JsonValue::Items sides = value.RequireArray();
  if (sides.size() != 4) {
    throw value.Error("has " + std::to_string(sides.size()) + " sides",
                      "write [x0, y0, x1, y1], or null");
  }
  PixelRect rect;
  const std::array<int*, 4> into{&rect.x0, &rect.y0, &rect.x1, &rect.y1};
  std::size_t k = 0;
  for (const JsonValue side : sides) *into[k++] = Integer(side, INT32_MIN, INT32_MAX);
  return rect;
}

DrawOptions OptionsFromJson(const JsonValue& value) {
  value.RequireObject(kOptionKeys);
  DrawOptions options;
  ReadIfThere(value, "cull", options.cull,
              [](const JsonValue& v) { return FromName(v, Names<Cull>(kCulls)); });
  ReadIfThere(value, "scissor", options.scissor, ScissorFromJson);
  ReadIfThere(value, "tile", options.tile,
              [](const JsonValue& v) { return Integer(v, 0, kMaxTile); });
  ReadIfThere(value, "threads", options.threads,
              [](const JsonValue& v) { return Integer(v, 0, kMaxThreads); });
  return options;
}

std::string TextFromJson(const JsonValue& value) { return std::string(value.RequireString()); }

void RequireVersion(const JsonValue& object) {
  const JsonValue version = object.Get("rasterproof_case");
  if (version.RequireInteger(0, INT32_MAX) == kVersion) return;
  throw version.Error("version " + std::string(version.text()) + " is unknown",
                      "this program reads version 1");
}

CaseFile CaseFromJson(const JsonValue& object) {
  CaseFile file;
  if (object.kind() == JsonKind::kObject && !object.Find("rasterproof_case")) {
    file.value.scene = SceneFromJson(object);
    return file;
  }
  object.RequireObject(kCaseKeys);
  RequireVersion(object);
  file.value.scene = SceneFromJson(object.Get("scene"));
  ReadIfThere(object, "profile", file.value.profile, ProfileFromJson);
  ReadIfThere(object, "options", file.value.options, OptionsFromJson);
  ReadIfThere(object, "origin", file.value.origin, TextFromJson);
  ReadIfThere(object, "subject", file.subject, TextFromJson);
  ReadIfThere(object, "property", file.property, TextFromJson);
  return file;
}

std::string InQuotes(std::string_view text) { return '"' + std::string(text) + '"'; }

}  // namespace

std::string ProfileToJson(const Profile& profile) {
  if (PresetProfile(profile.name) == profile) return JsonString(profile.name);
  std::string locations;
  for (const Point2& l : profile.lattice.locations) {
    locations += locations.empty() ? "[" : ", [";
    locations += InQuotes(ExactText(l.x)) + ", " + InQuotes(ExactText(l.y)) + "]";
  }
  const std::string line = ",\n    ";
  std::string json = "{\n    \"name\": " + JsonString(profile.name);
  json += line + "\"subpixel_bits\": ";
  json += profile.snap.IsNone() ? "null" : std::to_string(profile.snap.bits);
  json += line + "\"snap_rule\": " + InQuotes(SnapRuleName(profile.snap.rule));
  // Keys of a later day than the others: left out where they say nothing, so that files without
  // them stay as they are.
  if (profile.snap.form != SnapForm::kCoordinate || profile.snap.origin != 0) {
    json += line + "\"snap_form\": " + InQuotes(SnapFormName(profile.snap.form));
    json += line + "\"snap_origin\": " + InQuotes(ExactText(profile.snap.origin));
  }
  json += line + "\"sample_locations\": [" + locations + "]";
  json += line + "\"y_axis\": " + InQuotes(NameOf(profile.y_axis, Names<YAxis>(kYAxes)));
  json += line + "\"fill_rule\": " + InQuotes(FillRuleName(profile.fill_rule));
  json += line + "\"contract\": " + InQuotes(NameOf(profile.contract, Names<Contract>(kContracts)));
  if (!profile.freedom.IsNone()) {
    json += line + "\"snap_tolerance\": " + InQuotes(ExactText(profile.freedom.snap_tolerance));
    json += line + "\"any_tie_rule\": " + (profile.freedom.any_tie_rule ? "true" : "false");
  }
  json += line + "\"coordinate_limit\": " + InQuotes(ExactText(profile.coordinate_limit));
  return json + "\n  }";
}

namespace {

std::string OptionsToJson(const DrawOptions& options) {
  std::string json = "{\"cull\": " + InQuotes(NameOf(options.cull, Names<Cull>(kCulls)));
  if (const std::optional<PixelRect>& s = options.scissor) {
    json += ", \"scissor\": [" + std::to_string(s->x0) + ", " + std::to_string(s->y0) + ", " +
            std::to_string(s->x1) + ", " + std::to_string(s->y1) + "]";
  }
  json += ", \"tile\": " + std::to_string(options.tile);
  return json + ", \"threads\": " + std::to_string(options.threads) + "}";
}

std::string NameOfFile(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace

CaseFile ParseCase(std::string_view text, const std::string& place) {
  const JsonDocument document(text, place);
  return CaseFromJson(document.root());
}

CaseFile ReadCase(const std::string& path) { return ParseCase(ReadFile(path), NameOfFile(path)); }

std::string CaseToJson(const CaseFile& file) {
  const std::string line = ",\n  ";
  std::string json = "{\n  \"rasterproof_case\": " + std::to_string(kVersion);
  json += line + "\"subject\": " + JsonString(file.subject);
  json += line + "\"property\": " + JsonString(file.property);
  json += line + "\"origin\": " + JsonString(file.value.origin);
  json += line + "\"profile\": " + ProfileToJson(file.value.profile);
  json += line + "\"options\": " + OptionsToJson(file.value.options);
  json += line + "\"scene\": ";
  AppendSceneJson(file.value.scene, "  ", json);
  return json + "\n}\n";
}

Profile ReadProfile(const std::string& path_or_preset) {
  if (const std::optional<Profile> preset = PresetProfile(path_or_preset)) return *preset;
  std::error_code unknown;
  if (path_or_preset != "-" && !std::filesystem::exists(path_or_preset, unknown)) {
    throw InputError("profile " + Quoted(path_or_preset), "is neither a preset nor a file",
                     "the presets are" + PresetNames());
  }
  return ParseProfile(ReadFile(path_or_preset), NameOfFile(path_or_preset));
}

Profile ParseProfile(const std::string& text_or_preset, const std::string& place) {
  if (const std::optional<Profile> preset = PresetProfile(text_or_preset)) return *preset;
  const JsonDocument document(text_or_preset, place);
  return ProfileFromJson(document.root());
}

}  // namespace rasterproof::io
