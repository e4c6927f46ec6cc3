// Rasterizers in shared libraries, through the C interface of kit/rasterproof_plugin.h.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_

#include <memory>
#include <string>

#include "core/subject.h"

namespace rasterproof::subjects {

/// A library loaded into this process, and what it says of itself.
struct LoadedPlugin {
  std::unique_ptr<Subject> subject;  ///< its info lacks the profile
  std::string profile;               ///< a preset's name, or the text of a profile file
};

/// Loads a library. What it does wrong it does to this process: `pipe answer` is a process for it
/// alone (tool/outside.h). Its rounding mode and the like are its own (environment.h).
///
/// The subject draws into guarded memory: a write outside the target, or between its rows, is a
/// breakdown that says where, or a crash where it goes farther than a page.
///
/// Error:      InputError if the file is no such library, or of a version that this one does not
///             know.
LoadedPlugin LoadPlugin(const std::string& path);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_
