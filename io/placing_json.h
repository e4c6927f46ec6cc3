// The profile keys `fixed`, `scanline_rounding` and `transform`: how vertices come to their places.
#ifndef RASTERPROOF_IO_PLACING_JSON_H_
#define RASTERPROOF_IO_PLACING_JSON_H_

#include "core/fixed_input.h"
#include "core/snap.h"
#include "core/transform.h"
#include "io/json_document.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// Errors:     InputError with place, reason and remedy, as of all these readers.
FixedInput FixedInputFromJson(const JsonValue& value);
void WriteFixed(JsonWriter& json, const FixedInput& fixed);

/// Returns Snap::kNone's for null.
Snap ScanlineRoundingFromJson(const JsonValue& value);
void WriteScanlineRounding(JsonWriter& json, const Snap& rounding);

Transform TransformFromJson(const JsonValue& value);
void WriteTransform(JsonWriter& json, const Transform& transform);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_PLACING_JSON_H_
