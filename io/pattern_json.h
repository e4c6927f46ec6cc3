// Sample patterns as JSON values.
#ifndef RASTERPROOF_IO_PATTERN_JSON_H_
#define RASTERPROOF_IO_PATTERN_JSON_H_

#include <initializer_list>
#include <string>

#include "core/sample_pattern.h"
#include "io/json_document.h"
#include "io/json_writer.h"

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

/// "[x, y]", exact.
void WriteNumbers(JsonWriter& json, std::initializer_list<double> numbers);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_PATTERN_JSON_H_
