// Rasterizers in shared libraries, through the C interface of kit/rasterproof_plugin.h.
#ifndef RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_
#define RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_

#include <memory>
#include <string>

#include "core/subject.h"

namespace rasterproof::subjects {

/// A library loaded into this process, with its own description.
struct LoadedPlugin {
  std::unique_ptr<Subject> subject;  ///< its info lacks the profile
  std::string profile;               ///< a preset's name, or the text of a profile file
};

/// Loads a library into this process, which its faults can bring down. To isolate it, run it in the
/// process `pipe answer` (tool/outside.h). Its floating-point environment is kept apart
/// (environment.h).
///
/// The subject draws into guarded memory: a write outside the target, or between its rows, is a
/// breakdown that says where, or a crash where it goes farther than a page.
///
/// Error:      InputError if the file is not such a library, or has an unknown version.
LoadedPlugin LoadPlugin(const std::string& path);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PLUGIN_PLUGIN_H_
