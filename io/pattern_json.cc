#include "io/pattern_json.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quoted.h"
#include "io/json_members.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

std::optional<int> WholeNumber(std::string_view text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

// "3/8". Off the grid of 2^-8, a rounded quotient is so too.
std::optional<double> Fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::optional<int> above = WholeNumber(text.substr(0, slash));
  const std::optional<int> below = WholeNumber(text.substr(slash + 1));
  if (!above || !below || *below <= 0) return std::nullopt;
  return static_cast<double>(*above) / *below;
}

SamplePattern StandardPatternFromJson(const JsonValue& value) {
  constexpr std::string_view kStart = "standard-";
  const std::string_view name = value.text();
  if (name.starts_with(kStart)) {
    const auto samples = WholeNumber(name.substr(kStart.size()));
    const auto pattern = samples ? StandardPattern(*samples) : std::nullopt;
    if (pattern) return *pattern;
  }
  throw value.Error(Quoted(value.text()) + " is not a standard pattern",
                    "write standard-1, -2, -4, -8 or -16, or a list of [x, y]");
}

}  // namespace

double PlaceInPixel(const JsonValue& value, const std::string& what) {
  const std::optional<double> fraction =
      value.kind() == JsonKind::kString ? Fraction(value.text()) : std::nullopt;
  const double x = fraction ? *fraction : CoordinateFromJson(value, Precision::kFloat64);
  if (!(x >= 0 && x < 1) || x * 256 != std::floor(x * 256)) {
    throw value.Error("is not " + what, "write a multiple of 1/256, at least 0 and below 1");
  }
  return x;
}

SamplePattern PatternFromJson(const JsonValue& value) {
  if (value.kind() == JsonKind::kString) return StandardPatternFromJson(value);
  std::vector<Point2> locations;
  const JsonValue::Items items = value.RequireArray();
  const std::size_t size = items.size();
  if (size < 1 || size > std::size_t{kMaxSamplesPerPixel}) {
    throw value.Error("has " + std::to_string(size) + " sample locations",
                      "write from 1 to " + std::to_string(kMaxSamplesPerPixel));
  }
  for (const JsonValue item : items) {
    const JsonValue::Items pair = item.RequireArray();
    if (pair.size() != 2) {
      throw item.Error("has " + std::to_string(pair.size()) + " coordinates", "write [x, y]");
    }
    JsonValue::Iterator coordinate = pair.begin();
    const double x = PlaceInPixel(*coordinate, "a sample location");
    locations.push_back({x, PlaceInPixel(*++coordinate, "a sample location")});
  }
  return {std::move(locations)};
}

void WriteNumbers(JsonWriter& json, std::initializer_list<double> numbers) {
  json.BeginArray(kOneLine);
  for (const double x : numbers) json.Exact(x);
  json.EndArray();
}

void WritePattern(JsonWriter& json, const SamplePattern& pattern) {
  json.BeginArray(kOneLine);
  for (const Point2& l : pattern.locations) WriteNumbers(json, {l.x, l.y});
  json.EndArray();
}

}  // namespace rasterproof::io
