// Resolves what `check` is asked for, once: a wrong name is an error before anything runs.
#ifndef RASTERPROOF_TOOL_CHECK_RESOLVE_CHECK_H_
#define RASTERPROOF_TOOL_CHECK_RESOLVE_CHECK_H_

#include <map>
#include <string>
#include <vector>

#include "props/property.h"
#include "tool/check/cmd_check.h"
#include "tool/known_failures.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"

namespace rasterproof::tool {

/// What `check` was asked.
struct ResolvedCheck {
  std::vector<SubjectFactory> subjects;
  std::vector<const props::Property*> properties;
  bool is_whole_catalogue = false;
  std::vector<GivenCase> cases;  ///< none: generated ones
  /// Failures that were saved, by the property that each is about: asked before generated cases.
  std::multimap<std::string, GivenCase> saved;
  std::vector<KnownFailure> known;  ///< failures that fail nothing
};

/// Error:      InputError with the place and the remedy, for the first thing that is not there.
ResolvedCheck ResolveCheck(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_RESOLVE_CHECK_H_
