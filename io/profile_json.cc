#include "io/profile_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/profile_keys.h"
#include "core/quoted.h"
#include "core/square_presets.h"
#include "core/suggestion.h"
#include "io/case_file.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/json_writer.h"
#include "io/pattern_json.h"
#include "io/placing_json.h"
#include "io/scene_json.h"
#include "io/specification_json.h"
#include "io/square_json.h"
#include "io/value_json.h"

namespace rasterproof::io {
namespace {

constexpr auto kTargetKeys =
    std::to_array<std::string_view>({"max_width", "max_height", "subpixel_bits", "snap_rule",
                                     "snap_form", "snap_origin", "sample_locations", "tie_rule"});
std::string Name(const JsonValue& value) { return value.RequireName(); }
std::string Text(const JsonValue& value) { return std::string(value.RequireString()); }

int SubpixelBits(const JsonValue& value) {
  return value.kind() == JsonKind::kNull ? Snap::kNone : Integer(value, 0, kMaxSubpixelBits);
}

TieRule TieRuleFromJson(const JsonValue& value) {
  const std::optional<TieRule> rule = TieRuleFromName(value.RequireString());
  if (rule) return *rule;
  throw value.Error(Quoted(value.text()) + " is not a tie rule",
                    "write top-left, top-right, bottom-left, bottom-right, one of them with -y "
                    "(y moves first), inclusive or exclusive");
}

void WriteText(JsonWriter& json, std::string_view text) { json.Text(text); }
void WriteExact(JsonWriter& json, double number) { json.Exact(number); }
void WriteBoolean(JsonWriter& json, bool value) { json.Bool(value); }
void WriteBits(JsonWriter& json, int bits) {
  if (bits == Snap::kNone) return static_cast<void>(json.Null());
  json.Integer(bits);
}
void WriteTieRule(JsonWriter& json, const TieRule& rule) { json.Text(TieRuleName(rule)); }

double SnapTolerance(const JsonValue& value) {
  const double steps = CoordinateFromJson(value, Precision::kFloat64);
  if (steps >= 0 && steps <= kMaxSnapTolerance) return steps;
  throw value.Error("is not a snap tolerance", "write a number of grid steps from 0 to 1");
}

double TransformError(const JsonValue& value) {
  const double units = CoordinateFromJson(value, Precision::kFloat64);
  if (units >= 0 && std::isfinite(units)) return units;
  throw value.Error(
      "is not a transform error",
      "write a multiple of 2^-24 of a coordinate, 0 or more, or null for none stated");
}

double SnapOrigin(const JsonValue& value) { return PlaceInPixel(value, "a snap origin"); }

double LimitFromJson(const JsonValue& value) {
  const double limit = CoordinateFromJson(value, Precision::kFloat64);
  if (limit > 0 && std::isfinite(limit)) return limit;
  throw value.Error("is not a limit", "write a positive finite number");
}

MaxPrimitiveExtent MaxPrimitiveExtentFromJson(const JsonValue& value) {
  const auto [width, height] = FiniteNumbers<2>(value, "[width, height]");
  if (width > 0 && height > 0) return MaxPrimitiveExtent{width, height};
  throw value.Error("is not a triangle size", "write two positive numbers");
}

LargestTarget LargestTargetFromJson(const JsonValue& value) {
  const JsonValue::Items items = value.RequireArray();
  if (items.size() != 2) {
    throw value.Error("has " + std::to_string(items.size()) + " numbers", "write [width, height]");
  }
  std::array<int, 2> sides{};
  std::size_t k = 0;
  for (const JsonValue side : items) sides[k++] = Integer(side, 1, kMaxTargetSide);
  return {sides[0], sides[1]};
}

constexpr std::string_view kTargetBand = "viewport";
constexpr std::string_view kUnknownBand = "unknown";
constexpr std::size_t kMostDigits = 9;

// "none", "unknown", "viewport" and "viewport+64".
std::optional<GuardBand> NamedGuardBand(const JsonValue& value) {
  const std::string name(value.RequireString());
  if (name == "none") return std::nullopt;
  if (name == kUnknownBand) return SomewhereAroundTarget{};
  if (name == kTargetBand) return AroundTarget{};
  const std::string beginning = std::string(kTargetBand) + "+";
  if (name.starts_with(beginning)) {
    const std::string pixels = name.substr(beginning.size());
    const bool is_digits = pixels.find_first_not_of("0123456789") == std::string::npos;
    if (is_digits && !pixels.empty() && pixels.size() <= kMostDigits)
      return AroundTarget{static_cast<double>(std::stoll(pixels))};
  }
  throw value.Error(Quoted(value.text()) + " is not a guard band",
                    "write none, unknown, viewport, viewport+64 or [x0, y0, x1, y1]");
}

void WriteMaxPrimitiveExtent(JsonWriter& json, const MaxPrimitiveExtent& most) {
  WriteNumbers(json, {most.width, most.height});
}

void WriteLargestTarget(JsonWriter& json, const LargestTarget& most) {
  json.BeginArray(kOneLine).Integer(most.width).Integer(most.height).EndArray();
}

void WriteGuardBand(JsonWriter& json, const GuardBand& band) {
  if (const auto* box = std::get_if<WindowBox>(&band))
    return WriteNumbers(json, {box->x0, box->y0, box->x1, box->y1});
  const auto* around = std::get_if<AroundTarget>(&band);
  if (around == nullptr) return WriteText(json, kUnknownBand);
  if (around->pixels == 0) return WriteText(json, kTargetBand);
  json.Text(std::string(kTargetBand) + "+" +
            std::to_string(static_cast<std::int64_t>(around->pixels)));
}

std::optional<GuardBand> GuardBandFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kString) return NamedGuardBand(value);
  const auto [x0, y0, x1, y1] = FiniteNumbers<4>(value, "[x0, y0, x1, y1]");
  if (x0 < x1 && y0 < y1) return WindowBox{x0, y0, x1, y1};
  throw value.Error("is empty", "write x0 < x1 and y0 < y1");
}

