// The key "specification" of a profile: a legal set, and a device's numbers in it.
#ifndef RASTERPROOF_IO_SPECIFICATION_JSON_H_
#define RASTERPROOF_IO_SPECIFICATION_JSON_H_

#include "core/profile.h"
#include "io/json_document.h"

namespace rasterproof::io {

/// Returns the base that a profile's keys override: the legal set that "specification" names, or
/// Profile{}.
///
/// Error:      InputError if it names none.
Profile BeginningOf(const JsonValue& value);

/// Error:      InputError if a key changes a value that the specification does not leave open.
void RequireWithinItsSpecification(const JsonValue& value, const Profile& profile);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SPECIFICATION_JSON_H_
