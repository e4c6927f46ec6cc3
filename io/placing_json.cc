#include "io/placing_json.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "core/profile_keys.h"
#include "core/scene.h"
#include "io/json_members.h"
#include "io/pattern_json.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr auto kFixedKeys =
    std::to_array<std::string_view>({"integer_bits", "fraction_bits", "signed", "wrap"});

constexpr auto kScanlineRoundingKeys = std::to_array<std::string_view>({"bits", "rule", "origin"});
constexpr auto kTransformKeys =
    std::to_array<std::string_view>({"precision", "division", "viewport", "flips_y", "map"});

constexpr std::array<std::pair<Precision, std::string_view>, 2> kPrecisions{
    {{Precision::kFloat32, "float32"}, {Precision::kFloat64, "float64"}}};
constexpr std::array<std::pair<Division, std::string_view>, 2> kDivisions{
    {{Division::kQuotient, "quotient"}, {Division::kReciprocal, "reciprocal"}}};
constexpr std::array<std::pair<ViewportForm, std::string_view>, 4> kViewportForms{
    {{ViewportForm::kNone, "none"},
     {ViewportForm::kMultiplyAdd, "multiply-add"},
     {ViewportForm::kFused, "fused"},
     {ViewportForm::kAddMultiply, "add-multiply"}}};

std::optional<MapGrid> MapFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  const auto [x0, y0, dx, dy] = FiniteNumbers<4>(value, "[x0, y0, dx, dy]");
  if (dx != 0 && dy != 0) return MapGrid{x0, y0, dx, dy};
  throw value.Error("has a step of zero", "write dx and dy in the map's units, dy < 0 for y up");
}

}  // namespace

FixedInput FixedInputFromJson(const JsonValue& value) {
  value.RequireObject(kFixedKeys);
  FixedInput fixed;
  fixed.integer_bits = Integer(value.Get("integer_bits"), 1, kMaxIntegerBits);
  fixed.fraction_bits = Integer(value.Get("fraction_bits"), 0, kMaxSubpixelBits);
  ReadIfThere(value, "signed", fixed.is_signed, Boolean);
  ReadIfThere(value, "wrap", fixed.wraps, Boolean);
  return fixed;
}

Snap ScanlineRoundingFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return {};
  value.RequireObject(kScanlineRoundingKeys);
  Snap rounding;
  rounding.bits = Integer(value.Get("bits"), 0, kMaxSubpixelBits);
  ReadIfThere(value, "rule", rounding.rule, [](const JsonValue& v) {
    return static_cast<SnapRule>(IndexOf(v, WordsOf(KeyNamed("snap_rule"))));
  });
  ReadIfThere(value, "origin", rounding.origin,
              [](const JsonValue& v) { return PlaceInPixel(v, "a snap origin"); });
  if (rounding.origin != 0) rounding.form = SnapForm::kExactDifference;
  return rounding;
}

Transform TransformFromJson(const JsonValue& value) {
  value.RequireObject(kTransformKeys);
  Transform transform;
  ReadIfThere(value, "precision", transform.precision,
              [](const JsonValue& v) { return FromName(v, Names<Precision>(kPrecisions)); });
  ReadIfThere(value, "division", transform.division,
              [](const JsonValue& v) { return FromName(v, Names<Division>(kDivisions)); });
  ReadIfThere(value, "viewport", transform.viewport,
              [](const JsonValue& v) { return FromName(v, Names<ViewportForm>(kViewportForms)); });
  ReadIfThere(value, "flips_y", transform.flips_y, Boolean);
  ReadIfThere(value, "map", transform.map, MapFromJson);
  if (transform.map && (transform.viewport != ViewportForm::kNone || transform.flips_y)) {
    throw value.Error("has a map and a viewport",
                      "leave viewport and flips_y out: a map's dy flips y");
  }
  return transform;
}

void WriteFixed(JsonWriter& json, const FixedInput& fixed) {
  json.BeginObject(kOneLine).Key("integer_bits").Integer(fixed.integer_bits);
  json.Key("fraction_bits").Integer(fixed.fraction_bits);
  json.Key("signed").Bool(fixed.is_signed).Key("wrap").Bool(fixed.wraps).EndObject();
}

void WriteScanlineRounding(JsonWriter& json, const Snap& rounding) {
  if (rounding.IsNone()) return static_cast<void>(json.Null());
  json.BeginObject(kOneLine).Key("bits").Integer(rounding.bits);
  json.Key("rule").Text(SnapRuleName(rounding.rule));
  json.Key("origin").Exact(rounding.origin).EndObject();
}

void WriteTransform(JsonWriter& json, const Transform& transform) {
  json.BeginObject(kOneLine);
  json.Key("precision").Text(NameOf(transform.precision, Names<Precision>(kPrecisions)));
  json.Key("division").Text(NameOf(transform.division, Names<Division>(kDivisions)));
  json.Key("viewport").Text(NameOf(transform.viewport, Names<ViewportForm>(kViewportForms)));
  json.Key("flips_y").Bool(transform.flips_y);
  if (const std::optional<MapGrid>& map = transform.map)
    WriteNumbers(json.Key("map"), {map->x0, map->y0, map->dx, map->dy});
  json.EndObject();
}

}  // namespace rasterproof::io
