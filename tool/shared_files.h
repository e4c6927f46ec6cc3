// Files that lie beside the command: scene sets, records of proofs.
#ifndef RASTERPROOF_TOOL_SHARED_FILES_H_
#define RASTERPROOF_TOOL_SHARED_FILES_H_

#include <optional>
#include <string>
#include <vector>

namespace rasterproof::tool {

/// Folders in which files of the command's own may lie, nearest first: the program's own folder and
/// the two above it, each itself and its share/rasterproof.
std::vector<std::string> SharedFolders();

/// The first of them that holds the file, as a path to open: relative to the working folder if it
/// lies in it.
///
/// Returns:    nothing if none does.
std::optional<std::string> FindShared(const std::string& file);

/// The scene set that is certified where none is named.
inline constexpr const char* kSceneSet = "scenes/certify.json";

/// The file that a path on a command line means: the one of that path, or where there is none the
/// one of FindShared(). So "scenes/ties.json" means the same in every folder.
std::string Located(const std::string& path);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SHARED_FILES_H_
