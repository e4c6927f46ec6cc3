// The files that the mesh importer may open.
#ifndef RASTERPROOF_IO_MESH_SOURCE_H_
#define RASTERPROOF_IO_MESH_SOURCE_H_

#include <assimp/DefaultIOSystem.h>

#include <assimp/IOStream.hpp>

namespace rasterproof::io {

/// Opens regular files alone: a mesh may name other files, as a glTF names its buffers, and reading
/// a pipe would never end. It hides the groups, objects and materials of an OBJ: they give no
/// triangle, and for each of them the importer (assimp 5.2.5) looks through all of them.
class MeshSource final : public Assimp::DefaultIOSystem {
 public:
  /// Whether there is a regular file.
  bool Exists(const char* path) const override;
  /// nullptr if the file does not exist or is not regular.
  Assimp::IOStream* Open(const char* path, const char* mode) override;
};

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_MESH_SOURCE_H_
