// A profile's `coverage`: its statement about pixels as squares.
#ifndef RASTERPROOF_IO_SQUARE_JSON_H_
#define RASTERPROOF_IO_SQUARE_JSON_H_

#include <string>

#include "core/square_rule.h"
#include "io/json_document.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// Error:      InputError with place, reason and remedy.
SquareRule SquareRuleFromJson(const JsonValue& value);

void WriteSquareRule(JsonWriter& json, const SquareRule& rule);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SQUARE_JSON_H_
