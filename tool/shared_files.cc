#include "tool/shared_files.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace rasterproof::tool {
namespace {

namespace fs = std::filesystem;

// What a reader can type again where the command was typed.
std::string AsTyped(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::canonical(path, failed);
  if (failed) return path.string();
  const fs::path near = fs::relative(whole, failed);
  const bool inside = !failed && !near.empty() && *near.begin() != "..";
  return (inside ? near : whole).string();
}

}  // namespace

std::vector<std::string> SharedFolders() {
  std::vector<std::string> folders;
  std::error_code failed;
  fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  if (failed) return folders;
  constexpr int kFoldersAbove = 2;  // a build tree has programs in build/ and in build/examples/
  for (int above = 0; above <= kFoldersAbove && folder.has_relative_path(); ++above) {
    folders.push_back(folder.string());
    folders.push_back((folder / "share/rasterproof").string());
    folder = folder.parent_path();
  }
  return folders;
}

std::optional<std::string> FindShared(const std::string& file) {
  for (const std::string& folder : SharedFolders()) {
    const fs::path path = fs::path(folder) / file;
    std::error_code failed;
    if (fs::is_regular_file(path, failed)) return AsTyped(path);
  }
  return std::nullopt;
}

std::string Located(const std::string& path) {
  std::error_code failed;
  if (path == "-" || fs::path(path).is_absolute() || fs::exists(path, failed)) return path;
  return FindShared(path).value_or(path);
}

}  // namespace rasterproof::tool