// How a key whose values are not all words is read and written.
struct KeyFormat {
  std::string_view name;
  void (*read)(const JsonValue& value, Profile& profile);
  void (*write)(JsonWriter& json, const Profile& profile);
};

template <class T>
constexpr bool kIsOptional = false;
template <class T>
constexpr bool kIsOptional<std::optional<T>> = true;

// A key whose value kRead reads and kWrite writes. An optional member without a value is null.
template <auto kRead, auto kWrite, auto... kMembers>
constexpr KeyFormat Value(std::string_view name) {
  return {name,
          [](const JsonValue& value, Profile& profile) {
            auto& member = MemberOf<kMembers...>(profile);
            if constexpr (kIsOptional<std::decay_t<decltype(member)>>) {
              if (value.kind() == JsonKind::kNull) return member.reset();
            }
            if constexpr (requires { kRead(value, profile); }) {
              member = kRead(value, profile);
            } else {
              member = kRead(value);
            }
          },
          [](JsonWriter& json, const Profile& profile) {
            const auto& member = MemberOf<kMembers...>(profile);
            if constexpr (kIsOptional<std::decay_t<decltype(member)>>) {
              if (!member) return static_cast<void>(json.Null());
              kWrite(json, *member);
            } else {
              kWrite(json, member);
            }
          }};
}

std::vector<TargetModel> TargetsFromJson(const JsonValue& list, const Profile& profile);
void WriteTargets(JsonWriter& json, const std::vector<TargetModel>& models);

