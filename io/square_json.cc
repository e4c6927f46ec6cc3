#include "io/square_json.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/json_members.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr auto kRuleKeys = std::to_array<std::string_view>({"must", "may", "flat"});
constexpr auto kRegionKeys = std::to_array<std::string_view>(
    {"relation", "square", "shape", "geometry", "growth", "half_width"});

constexpr std::array<std::pair<SquareRelation, std::string_view>, 2> kRelations{
    {{SquareRelation::kIntersects, "intersects"}, {SquareRelation::kContains, "contains"}}};
constexpr std::array<std::pair<Closure, std::string_view>, 3> kClosures{
    {{Closure::kClosed, "closed"}, {Closure::kOpen, "open"}, {Closure::kHalfOpen, "half-open"}}};
constexpr std::array<std::pair<SquareGeometry, std::string_view>, 2> kGeometries{
    {{SquareGeometry::kGiven, "given"}, {SquareGeometry::kPlaced, "placed"}}};
constexpr std::array<std::pair<SquareGrowth, std::string_view>, 2> kGrowths{
    {{SquareGrowth::kSwept, "swept"}, {SquareGrowth::kEdges, "edges"}}};
constexpr std::array<std::pair<FlatSquares, std::string_view>, 3> kFlats{
    {{FlatSquares::kNothing, "nothing"},
     {FlatSquares::kFree, "free"},
     {FlatSquares::kDrawn, "drawn"}}};

double HalfWidth(const JsonValue& value) {
  const double width = CoordinateFromJson(value, Precision::kFloat64);
  const double steps = width / kSquareStep;
  if (width >= kLeastHalfWidth && width <= kLargestHalfWidth && steps == std::floor(steps)) {
    return width;
  }
  throw value.Error("is not a half width",
                    "write a multiple of 2^-20 pixel, at least -7/16 and at most 1");
}

std::optional<SquareRegion> RegionFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kNull) return std::nullopt;
  value.RequireObject(kRegionKeys);
  SquareRegion region;
  region.relation = FromName(value.Get("relation"), Names<SquareRelation>(kRelations));
  const auto closure = [](const JsonValue& v) { return FromName(v, Names<Closure>(kClosures)); };
  ReadIfThere(value, "square", region.square, closure);
  ReadIfThere(value, "shape", region.shape, closure);
  ReadIfThere(value, "geometry", region.geometry,
              [](const JsonValue& v) { return FromName(v, Names<SquareGeometry>(kGeometries)); });
  ReadIfThere(value, "growth", region.growth,
              [](const JsonValue& v) { return FromName(v, Names<SquareGrowth>(kGrowths)); });
  ReadIfThere(value, "half_width", region.half_width, HalfWidth);
  if (IsDecidable(region)) return region;
  throw value.Error("lets a closed square meet a half-open shape, which the oracle can't decide",
                    "write a half-open square, or an open or closed shape");
}

void WriteRegion(JsonWriter& json, const std::optional<SquareRegion>& region) {
  if (!region) return static_cast<void>(json.Null());
  json.BeginObject(kOneLine);
  json.Key("relation").Text(NameOf(region->relation, Names<SquareRelation>(kRelations)));
  json.Key("square").Text(NameOf(region->square, Names<Closure>(kClosures)));
  json.Key("shape").Text(NameOf(region->shape, Names<Closure>(kClosures)));
  json.Key("geometry").Text(NameOf(region->geometry, Names<SquareGeometry>(kGeometries)));
  json.Key("growth").Text(NameOf(region->growth, Names<SquareGrowth>(kGrowths)));
  json.Key("half_width").Exact(region->half_width).EndObject();
}

}  // namespace

SquareRule SquareRuleFromJson(const JsonValue& value) {
  value.RequireObject(kRuleKeys);
  SquareRule rule;
  ReadIfThere(value, "must", rule.must, RegionFromJson);
  ReadIfThere(value, "may", rule.may, RegionFromJson);
  ReadIfThere(value, "flat", rule.flat,
              [](const JsonValue& v) { return FromName(v, Names<FlatSquares>(kFlats)); });
  if (rule.must || rule.may) return rule;
  throw value.Error("states neither a must nor a may region",
                    "give it a must or a may region, or leave coverage out");
}

void WriteSquareRule(JsonWriter& json, const SquareRule& rule) {
  json.BeginObject(kFromThisLine);
  WriteRegion(json.Key("must"), rule.must);
  WriteRegion(json.Key("may"), rule.may);
  json.Key("flat").Text(NameOf(rule.flat, Names<FlatSquares>(kFlats))).EndObject();
}

}  // namespace rasterproof::io
