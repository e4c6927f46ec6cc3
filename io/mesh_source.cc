#include "io/mesh_source.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "io/output.h"

namespace rasterproof::io {
namespace {

// The first line with its end. One that ends with a backslash goes on.
std::string_view FirstLine(std::string_view text) {
  for (std::size_t begin = 0;;) {
    std::size_t end = text.find_first_of("\r\n", begin);
    if (end == text.npos) return text;
    const bool goes_on = end > 0 && text[end - 1] == '\\';
    if (text.substr(end, 2) == "\r\n") ++end;
    if (!goes_on) return text.substr(0, end + 1);
    begin = end + 1;
  }
}

// Returns whether a line of an OBJ only names the faces that follow, or sets their looks.
bool NamesFaces(std::string_view line) {
  constexpr std::array<std::string_view, 6> kWords{"g", "o", "s", "mg", "usemtl", "mtllib"};
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t\r\n", begin), line.size());
  return std::ranges::find(kWords, line.substr(begin, end - begin)) != kWords.end();
}

std::string OnlyGeometry(std::string_view obj) {
  std::string geometry;
  geometry.reserve(obj.size());
  while (!obj.empty()) {
    const std::string_view line = FirstLine(obj);
    if (!NamesFaces(line)) geometry += line;
    obj.remove_prefix(line.size());
  }
  return geometry;
}

Assimp::IOStream* StreamOf(std::string_view content) {
  auto bytes = std::make_unique<std::uint8_t[]>(content.size());
  std::ranges::copy(content, bytes.get());
  return new Assimp::MemoryIOStream(bytes.release(), content.size(), true);
}

}  // namespace

bool MeshSource::Exists(const char* path) const {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

Assimp::IOStream* MeshSource::Open(const char* path, const char* mode) {
  if (!Exists(path)) return nullptr;
  const std::string_view name(path);
  if (!name.ends_with(".obj") && !name.ends_with(".OBJ")) return DefaultIOSystem::Open(path, mode);
  return StreamOf(OnlyGeometry(ReadFile(path)));
}

}  // namespace rasterproof::io
