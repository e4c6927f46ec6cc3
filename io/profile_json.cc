#include "io/profile_json.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/quoted.h"
#include "core/square_presets.h"
#include "core/suggestion.h"
#include "io/case_file.h"
#include "io/freedom_json.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/number_text.h"
#include "io/pattern_json.h"
#include "io/scene_json.h"
#include "io/specification_json.h"
#include "io/square_json.h"

namespace rasterproof::io {
namespace {

constexpr auto kProfileKeys = std::to_array<std::string_view>({"name",
                                                               "specification",
                                                               "subpixel_bits",
                                                               "snap_rule",
                                                               "snap_form",
                                                               "snap_origin",
                                                               "sample_locations",
                                                               "sample_positions",
                                                               "centroid",
                                                               "y_axis",
                                                               "front_face",
                                                               "tie_rule",
                                                               "coordinate_limit",
                                                               "contract",
                                                               "snap_tolerance",
                                                               "rounding",
                                                               "least_subpixel_bits",
                                                               "tie_ownership",
                                                               "transform_error",
                                                               "nan_vertex",
                                                               "nan_z",
                                                               "translation_invariant",
                                                               "degenerate_triangles",
                                                               "edge_samples",
                                                               "fixed",
                                                               "max_primitive_extent",
                                                               "guard_band",
                                                               "scanline_rounding",
                                                               "transform",
                                                               "by_target_size",
                                                               "infinite_vertex",
                                                               "coverage"});
constexpr auto kTargetKeys =
    std::to_array<std::string_view>({"max_width", "max_height", "subpixel_bits", "snap_rule",
                                     "snap_form", "snap_origin", "sample_locations", "tie_rule"});
constexpr auto kFixedKeys =
    std::to_array<std::string_view>({"integer_bits", "fraction_bits", "signed", "wrap"});

constexpr auto kScanlineRoundingKeys = std::to_array<std::string_view>({"bits", "rule", "origin"});
constexpr auto kTransformKeys =
    std::to_array<std::string_view>({"precision", "division", "viewport", "flips_y", "map"});

constexpr std::array<std::pair<Precision, std::string_view>, 2> kPrecisions{
    {{Precision::kFloat32, "float32"}, {Precision::kFloat64, "float64"}}};
constexpr std::array<std::pair<YAxis, std::string_view>, 2> kYAxes{
    {{YAxis::kDown, "down"}, {YAxis::kUp, "up"}}};
constexpr std::array<std::pair<FrontFace, std::string_view>, 2> kFrontFaces{
    {{FrontFace::kPositiveArea, "positive-area"}, {FrontFace::kUnstated, "unstated"}}};
constexpr std::array<std::pair<SamplePositions, std::string_view>, 3> kSamplePositions{
    {{SamplePositions::kStated, "stated"},
     {SamplePositions::kFixed, "fixed"},
     {SamplePositions::kVary, "vary"}}};
constexpr std::array<std::pair<Centroid, std::string_view>, 3> kCentroids{
    {{Centroid::kUnstated, "unstated"},
     {Centroid::kDirect3D, "direct3d"},
     {Centroid::kInside, "inside"}}};
constexpr std::array<std::pair<Contract, std::string_view>, 7> kContracts{
    {{Contract::kSampleExact, "sample-exact"},
     {Contract::kWatertight, "watertight"},
     {Contract::kClosed, "closed"},
     {Contract::kAtLeastModel, "at-least-model"},
     {Contract::kAtMostModel, "at-most-model"},
     {Contract::kSquares, "squares"},
     {Contract::kNone, "none"}}};
constexpr std::array<std::pair<DegenerateTriangles, std::string_view>, 2> kDegenerates{
    {{DegenerateTriangles::kNothing, "nothing"},
     {DegenerateTriangles::kUnspecified, "unspecified"}}};
constexpr std::array<std::pair<InfiniteVertex, std::string_view>, 2> kInfiniteVertices{
    {{InfiniteVertex::kNothing, "nothing"}, {InfiniteVertex::kUnspecified, "unspecified"}}};
constexpr std::array<std::pair<NanVertex, std::string_view>, 2> kNanVertices{
    {{NanVertex::kNothing, "nothing"}, {NanVertex::kUnspecified, "unspecified"}}};
constexpr std::array<std::pair<NanZ, std::string_view>, 3> kNanZs{
    {{NanZ::kIgnored, "ignored"},
     {NanZ::kNothing, "nothing"},
     {NanZ::kUnspecified, "unspecified"}}};
constexpr std::array<std::pair<bool, std::string_view>, 2> kEdgeSamples{
    {{false, "owned"}, {true, "may-be-shared"}}};

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

TieRule TieRuleFromJson(const JsonValue& value) {
  const std::optional<TieRule> rule = TieRuleFromName(value.RequireString());
  if (rule) return *rule;
  throw value.Error(Quoted(value.text()) + " is no tie rule",
                    "write top-left, top-right, bottom-left, bottom-right, one of them with -y "
                    "(y moves first), inclusive or exclusive");
}

double SnapOrigin(const JsonValue& value) { return PlaceInPixel(value, "a snap origin"); }

double LimitFromJson(const JsonValue& value) {
  const double limit = CoordinateFromJson(value, Precision::kFloat64);
  if (limit > 0 && std::isfinite(limit)) return limit;
  throw value.Error("is not a limit", "write a positive finite number");
}

// The numbers of an array, as many as `names` says: "[x0, y0, x1, y1]".
template <std::size_t kCount>
std::array<double, kCount> FiniteNumbers(const JsonValue& list, const std::string& names) {
  const JsonValue::Items items = list.RequireArray();
  if (items.size() != kCount) {
    throw list.Error("has " + std::to_string(items.size()) + " numbers",
                     "write " + names + ", or null");
  }
  std::array<double, kCount> numbers{};
  std::size_t k = 0;
  for (const JsonValue item : items) {
    numbers[k] = CoordinateFromJson(item, Precision::kFloat64);
    if (!std::isfinite(numbers[k++])) throw item.Error("is not finite", "write a finite number");
  }
  return numbers;
}

std::optional<MaxPrimitiveExtent> MaxPrimitiveExtentFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const auto [width, height] = FiniteNumbers<2>(value, "[width, height]");
  if (width > 0 && height > 0) return MaxPrimitiveExtent{width, height};
  throw value.Error("is not the size of a triangle", "write two positive numbers");
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
      return AroundTarget{std::stod(pixels)};
  }
  throw value.Error(Quoted(value.text()) + " is no guard band",
                    "write none, unknown, viewport, viewport+64 or [x0, y0, x1, y1]");
}

