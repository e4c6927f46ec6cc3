// Who asks for a property, in words: what every output says alike.
#ifndef RASTERPROOF_REPORT_GROUNDS_H_
#define RASTERPROOF_REPORT_GROUNDS_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "core/result.h"
#include "io/json_writer.h"
#include "report/certificate.h"

namespace rasterproof::report {

/// "required by vulkan.common-edge, vulkan.point-sampling", "by the stated model", or "quality: no
/// clause requires it".
std::string AuthorityText(const PropertyResult& result);

/// The readings that verdicts under the profile rest on and that no sentence of its specification
/// settles: the clause, and the reading. Empty for models and for users' own profiles.
std::vector<Evidence> AssumptionsUnder(const Profile& profile);
/// The same as lines of text: "assumed          vulkan.one-position: Polygons that ...".
std::string AssumptionLines(const Profile& profile);

/// What was not asked, in one line: "depths in clip space (no property judges them); targets above
/// 65536 samples".
std::string NotAskedText(const std::vector<Evidence>& list);

/// Writes a member of an object: [{"statement": "vulkan.one-position", "by": "Triangles ..."}].
void WriteEvidence(io::JsonWriter& json, std::string_view key, const std::vector<Evidence>& list);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_GROUNDS_H_
