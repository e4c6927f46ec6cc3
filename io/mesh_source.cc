#include "io/mesh_source.h"

#include <assimp/types.h>

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

// A file, whole in memory. The importer knows its first part.
struct OpenFile : aiFile {
  std::string content;
  std::size_t position = 0;
};

OpenFile& Of(aiFile* file) { return *static_cast<OpenFile*>(file); }

// As fread: whole items alone.
std::size_t Read(aiFile* file, char* into, std::size_t size, std::size_t count) {
  OpenFile& from = Of(file);
  if (size == 0) return 0;
  const std::size_t items = std::min(count, (from.content.size() - from.position) / size);
  std::copy_n(from.content.data() + from.position, items * size, into);
  from.position += items * size;
  return items;
}

std::size_t Write(aiFile* /*file*/, const char* /*from*/, std::size_t /*size*/,
                  std::size_t /*count*/) {
  return 0;
}

std::size_t Tell(aiFile* file) { return Of(file).position; }

std::size_t SizeOf(aiFile* file) { return Of(file).content.size(); }

// From the end the importer gives an offset as an unsigned number, and means it backwards.
aiReturn Seek(aiFile* file, std::size_t offset, aiOrigin origin) {
  OpenFile& of = Of(file);
  std::size_t position = offset;
  if (origin == aiOrigin_CUR) position += of.position;
  if (origin == aiOrigin_END) position = of.content.size() - offset;
  if (position > of.content.size()) return aiReturn_FAILURE;
  of.position = position;
  return aiReturn_SUCCESS;
}

void Flush(aiFile* /*file*/) {}

bool IsRegular(const char* path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

aiFile* Open(aiFileIO* /*files*/, const char* path, const char* mode) {
  if (std::string_view(mode).find_first_of("wa+") != std::string_view::npos) return nullptr;
  if (!IsRegular(path)) return nullptr;
  const std::string_view name(path);
  const bool is_obj = name.ends_with(".obj") || name.ends_with(".OBJ");
  auto file = std::make_unique<OpenFile>();
  file->content = is_obj ? OnlyGeometry(ReadFile(path)) : ReadFile(path);
  file->ReadProc = Read;
  file->WriteProc = Write;
  file->TellProc = Tell;
  file->FileSizeProc = SizeOf;
  file->SeekProc = Seek;
  file->FlushProc = Flush;
  return file.release();
}

void Close(aiFileIO* /*files*/, aiFile* file) { delete &Of(file); }

}  // namespace

aiFileIO MeshSource() { return {Open, Close, nullptr}; }

}  // namespace rasterproof::io