std::string GuardBandToJson(const GuardBand& band) {
  if (const auto* box = std::get_if<WindowBox>(&band))
    return NumbersToJson({box->x0, box->y0, box->x1, box->y1});
  const auto* around = std::get_if<AroundTarget>(&band);
  if (around == nullptr) return InQuotes(kUnknownBand);
  if (around->pixels == 0) return InQuotes(kTargetBand);
  return InQuotes(std::string(kTargetBand) + "+" +
                  std::to_string(static_cast<std::int64_t>(around->pixels)));
}

std::optional<GuardBand> GuardBandFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  if (value.kind() == JsonKind::kString) return NamedGuardBand(value);
  const auto [x0, y0, x1, y1] = FiniteNumbers<4>(value, "[x0, y0, x1, y1]");
  if (x0 < x1 && y0 < y1) return WindowBox{x0, y0, x1, y1};
  throw value.Error("is empty", "write x0 < x1 and y0 < y1");
}

std::optional<FixedInput> FixedInputFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  value.RequireObject(kFixedKeys);
  FixedInput fixed;
  fixed.integer_bits = Integer(value.Get("integer_bits"), 1, kMaxIntegerBits);
  fixed.fraction_bits = Integer(value.Get("fraction_bits"), 0, kMaxSubpixelBits);
  ReadIfThere(value, "signed", fixed.is_signed, Boolean);
  ReadIfThere(value, "wrap", fixed.wraps, Boolean);
  return fixed;
}

void ReadSnap(const JsonValue& value, Snap& snap) {
  ReadIfThere(value, "subpixel_bits", snap.bits, SubpixelBits);
  ReadIfThere(value, "snap_rule", snap.rule, SnapRuleFromJson);
  ReadIfThere(value, "snap_form", snap.form, SnapFormFromJson);
  ReadIfThere(value, "snap_origin", snap.origin, SnapOrigin);
}

Snap ScanlineRoundingFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return {};
  value.RequireObject(kScanlineRoundingKeys);
  Snap rounding;
  rounding.bits = Integer(value.Get("bits"), 0, kMaxSubpixelBits);
  ReadIfThere(value, "rule", rounding.rule, SnapRuleFromJson);
  ReadIfThere(value, "origin", rounding.origin, SnapOrigin);
  if (rounding.origin != 0) rounding.form = SnapForm::kExactDifference;
  return rounding;
}

