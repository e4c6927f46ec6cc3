#include "io/mesh.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <vector>

#include "core/error.h"

namespace rasterproof::io {
namespace {

using Position = std::array<float, 3>;

constexpr std::array<std::string_view, 6> kExtensions{".obj", ".ply",  ".off",
                                                      ".stl", ".gltf", ".glb"};

// The bits of a position: what vertices are welded by.
struct HashOfBits {
  std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t b : bits) hash = (hash ^ b) * 0x9E3779B97F4A7C15U;  // golden ratio
    return static_cast<std::size_t>(hash ^ hash >> 32U);
  }
};

// An affine map. Products of the file's float32 matrices are formed in double, so that a vertex is
// rounded once.
struct Transform {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  Transform operator*(const aiMatrix4x4& m) const {
    Transform product;
    for (std::size_t i = 0; i < 3; ++i) {
      for (unsigned j = 0; j < 4; ++j) {
        double sum = j == 3 ? rows[i][3] : 0;
        for (unsigned k = 0; k < 3; ++k) sum += rows[i][k] * double{m[k][j]};
        product.rows[i][j] = sum;
      }
    }
    return product;
  }
  bool IsIdentity() const { return rows == Transform{}.rows; }
  Position operator()(const aiVector3D& v) const {
    if (IsIdentity()) return {v.x, v.y, v.z};  // 0 * y would turn -0 into 0
    Position p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<double, 4>& r = rows[i];
      p[i] =
          static_cast<float>(r[0] * double{v.x} + r[1] * double{v.y} + r[2] * double{v.z} + r[3]);
    }
    return p;
  }
};

// Collects triangles, one vertex for each position.
class Welder {
 public:
  Welder(const std::string& path, Mesh& mesh) : path_(path), mesh_(mesh) {}

  void AddNode(const aiScene& scene, const aiNode& node, const Transform& parent) {
    const Transform transform = parent * node.mTransformation;
    for (const unsigned k : std::span(node.mMeshes, node.mNumMeshes)) {
      AddPart(*scene.mMeshes[k], transform);
    }
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
      AddNode(scene, *child, transform);
    }
  }

 private:
  void AddPart(const aiMesh& part, const Transform& transform) {
    for (const aiFace& face : std::span(part.mFaces, part.mNumFaces)) {
      // Points and lines, with fewer corners, cover nothing.
      for (unsigned k = 2; k < face.mNumIndices; ++k) {
        Triangle triangle{};
        const std::array<unsigned, 3> corners{0, k - 1, k};
        std::ranges::transform(corners, triangle.begin(), [&](unsigned corner) {
          return IndexOf(transform(VertexOf(part, face.mIndices[corner])));
        });
        mesh_.triangles.push_back(triangle);
      }
    }
  }

  const aiVector3D& VertexOf(const aiMesh& part, unsigned index) const {
    if (index < part.mNumVertices) return part.mVertices[index];
    throw Fault("names vertex " + std::to_string(index) + ", which is not there");
  }

  std::int32_t IndexOf(const Position& p) {
    const auto next = static_cast<std::int32_t>(mesh_.vertices.size());
    const auto [entry, is_new] =
        index_.try_emplace(std::bit_cast<std::array<std::uint32_t, 3>>(p), next);
    if (is_new) {
      RequireFinite(p);
      mesh_.vertices.push_back(p);
    }
    return entry->second;
  }

  void RequireFinite(const Position& p) const {
    if (std::ranges::all_of(p, [](float x) { return std::isfinite(x); })) return;
    throw Fault("has a vertex that is not finite");
  }

  InputError Fault(const std::string& reason) const {
    return {path_ + ": triangle " + std::to_string(mesh_.triangles.size()), reason,
            "repair the mesh"};
  }

  const std::string& path_;
  Mesh& mesh_;
  std::unordered_map<std::array<std::uint32_t, 3>, std::int32_t, HashOfBits> index_;
};

// Returns the extension in lower case.
std::string RequireKnownFormat(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::find(kExtensions, extension) == kExtensions.end()) {
    throw InputError(path, "is not a mesh by its name", "give .obj, .ply, .off, .stl, .gltf, .glb");
  }
  return extension;
}

// The importer (assimp 5.2.5) never returns from a PLY header that has no end.
void RequireEndOfPlyHeader(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    if (std::string_view(line).starts_with("end_header")) return;
  }
  throw InputError(path, "can't be read as a mesh: its header has no end",
                   "check that the file is complete and of the format that its ending names");
}

}  // namespace

Mesh ReadMesh(const std::string& path) {
  const std::string extension = RequireKnownFormat(path);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(path, error ? "can't be read (" + error.message() + ")" : "is not a file",
                     "give a readable file");
  }
  if (extension == ".ply") RequireEndOfPlyHeader(path);
  Assimp::Importer importer;
  // None of the importer's own steps: joining moves vertices by up to 1e-5, and triangulation
  // aborts the program on files that are cut short. With nothing asked of it, it only parses.
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(path,
                     "can't be read as a mesh (" + std::string(importer.GetErrorString()) + ")",
                     "check that the file is complete and of the format that its ending names");
  }
  Mesh mesh;
  mesh.name = std::filesystem::path(path).stem().string();
  Welder(path, mesh).AddNode(*scene, *scene->mRootNode, Transform{});
  if (mesh.triangles.empty()) {
    throw InputError(path, "has no triangles", "give a mesh with faces");
  }
  return mesh;
}

}  // namespace rasterproof::io
