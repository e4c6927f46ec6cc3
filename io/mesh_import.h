// Parses mesh files; runs in the child process.
#ifndef RASTERPROOF_IO_MESH_IMPORT_H_
#define RASTERPROOF_IO_MESH_IMPORT_H_

#include <string>

#include "io/mesh.h"

namespace rasterproof::io {

/// Loads the library that parses, unless it is loaded: before the first mesh, and not with the
/// command, whose start it makes twice as long.
///
/// Error:      InputError if it is not installed.
void LoadMeshImporter();

/// As ReadMesh, in this process: the library that parses may crash, or take all time and memory.
Mesh ImportMesh(const std::string& path);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_MESH_IMPORT_H_
