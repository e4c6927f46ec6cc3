// The files that the mesh importer may open.
#ifndef RASTERPROOF_IO_MESH_SOURCE_H_
#define RASTERPROOF_IO_MESH_SOURCE_H_

#include <assimp/cfileio.h>

namespace rasterproof::io {

/// Opens regular files alone, to be read: a mesh may name other files, as a glTF names its buffers,
/// and reading a pipe would never end. It hides the groups, objects and materials of an OBJ: they
/// give no triangle, and for each of them the importer (assimp 5.2.5) looks through all of them.
aiFileIO MeshSource();

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_MESH_SOURCE_H_