std::optional<MapGrid> MapFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const auto [x0, y0, dx, dy] = FiniteNumbers<4>(value, "[x0, y0, dx, dy]");
  if (dx != 0 && dy != 0) return MapGrid{x0, y0, dx, dy};
  throw value.Error("has a step of zero", "write dx and dy in the map's units, dy < 0 for y up");
}

Transform TransformFromJson(const JsonValue& value) {
  value.RequireObject(kTransformKeys);
  Transform transform;
  ReadIfThere(value, "precision", transform.precision,
              [](const JsonValue& v) { return FromName(v, Names<Precision>(kPrecisions)); });
  ReadIfThere(value, "division", transform.division, [](const JsonValue& v) {
    if (const auto division = DivisionFromName(v.RequireString())) return *division;
    throw v.Error(Quoted(v.text()) + " is no division", "write quotient or reciprocal");
  });
  ReadIfThere(value, "viewport", transform.viewport, [](const JsonValue& v) {
    if (const auto form = ViewportFormFromName(v.RequireString())) return *form;
    throw v.Error(Quoted(v.text()) + " is no viewport form",
                  "write none, multiply-add, fused or add-multiply");
  });
  ReadIfThere(value, "flips_y", transform.flips_y, Boolean);
  ReadIfThere(value, "map", transform.map, MapFromJson);
  if (transform.map && (transform.viewport != ViewportForm::kNone || transform.flips_y)) {
    throw value.Error("has a map and a viewport",
                      "leave viewport and flips_y out: a map's dy turns y over");
  }
  return transform;
}

