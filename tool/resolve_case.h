// Resolves names of properties, worlds and cases, once. A wrong name is an error before anything
// runs.
#ifndef RASTERPROOF_TOOL_RESOLVE_CASE_H_
#define RASTERPROOF_TOOL_RESOLVE_CASE_H_

#include <optional>
#include <string>

#include "core/case.h"
#include "core/subject.h"
#include "props/domains/case_name.h"
#include "props/domains/worlds.h"
#include "props/property.h"

namespace rasterproof::tool {

/// Error:      InputError naming the properties there are.
const props::Property& RequireProperty(const std::string& name);

/// Error:      InputError at the place, with the world that may be meant.
const props::World& RequireWorld(const std::string& place, const std::string& name);

/// Reads the name of a drawn case, "near-edge:17@1".
///
/// Error:      InputError that says what is wrong with it, with the domain that may be meant.
CaseName RequireCaseName(const std::string& name);

/// A case that the user names: by its file, which is read, or by its own name, which stands for a
/// case together with a subject.
struct GivenCase {
  std::string place;  ///< as the user gave it
  Case value;
  std::optional<CaseName> name;
  bool states_profile = false;  ///< its file says by what model it was judged
};

/// The given case as it is put to the subject: judged by the subject's profile.
///
/// Error:      InputError if the subject does not take its scene.
Case CaseFor(const Subject& subject, const GivenCase& given);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_RESOLVE_CASE_H_