constexpr auto kKeyFormats = std::to_array<KeyFormat>({
    Value<Name, WriteText, &Profile::name>("name"),
    Value<Text, WriteText, &Profile::specification>("specification"),
    Value<SubpixelBits, WriteBits, &Profile::snap, &Snap::bits>("subpixel_bits"),
    Value<SnapOrigin, WriteExact, &Profile::snap, &Snap::origin>("snap_origin"),
    Value<PatternFromJson, WritePattern, &Profile::pattern>("sample_locations"),
    Value<TieRuleFromJson, WriteTieRule, &Profile::tie_rule>("tie_rule"),
    Value<SnapTolerance, WriteExact, &Profile::freedom, &Freedom::snap_tolerance>("snap_tolerance"),
    Value<SubpixelBits, WriteBits, &Profile::freedom, &Freedom::least_bits>("least_subpixel_bits"),
    Value<TransformError, WriteExact, &Profile::freedom, &Freedom::transform_error>(
        "transform_error"),
    Value<LimitFromJson, WriteExact, &Profile::coordinate_limit>("coordinate_limit"),
    Value<Boolean, WriteBoolean, &Profile::translation_invariant>("translation_invariant"),
    Value<FixedInputFromJson, WriteFixed, &Profile::fixed>("fixed"),
    Value<MaxPrimitiveExtentFromJson, WriteMaxPrimitiveExtent, &Profile::max_primitive_extent>(
        "max_primitive_extent"),
    Value<LargestTargetFromJson, WriteLargestTarget, &Profile::max_target>("max_target"),
    Value<GuardBandFromJson, WriteGuardBand, &Profile::guard_band>("guard_band"),
    Value<ScanlineRoundingFromJson, WriteScanlineRounding, &Profile::scanline_rounding>(
        "scanline_rounding"),
    Value<TransformFromJson, WriteTransform, &Profile::transform>("transform"),
    Value<SquareRuleFromJson, WriteSquareRule, &Profile::squares>("coverage"),
    Value<ValueRuleFromJson, WriteValueRule, &Profile::values>("values"),
    Value<TargetsFromJson, WriteTargets, &Profile::by_target_size>("by_target_size"),
});
constexpr bool HasFormat(const ProfileKey& key) { return key.member.word == nullptr; }
static_assert(std::ranges::equal(kProfileKeys | std::views::filter(HasFormat), kKeyFormats, {},
                                 &ProfileKey::name, &KeyFormat::name),
              "each Value of core/profile_keys.h has a row here, in the same order");

const KeyFormat& FormatOf(const ProfileKey& key) {
  return *std::ranges::find(kKeyFormats, key.name, &KeyFormat::name);
}

void ReadKey(const ProfileKey& key, const JsonValue& value, Profile& profile) {
  if (HasFormat(key)) return FormatOf(key).read(value, profile);
  key.member.set_word(IndexOf(value, WordsOf(key)), profile);
}

void WriteMember(JsonWriter& json, const ProfileKey& key, const Profile& profile) {
  json.Key(key.name);
  if (HasFormat(key)) return FormatOf(key).write(json, profile);
  json.Text(WordsOf(key).at(key.member.word(profile)));
}

bool IsUnusual(std::string_view key, const Profile& profile) {
  Profile usual;
  KeyNamed(key).member.copy(profile, usual);
  return usual != Profile{};
}

bool IsWritten(const ProfileKey& key, const Profile& profile) {
  if ((key.marks & kWritten) != 0 || IsUnusual(key.name, profile)) return true;
  if (key.name == "snap_form") return IsUnusual("snap_origin", profile);
  if (key.name == "snap_origin") return IsUnusual("snap_form", profile);
  if (key.name == "snap_tolerance" || key.name == "rounding" || key.name == "tie_ownership")
    return !profile.freedom.IsNone();
  // A specification's set begins with its own front face.
  return key.name == "front_face" && !profile.specification.empty();
}

void WriteKeys(JsonWriter& json, const Profile& profile, const JsonLayout& layout) {
  json.BeginObject(layout);
  for (const ProfileKey& key : kProfileKeys) {
    if (IsWritten(key, profile)) WriteMember(json, key, profile);
  }
  json.EndObject();
}

bool IsOfTarget(std::string_view name) { return std::ranges::count(kTargetKeys, name) != 0; }

// Reads the keys that are there and that `is_read` is true of.
void ReadKeys(const JsonValue& object, Profile& profile, bool (*is_read)(std::string_view)) {
  for (const ProfileKey& key : kProfileKeys) {
    if (!is_read(key.name)) continue;
    if (const std::optional<JsonValue> value = object.Find(key.name)) ReadKey(key, *value, profile);
  }
}

TargetModel TargetFromJson(const JsonValue& value, const Profile& profile) {
  value.RequireObject(kTargetKeys);
  const auto side = [](const JsonValue& v) { return Integer(v, 1, kMaxTargetSide); };
  TargetModel target;
  ReadIfThere(value, "max_width", target.max_width, side);
  ReadIfThere(value, "max_height", target.max_height, side);
  Profile own = profile;
  ReadKeys(value, own, IsOfTarget);
  target.snap = own.snap;
  target.pattern = own.pattern;
  target.tie_rule = own.tie_rule;
  if (target.pattern.samples() == profile.pattern.samples()) return target;
  throw value.Get("sample_locations")
      .Error("has " + std::to_string(target.pattern.samples()) + " sample locations, the profile " +
                 std::to_string(profile.pattern.samples()),
             "give every target as many");
}

