#include "io/mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "io/limited_child.h"
#include "io/mesh_import.h"

namespace rasterproof::io {
namespace {

constexpr std::array<std::string_view, 6> kExtensions{".obj", ".ply",  ".off",
                                                      ".stl", ".gltf", ".glb"};

void RequireKnownFormat(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::find(kExtensions, extension) != kExtensions.end()) return;
  throw InputError(path, "has no name of a mesh", "give .obj, .ply, .off, .stl, .gltf, .glb");
}

std::uint64_t RequireRegularFile(const std::string& path) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(path, error);
  const std::uint64_t size = is_file ? std::filesystem::file_size(path, error) : 0;
  if (is_file && !error) return size;
  throw InputError(path, error ? "can't be read (" + error.message() + ")" : "is not a file",
                   "give a readable file");
}

// Returns a few times what reading a sound mesh of this size takes.
ChildLimits LimitsOf(std::uint64_t size) {
  return {.bytes = (std::uint64_t{512} << 20) + 64 * size, .seconds = 5 + (size >> 21)};
}

// A mesh as it goes through a pipe: two counts, vertices, triangles.
using Counts = std::array<std::uint64_t, 2>;

std::string BytesOf(const Mesh& mesh) {
  const Counts counts{mesh.vertices.size(), mesh.triangles.size()};
  const std::size_t of_vertices = mesh.vertices.size() * sizeof mesh.vertices[0];
  const std::size_t of_triangles = mesh.triangles.size() * sizeof mesh.triangles[0];
  std::string bytes(sizeof counts + of_vertices + of_triangles, '\0');
  std::memcpy(bytes.data(), &counts, sizeof counts);
  std::memcpy(bytes.data() + sizeof counts, mesh.vertices.data(), of_vertices);
  std::memcpy(bytes.data() + sizeof counts + of_vertices, mesh.triangles.data(), of_triangles);
  return bytes;
}

template <class T>
std::vector<T> Take(std::string_view& bytes, std::uint64_t count, const InputError& fault) {
  if (count > bytes.size() / sizeof(T)) throw fault;
  std::vector<T> values(count);
  std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

Mesh MeshFrom(std::string_view bytes, const std::string& path) {
  const InputError fault(path, "arrived damaged from the process that read it",
                         "check that the file is complete and well-formed");
  const auto counts = Take<std::uint64_t>(bytes, Counts{}.size(), fault);
  Mesh mesh;
  mesh.name = std::filesystem::path(path).stem().string();
  mesh.vertices = Take<std::array<float, 3>>(bytes, counts[0], fault);
  mesh.triangles = Take<Triangle>(bytes, counts[1], fault);
  const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t index : triangle) {
      if (index < 0 || index >= vertices) throw fault;
    }
  }
  if (!bytes.empty()) throw fault;
  return mesh;
}

}  // namespace

Mesh ReadMesh(const std::string& path) {
  RequireKnownFormat(path);
  const ChildLimits limits = LimitsOf(RequireRegularFile(path));
  LoadMeshImporter();  // here, where no thread of this process can hold a lock that a fork keeps
  return MeshFrom(MakeInChild(limits, path, [&] { return BytesOf(ImportMesh(path)); }), path);
}

}  // namespace rasterproof::io
