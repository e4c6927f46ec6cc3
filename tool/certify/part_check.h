// Whether what a part of a campaign says can be so: looked at as a whole before any of it counts.
#ifndef RASTERPROOF_TOOL_CERTIFY_PART_CHECK_H_
#define RASTERPROOF_TOOL_CERTIFY_PART_CHECK_H_

#include "core/subject_info.h"
#include "tool/certify/part_file.h"

namespace rasterproof::tool {

/// Looks at every number of the part's tests: cases, counts, domains, how it ended and what failed.
///
/// Domain:     a part whose properties and worlds this program has.
/// Error:      InputError naming the file, the test and what contradicts what.
void RequireSound(const SubjectPart& part, const SubjectInfo& info);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CERTIFY_PART_CHECK_H_
