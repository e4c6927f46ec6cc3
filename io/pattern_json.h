// Sample patterns, and lists of numbers, as JSON values.
#ifndef RASTERPROOF_IO_PATTERN_JSON_H_
#define RASTERPROOF_IO_PATTERN_JSON_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "core/sample_pattern.h"
#include "core/scene.h"
#include "io/json_document.h"
#include "io/json_writer.h"
#include "io/scene_json.h"

namespace rasterproof::io {

/// A place within a pixel, on multiples of 2^-8: a number, or a fraction in quotes ("3/8"). `what`
/// completes "is not ...".
double PlaceInPixel(const JsonValue& value, const std::string& what);

/// "standard-4" (1, 2, 4, 8, 16), or a list of pairs, up to 64.
///
/// Error:      InputError with place, reason and remedy; here and above.
SamplePattern PatternFromJson(const JsonValue& value);

/// The list of pairs.
void WritePattern(JsonWriter& json, const SamplePattern& pattern);

/// Returns the numbers of an array, as many as `names` says: "[x0, y0, x1, y1]".
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

/// "[x, y]", exact.
void WriteNumbers(JsonWriter& json, std::initializer_list<double> numbers);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_PATTERN_JSON_H_
