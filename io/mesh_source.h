// The files that the mesh importer may open.
#ifndef RASTERPROOF_IO_MESH_SOURCE_H_
#define RASTERPROOF_IO_MESH_SOURCE_H_

#include <assimp/DefaultIOSystem.h>

#include <assimp/IOStream.hpp>

namespace rasterproof::io {

/// Opens regular files alone: a mesh may name others, as a glTF its buffers, and a pipe among them
/// would be waited for without end. Of an OBJ it shows what has a place: its groups, objects and
/// materials give no triangle, and the importer (assimp 5.2.5) looks through all of them for each.
class MeshSource final : public Assimp::DefaultIOSystem {
 public:
  /// Whether there is a regular file.
  bool Exists(const char* path) const override;
  /// nullptr for a file that is not there, or not regular.
  Assimp::IOStream* Open(const char* path, const char* mode) override;
};

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_MESH_SOURCE_H_