TargetModel TargetFromJson(const JsonValue& value, const Profile& profile) {
  value.RequireObject(kTargetKeys);
  const auto side = [](const JsonValue& v) { return Integer(v, 1, kMaxTargetSide); };
  TargetModel target{
      .snap = profile.snap, .pattern = profile.pattern, .tie_rule = profile.tie_rule};
  ReadIfThere(value, "max_width", target.max_width, side);
  ReadIfThere(value, "max_height", target.max_height, side);
  ReadSnap(value, target.snap);
  ReadIfThere(value, "sample_locations", target.pattern, PatternFromJson);
  ReadIfThere(value, "tie_rule", target.tie_rule, TieRuleFromJson);
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

// The keys of a model: those that an entry of `by_target_size` can override.
std::string SnapToJson(const Snap& snap, const std::string& line) {
  std::string json = line + "\"subpixel_bits\": ";
  json += snap.IsNone() ? "null" : std::to_string(snap.bits);
  json += line + "\"snap_rule\": " + InQuotes(SnapRuleName(snap.rule));
  // Keys of a later day than the others: left out where they say nothing, so that files without
  // them stay as they are.
  if (snap.form != SnapForm::kCoordinate || snap.origin != 0) {
    json += line + "\"snap_form\": " + InQuotes(SnapFormName(snap.form));
    json += line + "\"snap_origin\": " + InQuotes(ExactText(snap.origin));
  }
  return json;
}

std::string TargetsToJson(const std::vector<TargetModel>& models) {
  std::string json;
  for (const TargetModel& target : models) {
    json += json.empty() ? "[{" : ", {";
    json += "\"max_width\": " + std::to_string(target.max_width);
    json += ", \"max_height\": " + std::to_string(target.max_height);
    json += SnapToJson(target.snap, ", ");
    // Written even if it is none, or the profile's own would come back in its place.
    if (target.snap.form == SnapForm::kCoordinate && target.snap.origin == 0) {
      json += ", \"snap_form\": \"coordinate\", \"snap_origin\": 0";
    }
    json += ", \"sample_locations\": " + PatternToJson(target.pattern);
    json += ", \"tie_rule\": " + InQuotes(TieRuleName(target.tie_rule)) + "}";
  }
  return json + "]";
}

std::string FixedToJson(const FixedInput& fixed) {
  return "{\"integer_bits\": " + std::to_string(fixed.integer_bits) +
         ", \"fraction_bits\": " + std::to_string(fixed.fraction_bits) +
         ", \"signed\": " + (fixed.is_signed ? "true" : "false") +
         ", \"wrap\": " + (fixed.wraps ? "true" : "false") + "}";
}

std::string ScanlineRoundingToJson(const Snap& rounding) {
  return "{\"bits\": " + std::to_string(rounding.bits) +
         ", \"rule\": " + InQuotes(SnapRuleName(rounding.rule)) +
         ", \"origin\": " + InQuotes(ExactText(rounding.origin)) + "}";
}

std::string TransformToJson(const Transform& transform) {
  const std::optional<MapGrid>& map = transform.map;
  return "{\"precision\": " + InQuotes(NameOf(transform.precision, Names<Precision>(kPrecisions))) +
         ", \"division\": " + InQuotes(DivisionName(transform.division)) +
         ", \"viewport\": " + InQuotes(ViewportFormName(transform.viewport)) +
         ", \"flips_y\": " + (transform.flips_y ? "true" : "false") +
         (map ? ", \"map\": " + NumbersToJson({map->x0, map->y0, map->dx, map->dy}) : "") + "}";
}

// What most profiles leave out.
std::string RareKeysToJson(const Profile& profile, const std::string& line) {
  std::string json;
  if (profile.degenerate_triangles != DegenerateTriangles::kNothing) {
    json +=
        line + "\"degenerate_triangles\": " +
        InQuotes(NameOf(profile.degenerate_triangles, Names<DegenerateTriangles>(kDegenerates)));
  }
  if (profile.infinite_vertex != InfiniteVertex::kNothing) {
    json += line + "\"infinite_vertex\": " +
            InQuotes(NameOf(profile.infinite_vertex, Names<InfiniteVertex>(kInfiniteVertices)));
  }
  if (profile.nan_vertex != NanVertex::kNothing) {
    json += line + "\"nan_vertex\": " +
            InQuotes(NameOf(profile.nan_vertex, Names<NanVertex>(kNanVertices)));
  }
  if (profile.nan_z != NanZ::kIgnored) {
    json += line + "\"nan_z\": " + InQuotes(NameOf(profile.nan_z, Names<NanZ>(kNanZs)));
  }
  // A specification's set begins with its own.
  if (profile.front_face != FrontFace::kPositiveArea || !profile.specification.empty()) {
    json += line + "\"front_face\": " +
            InQuotes(NameOf(profile.front_face, Names<FrontFace>(kFrontFaces)));
  }
  if (profile.sample_positions != SamplePositions::kStated) {
    json += line + "\"sample_positions\": " +
            InQuotes(NameOf(profile.sample_positions, Names<SamplePositions>(kSamplePositions)));
  }
  if (profile.centroid != Centroid::kUnstated) {
    json +=
        line + "\"centroid\": " + InQuotes(NameOf(profile.centroid, Names<Centroid>(kCentroids)));
  }
  if (profile.translation_invariant) json += line + "\"translation_invariant\": true";
  if (profile.shares_edge_samples) {
    json += line + "\"edge_samples\": " + InQuotes(NameOf(true, Names<bool>(kEdgeSamples)));
  }
  if (profile.fixed) json += line + "\"fixed\": " + FixedToJson(*profile.fixed);
  if (const std::optional<MaxPrimitiveExtent>& most = profile.max_primitive_extent) {
    json += line + "\"max_primitive_extent\": " + NumbersToJson({most->width, most->height});
  }
  if (profile.guard_band) json += line + "\"guard_band\": " + GuardBandToJson(*profile.guard_band);
  if (!profile.scanline_rounding.IsNone())
    json += line + "\"scanline_rounding\": " + ScanlineRoundingToJson(profile.scanline_rounding);
  if (profile.transform) json += line + "\"transform\": " + TransformToJson(*profile.transform);
  if (profile.squares) json += line + "\"coverage\": " + SquareRuleToJson(*profile.squares);
  if (!profile.by_target_size.empty())
    json += line + "\"by_target_size\": " + TargetsToJson(profile.by_target_size);
  return json;
}

Profile ProfileFromObject(const JsonValue& value) {
  value.RequireObject(kProfileKeys);
  Profile profile = BeginningOf(value);
  profile.name = value.Get("name").RequireName();
  ReadSnap(value, profile.snap);
  ReadIfThere(value, "sample_locations", profile.pattern, PatternFromJson);
  ReadIfThere(value, "y_axis", profile.y_axis,
              [](const JsonValue& v) { return FromName(v, Names<YAxis>(kYAxes)); });
  ReadIfThere(value, "front_face", profile.front_face,
              [](const JsonValue& v) { return FromName(v, Names<FrontFace>(kFrontFaces)); });
  ReadIfThere(value, "tie_rule", profile.tie_rule, TieRuleFromJson);
  ReadIfThere(value, "contract", profile.contract,
              [](const JsonValue& v) { return FromName(v, Names<Contract>(kContracts)); });
  ReadFreedom(value, profile.freedom);
  ReadIfThere(value, "coordinate_limit", profile.coordinate_limit, LimitFromJson);
  ReadIfThere(value, "degenerate_triangles", profile.degenerate_triangles, [](const JsonValue& v) {
    return FromName(v, Names<DegenerateTriangles>(kDegenerates));
  });
  ReadIfThere(value, "infinite_vertex", profile.infinite_vertex, [](const JsonValue& v) {
    return FromName(v, Names<InfiniteVertex>(kInfiniteVertices));
  });
  ReadIfThere(value, "nan_vertex", profile.nan_vertex,
              [](const JsonValue& v) { return FromName(v, Names<NanVertex>(kNanVertices)); });
  ReadIfThere(value, "nan_z", profile.nan_z,
              [](const JsonValue& v) { return FromName(v, Names<NanZ>(kNanZs)); });
  ReadIfThere(value, "sample_positions", profile.sample_positions, [](const JsonValue& v) {
    return FromName(v, Names<SamplePositions>(kSamplePositions));
  });
  ReadIfThere(value, "centroid", profile.centroid,
              [](const JsonValue& v) { return FromName(v, Names<Centroid>(kCentroids)); });
  ReadIfThere(value, "translation_invariant", profile.translation_invariant, Boolean);
  ReadIfThere(value, "edge_samples", profile.shares_edge_samples,
              [](const JsonValue& v) { return FromName(v, Names<bool>(kEdgeSamples)); });
  ReadIfThere(value, "fixed", profile.fixed, FixedInputFromJson);
  ReadIfThere(value, "max_primitive_extent", profile.max_primitive_extent,
              MaxPrimitiveExtentFromJson);
  ReadIfThere(value, "guard_band", profile.guard_band, GuardBandFromJson);
  ReadIfThere(value, "scanline_rounding", profile.scanline_rounding, ScanlineRoundingFromJson);
  ReadIfThere(value, "transform", profile.transform, TransformFromJson);
  ReadIfThere(value, "coverage", profile.squares, SquareRuleFromJson);
  if (profile.squares.has_value() != (profile.contract == Contract::kSquares)) {
    throw value.Error("has the key coverage or the contract squares, but not both",
                      "write both: \"contract\": \"squares\" is about what coverage states");
  }
  if (profile.front_face == FrontFace::kUnstated && profile.freedom.IsNone()) {
    throw value.Error("leaves front_face unstated and nothing else free",
                      "write \"front_face\": \"positive-area\", and tell facings by that");
  }
  // Last: an entry has of the profile what it leaves out.
  ReadIfThere(value, "by_target_size", profile.by_target_size,
              [&](const JsonValue& v) { return TargetsFromJson(v, profile); });
  RequireWithinItsSpecification(value, profile);
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
      Quoted(profile.name) + " is the name of a preset, and this is not what the preset says",
      "give it another name, or write " + Quoted(profile.name) + " alone for the preset");
}

std::string ProfileToJson(const Profile& profile) {
  if (PresetProfile(profile.name) == profile) return JsonString(profile.name);
  const std::string line = ",\n    ";
  std::string json = "{\n    \"name\": " + JsonString(ProfileName(profile));
  if (!profile.specification.empty())
    json += line + "\"specification\": " + JsonString(profile.specification);
  json += SnapToJson(profile.snap, line);
  json += line + "\"sample_locations\": " + PatternToJson(profile.pattern);
  json += line + "\"y_axis\": " + InQuotes(NameOf(profile.y_axis, Names<YAxis>(kYAxes)));
  json += line + "\"tie_rule\": " + InQuotes(TieRuleName(profile.tie_rule));
  json += line + "\"contract\": " + InQuotes(NameOf(profile.contract, Names<Contract>(kContracts)));
  if (!profile.freedom.IsNone()) json += FreedomToJson(profile.freedom, line);
  json += line + "\"coordinate_limit\": " + InQuotes(ExactText(profile.coordinate_limit));
  return json + RareKeysToJson(profile, line) + "\n  }";
}

}  // namespace rasterproof::io