std::vector<TargetModel> TargetsFromJson(const JsonValue& list, const Profile& profile) {
  std::vector<TargetModel> models;
  for (const JsonValue item : list.RequireArray()) {
    const TargetModel target = TargetFromJson(item, profile);
    for (const TargetModel& earlier : models) {
      if (!earlier.Fits(target.max_width, target.max_height)) continue;
      throw item.Error("never applies: an entry before it fits every target that it fits",
                       "put the smaller targets first");
    }
    models.push_back(target);
  }
  return models;
}

void WriteTarget(JsonWriter& json, const TargetModel& target) {
  Profile own;
  own.snap = target.snap;
  own.pattern = target.pattern;
  own.tie_rule = target.tie_rule;
  json.BeginObject().Key("max_width").Integer(target.max_width);
  json.Key("max_height").Integer(target.max_height);
  // Written even where they are the default, or the profile's own would come back in their place.
  for (const ProfileKey& key : kProfileKeys)
    if (IsOfTarget(key.name)) WriteMember(json, key, own);
  json.EndObject();
}

void WriteTargets(JsonWriter& json, const std::vector<TargetModel>& models) {
  json.BeginArray(kOneLine);
  for (const TargetModel& target : models) WriteTarget(json, target);
  json.EndArray();
}

void RequireSound(const JsonValue& value, const Profile& profile) {
  if (profile.squares.has_value() != (profile.contract == Contract::kSquares)) {
    throw value.Error("has the key coverage or the contract squares, but not both",
                      "write both: \"contract\": \"squares\" is about what coverage states");
  }
  if (profile.front_face == FrontFace::kUnstated && profile.freedom.IsNone()) {
    throw value.Error("leaves only front_face unstated",
                      "write \"front_face\": \"positive-area\", and report facings by it");
  }
  if (profile.front_face == FrontFace::kUnstated && profile.culls != Cull::kNone) {
    throw value.Error("culls one side and leaves front_face unstated",
                      "write \"front_face\": \"positive-area\": culls names the side by its area");
  }
  RequireWithinItsSpecification(value, profile);
}

Profile ProfileFromObject(const JsonValue& value) {
  std::array<std::string_view, kProfileKeys.size()> names;
  std::ranges::transform(kProfileKeys, names.begin(), &ProfileKey::name);
  value.RequireObject(names);
  Profile profile = BeginningOf(value);
  static_cast<void>(value.Get("name"));  // the one that may not be left out
  ReadKeys(value, profile, [](std::string_view /*name*/) { return true; });
  RequireSound(value, profile);
  return profile;
}

}  // namespace

std::vector<std::string_view> PresetNames() {
  std::vector<std::string_view> names(kPresetProfiles.begin(), kPresetProfiles.end());
  for (const SquarePresetInfo& preset : kSquarePresets) names.push_back(preset.name);
  return names;
}

std::string ProfileName(const Profile& profile) {
  const std::optional<Profile> preset = PresetProfile(profile.name);
  return !preset || *preset == profile ? profile.name : profile.name + ", changed";
}

Profile ProfileFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kString) {
    if (const std::optional<Profile> preset = PresetProfile(value.text())) return *preset;
    throw value.Error("the profile " + Quoted(value.text()) + " is unknown",
                      Suggestion(value.text(), PresetNames()) +
                          "write an object, or one of the presets" + ListedNames(PresetNames()));
  }
  Profile profile = ProfileFromObject(value);
  if (ProfileName(profile) == profile.name) return profile;
  throw value.Get("name").Error(
      Quoted(profile.name) + " names a preset, but this differs from the preset",
      "give it another name, or write " + Quoted(profile.name) + " alone for the preset");
}

std::string WholeProfileLine(const Profile& profile) {
  JsonWriter json;
  WriteKeys(json, profile, kOneLine);
  return json.json();
}

void WriteProfile(JsonWriter& json, const Profile& profile) {
  if (PresetProfile(profile.name) == profile) return WriteText(json, profile.name);
  Profile named = profile;
  named.name = ProfileName(profile);
  WriteKeys(json, named, kLines);
}

std::string ProfileToJson(const Profile& profile) {
  JsonWriter json(1);
  WriteProfile(json, profile);
  return json.json();
}

}  // namespace rasterproof::io
