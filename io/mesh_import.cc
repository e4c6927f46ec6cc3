#include "io/mesh_import.h"

#include <assimp/cimport.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "io/mesh_source.h"

namespace rasterproof::io {
namespace {

using Position = std::array<float, 3>;

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
      AddFacingDraw(*scene.mMeshes[k], transform);
    }
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
      AddNode(scene, *child, transform);
    }
  }

 private:
  void AddFacingDraw(const aiMesh& part, const Transform& transform) {
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

// The importer (assimp 5.2.5) never returns from a PLY header that has no end.
void RequireEndOfPlyHeader(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    if (std::string_view(line).starts_with("end_header")) return;
  }
  throw InputError(path, "can't be read as a mesh: its header has no end",
                   "check that the file is complete and matches its extension");
}

// A line with a word on it, comments and empty lines passed over; none at the end of the file.
std::istringstream NextLine(std::istream& file) {
  for (std::string line; std::getline(file, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") != line.npos) return std::istringstream(line);
  }
  return {};
}

// The importer takes the digits of a vertex's number: with a sign it reads 0, and 2^32 is 0, too.
void RequireIndicesOfOff(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::istringstream counts = NextLine(file);
  std::string format;
  if (!(counts >> format >> std::ws) || counts.eof()) counts = NextLine(file);
  std::uint64_t vertices = 0;
  counts >> vertices;
  for (std::uint64_t k = 0; k < vertices && file; ++k) NextLine(file);
  constexpr std::size_t kMostDigits = 9;
  while (file) {
    std::istringstream face = NextLine(file);
    std::uint64_t corners = 0;
    face >> corners;
    for (std::string corner; corners > 0 && face >> corner; --corners) {
      const bool is_index =
          corner.size() <= kMostDigits && corner.find_first_not_of("0123456789") == corner.npos;
      if (is_index) continue;
      throw InputError(
          path, "has a face that names vertex " + Quoted(corner, 40) + ", which is not there",
          "repair the mesh");
    }
  }
}

// The library's functions.
struct Importer {
  decltype(&aiImportFileEx) import = nullptr;
  decltype(&aiReleaseImport) release = nullptr;
  decltype(&aiGetErrorString) error = nullptr;
  decltype(&aiAttachLogStream) attach = nullptr;
  decltype(&aiDetachLogStream) detach = nullptr;
};

template <class Function>
void Find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) {
    throw InputError(RASTERPROOF_ASSIMP, std::string("has no function ") + name,
                     "install assimp 5");
  }
}

Importer Load() {
  void* const library = dlopen(RASTERPROOF_ASSIMP, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw InputError(RASTERPROOF_ASSIMP, std::string("can't be loaded (") + dlerror() + ")",
                     "meshes are read by assimp 5: install package libassimp5");
  }
  Importer importer;
  Find(library, "aiImportFileEx", importer.import);
  Find(library, "aiReleaseImport", importer.release);
  Find(library, "aiGetErrorString", importer.error);
  Find(library, "aiAttachLogStream", importer.attach);
  Find(library, "aiDetachLogStream", importer.detach);
  return importer;
}

const Importer& Loaded() {
  static const Importer importer = Load();
  return importer;
}

// The importer takes another vertex for one that is not there, or drops the face, and only logs it.
class IndexComplaints {
 public:
  IndexComplaints() { Loaded().attach(&log_); }
  IndexComplaints(const IndexComplaints&) = delete;
  IndexComplaints& operator=(const IndexComplaints&) = delete;
  ~IndexComplaints() { Loaded().detach(&log_); }

  void RequireNone(const std::string& path) const {
    if (!said_) return;
    throw InputError(path, "has a face that names a missing vertex", "repair the mesh");
  }

 private:
  static void Hear(const char* message, char* said) {
    const std::string_view text(message);
    const bool says =
        text.find("out of range") != text.npos || text.find("out-of-range") != text.npos;
    if (says) *reinterpret_cast<bool*>(said) = true;
  }
  bool said_ = false;
  aiLogStream log_{Hear, reinterpret_cast<char*>(&said_)};
};

}  // namespace

void LoadMeshImporter() { Loaded(); }

Mesh ImportMesh(const std::string& path) {
  if (path.ends_with(".ply") || path.ends_with(".PLY")) RequireEndOfPlyHeader(path);
  if (path.ends_with(".off") || path.ends_with(".OFF")) RequireIndicesOfOff(path);
  const Importer& importer = Loaded();
  const IndexComplaints complaints;
  aiFileIO source = MeshSource();
  // None of the importer's own steps: joining moves vertices by up to 1e-5, and triangulation
  // aborts the program on files that are cut short. With nothing asked of it, it only parses.
  const std::unique_ptr<const aiScene, decltype(&aiReleaseImport)> scene(
      importer.import(path.c_str(), 0, &source), importer.release);
  // The importer turns every exception into its message.
  if (std::string_view(importer.error()) == "std::bad_alloc") throw std::bad_alloc();
  complaints.RequireNone(path);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(path, "can't be read as a mesh (" + Printable(importer.error()) + ")",
                     "check that the file is complete and matches its extension");
  }
  Mesh mesh;
  Welder(path, mesh).AddNode(*scene, *scene->mRootNode, Transform{});
  if (mesh.triangles.empty()) {
    throw InputError(path, "has no triangles", "give a mesh with faces");
  }
  return mesh;
}

}  // namespace rasterproof::io
